#include "model/geometry/ray_tracer.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <embree3/rtcore.h>
#include <limits>
#include <map>

#include "model/scene/mesh.h"
#include "model/scene/triangles.h"

namespace model {

namespace {

double dot(const Vector3& a, const Vector3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Vector3 unit(const Vector3& v) {
  const double length = std::sqrt(dot(v, v));
  return {v[0] / length, v[1] / length, v[2] / length};
}

/// An object with what every hit on it needs, worked out once.
struct Surface {
  Shape shape;
  Vector3 position_m;
  Vector3 velocity_m_s;
  std::array<Vector3, 3> rotation;
  bool faceted = false;

  [[nodiscard]] Vector3 localOf(const Vector3& v) const {  // a direction; transposed rotation
    Vector3 local{};
    for (std::size_t i = 0; i < 3; ++i)
      local[i] = rotation[0][i] * v[0] + rotation[1][i] * v[1] + rotation[2][i] * v[2];
    return local;
  }
};

/// Range and local normal of unit length.
struct Meeting {
  double range_m;
  Vector3 normal;
};

/// Face at local coordinate `at` along one axis, seen from the ray o + t d.
Meeting meetFace(const Vector3& o, const Vector3& d, std::size_t axis, double at, double otherwise_m) {
  Meeting met{d[axis] != 0.0 ? (at - o[axis]) / d[axis] : otherwise_m, {}};
  met.normal[axis] = 1.0;
  return met;
}

/// The root of t² a + 2 t b + c = 0 nearest to where Embree met the facet.
double nearestRoot(double a, double b, double c, double near_m) {
  const double root = std::sqrt(std::max(0.0, b * b - a * c));
  const double first = (-b - root) / a, second = (-b + root) / a;
  return std::abs(first - near_m) < std::abs(second - near_m) ? first : second;
}

Vector3 scaled(const Vector3& v, double factor) { return {factor * v[0], factor * v[1], factor * v[2]}; }

/// Embree works in single precision and on facets; it says which surface was met and about where. The shape's own
/// equation then gives range and normal exactly; meshes are their facets. All in the shape's frame.
Meeting meetLocally(const Shape& shape, const Vector3& o, const Vector3& d, double near_m, const Vector3& facet) {
  if (std::holds_alternative<Rectangle>(shape)) return meetFace(o, d, 0, 0.0, near_m);
  if (std::holds_alternative<Plane>(shape)) return meetFace(o, d, 2, 0.0, near_m);
  if (const auto* box = std::get_if<Box>(&shape)) {
    std::size_t axis = 0;
    for (std::size_t k = 1; k < 3; ++k) axis = std::abs(facet[k]) > std::abs(facet[axis]) ? k : axis;
    return meetFace(o, d, axis, std::copysign(box->size_m[axis] / 2.0, o[axis] + near_m * d[axis]), near_m);
  }
  if (const auto* sphere = std::get_if<Sphere>(&shape)) {
    const double t = nearestRoot(1.0, dot(o, d), dot(o, o) - sphere->radius_m * sphere->radius_m, near_m);
    return {t, scaled({o[0] + t * d[0], o[1] + t * d[1], o[2] + t * d[2]}, 1.0 / sphere->radius_m)};
  }
  if (const auto* cylinder = std::get_if<Cylinder>(&shape)) {
    if (std::abs(facet[2]) > 0.5) {  // a lid
      return meetFace(o, d, 2, std::copysign(cylinder->height_m / 2.0, o[2] + near_m * d[2]), near_m);
    }
    const double across = d[0] * d[0] + d[1] * d[1], along = o[0] * d[0] + o[1] * d[1];
    const double t =
        nearestRoot(across, along, o[0] * o[0] + o[1] * o[1] - cylinder->radius_m * cylinder->radius_m, near_m);
    return {t, scaled({o[0] + t * d[0], o[1] + t * d[1], 0.0}, 1.0 / cylinder->radius_m)};
  }
  return {near_m, facet};
}

RayHit meetExactly(const Surface& surface, const Ray& ray, double near_m, const Vector3& facet_normal) {
  Vector3 from{};
  for (std::size_t k = 0; k < 3; ++k) {
    from[k] = ray.origin_m[k] - (surface.position_m[k] + ray.scene_time_s * surface.velocity_m_s[k]);
  }
  const Vector3 d = surface.localOf(ray.direction);
  const Meeting met = meetLocally(surface.shape, surface.localOf(from), d, near_m, surface.localOf(facet_normal));
  RayHit hit{.range_m = met.range_m, .cos_incidence = std::min(1.0, std::abs(dot(met.normal, d))), .object = 0};
  for (std::size_t k = 0; k < 3; ++k) hit.normal[k] = dot(surface.rotation[k], met.normal);
  return hit;
}

/// A ray that meets an instance is turned into the frame of its mesh and starts over there. Few triangles are kept
/// faster, and as cheaply, with the objects.
bool isWorthSharing(const Triangles& mesh, std::size_t uses) {
  constexpr std::size_t kManyTriangles = 10'000;
  return uses > 1 && (uses - 1) * mesh.faces.size() >= kManyTriangles;
}

}  // namespace

static_assert(sizeof(RayPacket) == sizeof(RTCRayHit16) && alignof(RayPacket) == alignof(RTCRayHit16) &&
              offsetof(RayPacket, direction_x) == offsetof(RTCRayHit16, ray.dir_x) &&
              offsetof(RayPacket, range_m) == offsetof(RTCRayHit16, ray.tfar) &&
              offsetof(RayPacket, normal_x) == offsetof(RTCRayHit16, hit.Ng_x) &&
              offsetof(RayPacket, geometry) == offsetof(RTCRayHit16, hit.geomID));

void RayPacket::reset(const Vector3& origin_m) {
  std::fill_n(origin_x, kRays, static_cast<float>(origin_m[0]));
  std::fill_n(origin_y, kRays, static_cast<float>(origin_m[1]));
  std::fill_n(origin_z, kRays, static_cast<float>(origin_m[2]));
  std::fill_n(nearest, kRays, 0.0F);
  std::fill_n(time, kRays, 0.0F);
  std::fill_n(mask, kRays, ~0U);
  std::fill_n(id, kRays, 0U);
  std::fill_n(flags, kRays, 0U);
  rewind();
}

void RayPacket::rewind() {
  std::fill_n(range_m, kRays, std::numeric_limits<float>::infinity());
  std::fill_n(geometry, kRays, kNothing);
  std::fill_n(instance, kRays, kNothing);
}

struct RayTracer::Embree {
  std::atomic<std::int64_t> bytes = 0;  ///< before the device, which counts until it is gone
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;
  TimeSpan times;
  std::vector<Surface> surfaces;
  bool all_faceted = true;
  bool any_instance = false;
  std::map<const Triangles*, RTCScene> shared;  ///< meshes that stand in the scene more than once, while it is built

  Embree() : device(rtcNewDevice(nullptr)) {
    const auto count = [](void* total, ssize_t change, bool) {
      *static_cast<std::atomic<std::int64_t>*>(total) += change;
      return true;
    };
    rtcSetDeviceMemoryMonitorFunction(device, count, &bytes);
    scene = newScene();
  }

  [[nodiscard]] RTCScene newScene() const {
    RTCScene made = rtcNewScene(device);
    rtcSetSceneFlags(made, RTC_SCENE_FLAG_ROBUST);  // no ray slips through between two triangles
    return made;
  }

  ~Embree() {
    if (scene) rtcReleaseScene(scene);
    if (device) rtcReleaseDevice(device);
  }

  /// An object's positions at the ends of the time span: one if it does not move in it.
  [[nodiscard]] std::vector<Vector3> positionsOf(const SceneObject& object) const {
    const auto at = [&](double time_s) {
      Vector3 position = object.pose.position_m;
      for (std::size_t k = 0; k < 3; ++k) position[k] += time_s * object.velocity_m_s[k];
      return position;
    };
    const bool moves = times.to_s > times.from_s && dot(object.velocity_m_s, object.velocity_m_s) > 0.0;
    return moves ? std::vector<Vector3>{at(times.from_s), at(times.to_s)} : std::vector<Vector3>{at(times.from_s)};
  }

  void addTriangles(const SceneObject& object, const Triangles& triangles, unsigned id) {
    attach(trianglesAt(positionsOf(object), object.pose.rotation(), triangles), scene, id);
  }

  [[nodiscard]] RTCGeometry trianglesAt(const std::vector<Vector3>& positions, const std::array<Vector3, 3>& rotation,
                                        const Triangles& triangles) const {
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    rtcSetGeometryTimeStepCount(geometry, static_cast<unsigned>(positions.size()));
    for (unsigned step = 0; step < positions.size(); ++step) {
      auto* vertices = static_cast<float*>(rtcSetNewGeometryBuffer(
          geometry, RTC_BUFFER_TYPE_VERTEX, step, RTC_FORMAT_FLOAT3, 3 * sizeof(float), triangles.vertices.size()));
      for (const Vector3& local : triangles.vertices) {
        for (std::size_t i = 0; i < 3; ++i) {
          *vertices++ = static_cast<float>(positions[step][i] + dot(rotation[i], local));
        }
      }
    }
    auto* faces = static_cast<unsigned*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                                                 3 * sizeof(unsigned), triangles.faces.size()));
    for (const auto& face : triangles.faces) faces = std::copy(face.begin(), face.end(), faces);
    return geometry;
  }

  /// The mesh is kept once, in its own frame; every object is a pose of it.
  void addInstance(const SceneObject& object, const Triangles& triangles, unsigned id) {
    RTCScene& mesh = shared[&triangles];
    if (!mesh) {
      mesh = newScene();
      constexpr std::array<Vector3, 3> kUpright{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
      attach(trianglesAt({Vector3{}}, kUpright, triangles), mesh, 0);
      rtcCommitScene(mesh);
    }
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_INSTANCE);
    rtcSetGeometryInstancedScene(geometry, mesh);
    const auto positions = positionsOf(object);
    rtcSetGeometryTimeStepCount(geometry, static_cast<unsigned>(positions.size()));
    const auto rotation = object.pose.rotation();
    for (unsigned step = 0; step < positions.size(); ++step) {
      std::array<float, 12> columns;
      for (std::size_t row = 0; row < 3; ++row) {
        for (std::size_t column = 0; column < 3; ++column) {
          columns[3 * column + row] = static_cast<float>(rotation[row][column]);
        }
        columns[9 + row] = static_cast<float>(positions[step][row]);
      }
      rtcSetGeometryTransform(geometry, step, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, columns.data());
    }
    attach(geometry, scene, id);
    any_instance = true;
  }

  void addSphere(const SceneObject& object, double radius_m, unsigned id) {
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_SPHERE_POINT);
    const auto positions = positionsOf(object);
    rtcSetGeometryTimeStepCount(geometry, static_cast<unsigned>(positions.size()));
    for (unsigned step = 0; step < positions.size(); ++step) {
      auto* point = static_cast<float*>(
          rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, step, RTC_FORMAT_FLOAT4, 4 * sizeof(float), 1));
      for (std::size_t i = 0; i < 3; ++i) point[i] = static_cast<float>(positions[step][i]);
      point[3] = static_cast<float>(radius_m);
    }
    attach(geometry, scene, id);
  }

  static void attach(RTCGeometry geometry, RTCScene to, unsigned id) {
    rtcCommitGeometry(geometry);
    rtcAttachGeometryByID(to, geometry, id);
    rtcReleaseGeometry(geometry);
  }

  /// Each mesh with the number of objects that show it.
  static std::map<const Triangles*, std::size_t> usesOf(const Scene& of, MeshLibrary& meshes) {
    std::map<const Triangles*, std::size_t> uses;
    for (const SceneObject& object : of.objects) {
      if (const auto* mesh = std::get_if<Mesh>(&object.shape)) ++uses[&meshes.of(*mesh)];
    }
    return uses;
  }

  void build(const Scene& from) {
    MeshLibrary meshes;  // a file that many objects share is read once
    const auto uses = usesOf(from, meshes);
    for (unsigned id = 0; id < from.objects.size(); ++id) {
      const auto* mesh = std::get_if<Mesh>(&from.objects[id].shape);
      const Triangles* triangles = mesh ? &meshes.of(*mesh) : nullptr;
      add(from.objects[id], id, triangles, triangles && isWorthSharing(*triangles, uses.at(triangles)));
    }
    rtcCommitScene(scene);
    for (const auto& [triangles, mesh] : shared) rtcReleaseScene(mesh);  // their instances keep them
    shared.clear();
  }

  void add(const SceneObject& object, unsigned id, const Triangles* mesh, bool share) {
    const bool faceted = std::holds_alternative<Mesh>(object.shape);
    surfaces.push_back({object.shape, object.pose.position_m, object.velocity_m_s, object.pose.rotation(), faceted});
    all_faceted = all_faceted && faceted;
    if (const auto* sphere = std::get_if<Sphere>(&object.shape)) {
      addSphere(object, sphere->radius_m, id);
    } else if (share) {
      addInstance(object, *mesh, id);
    } else {
      addTriangles(object, mesh ? *mesh : trianglesOf(object.shape), id);
    }
  }

  /// What was met on an instance is told in the frame of its mesh; here it becomes the object's, in the scene's frame.
  void tellInScene(RayPacket& packet) const {
    for (std::size_t lane = 0; lane < RayPacket::kRays; ++lane) {
      if (packet.geometry[lane] == RayPacket::kNothing || packet.instance[lane] == RayPacket::kNothing) continue;
      packet.geometry[lane] = packet.instance[lane];
      const Vector3 local{packet.normal_x[lane], packet.normal_y[lane], packet.normal_z[lane]};
      const std::array<Vector3, 3>& rotation = surfaces[packet.geometry[lane]].rotation;
      packet.normal_x[lane] = static_cast<float>(dot(rotation[0], local));
      packet.normal_y[lane] = static_cast<float>(dot(rotation[1], local));
      packet.normal_z[lane] = static_cast<float>(dot(rotation[2], local));
    }
  }
};

RayTracer::RayTracer(const Scene& scene, TimeSpan times) : embree_(std::make_unique<Embree>()) {
  embree_->times = times;
  embree_->build(scene);
}

std::size_t RayTracer::memory_bytes() const noexcept { return static_cast<std::size_t>(embree_->bytes.load()); }

RayTracer::~RayTracer() = default;
RayTracer::RayTracer(RayTracer&&) noexcept = default;
RayTracer& RayTracer::operator=(RayTracer&&) noexcept = default;

void RayTracer::trace(std::span<RayPacket> packets) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  rtcIntersectNM(embree_->scene, &context, reinterpret_cast<RTCRayHitN*>(packets.data()), RayPacket::kRays,
                 static_cast<unsigned>(packets.size()), sizeof(RayPacket));
  if (!embree_->any_instance) return;
  for (RayPacket& packet : packets) embree_->tellInScene(packet);
}

float RayTracer::timeOf(double scene_time_s) const noexcept {
  const TimeSpan& times = embree_->times;
  return times.to_s > times.from_s
             ? static_cast<float>(std::clamp((scene_time_s - times.from_s) / (times.to_s - times.from_s), 0.0, 1.0))
             : 0.0F;
}

std::int32_t RayTracer::objectOf(const RayPacket& packet, std::size_t lane) const noexcept {
  return static_cast<std::int32_t>(packet.geometry[lane]);  // kNothing is -1
}

bool RayTracer::isFaceted(std::int32_t object) const noexcept {
  return embree_->surfaces[static_cast<std::size_t>(object)].faceted;
}

bool RayTracer::allFaceted() const noexcept { return embree_->all_faceted; }

RayHit RayTracer::exactly(const Ray& ray, const RayPacket& packet, std::size_t lane) const {
  const std::int32_t object = objectOf(packet, lane);
  const Vector3 facet{packet.normal_x[lane], packet.normal_y[lane], packet.normal_z[lane]};
  RayHit hit = meetExactly(embree_->surfaces[static_cast<std::size_t>(object)], ray, packet.range_m[lane], unit(facet));
  hit.object = object;
  return hit;
}

void RayTracer::trace(std::span<const Ray> rays, std::span<RayHit> hits) const {
  std::vector<RayPacket> packets((rays.size() + RayPacket::kRays - 1) / RayPacket::kRays);
  for (std::size_t p = 0; p < packets.size(); ++p) {
    RayPacket& packet = packets[p];
    packet.reset({});
    for (std::size_t lane = 0; lane < RayPacket::kRays; ++lane) {
      const Ray& ray = rays[std::min(p * RayPacket::kRays + lane, rays.size() - 1)];  // spare lanes repeat the last
      packet.origin_x[lane] = static_cast<float>(ray.origin_m[0]);
      packet.origin_y[lane] = static_cast<float>(ray.origin_m[1]);
      packet.origin_z[lane] = static_cast<float>(ray.origin_m[2]);
      packet.direction_x[lane] = static_cast<float>(ray.direction[0]);
      packet.direction_y[lane] = static_cast<float>(ray.direction[1]);
      packet.direction_z[lane] = static_cast<float>(ray.direction[2]);
      packet.time[lane] = timeOf(ray.scene_time_s);
    }
  }
  trace(packets);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const RayPacket& packet = packets[i / RayPacket::kRays];
    const std::size_t lane = i % RayPacket::kRays;
    hits[i] = objectOf(packet, lane) < 0 ? RayHit{} : exactly(rays[i], packet, lane);
  }
}

}  // namespace model
