#include "model/geometry/ray_tracer.h"

#include <algorithm>
#include <cmath>
#include <embree3/rtcore.h>
#include <limits>

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
  std::array<Vector3, 3> rotation;

  [[nodiscard]] Vector3 localOf(const Vector3& v) const {  // a direction; transposed rotation
    Vector3 local{};
    for (std::size_t i = 0; i < 3; ++i)
      local[i] = rotation[0][i] * v[0] + rotation[1][i] * v[1] + rotation[2][i] * v[2];
    return local;
  }
};

/// Range and |cos| of the incidence angle.
struct Meeting {
  double range_m;
  double cos_incidence;
};

/// Face at local coordinate `at` along one axis, seen from the ray o + t d.
Meeting meetFace(const Vector3& o, const Vector3& d, std::size_t axis, double at, double otherwise_m) {
  return {d[axis] != 0.0 ? (at - o[axis]) / d[axis] : otherwise_m, std::abs(d[axis])};
}

/// The root of t² a + 2 t b + c = 0 nearest to where Embree met the facet.
double nearestRoot(double a, double b, double c, double near_m) {
  const double root = std::sqrt(std::max(0.0, b * b - a * c));
  const double first = (-b - root) / a, second = (-b + root) / a;
  return std::abs(first - near_m) < std::abs(second - near_m) ? first : second;
}

/// Embree works in single precision and on facets; it says which surface was met and about where. The shape's own
/// equation then gives range and incidence exactly; meshes are their facets.
Meeting meetExactly(const Surface& surface, const Ray& ray, double near_m, const Vector3& facet_normal) {
  const Vector3 o = surface.localOf({ray.origin_m[0] - surface.position_m[0], ray.origin_m[1] - surface.position_m[1],
                                     ray.origin_m[2] - surface.position_m[2]});
  const Vector3 d = surface.localOf(ray.direction);
  const Vector3 facet = surface.localOf(facet_normal);
  if (std::holds_alternative<Rectangle>(surface.shape)) return meetFace(o, d, 0, 0.0, near_m);
  if (std::holds_alternative<Plane>(surface.shape)) return meetFace(o, d, 2, 0.0, near_m);
  if (const auto* box = std::get_if<Box>(&surface.shape)) {
    std::size_t axis = 0;
    for (std::size_t k = 1; k < 3; ++k) axis = std::abs(facet[k]) > std::abs(facet[axis]) ? k : axis;
    return meetFace(o, d, axis, std::copysign(box->size_m[axis] / 2.0, o[axis] + near_m * d[axis]), near_m);
  }
  if (const auto* sphere = std::get_if<Sphere>(&surface.shape)) {
    const double t = nearestRoot(1.0, dot(o, d), dot(o, o) - sphere->radius_m * sphere->radius_m, near_m);
    return {t, std::abs(dot(o, d) + t) / sphere->radius_m};
  }
  if (const auto* cylinder = std::get_if<Cylinder>(&surface.shape)) {
    if (std::abs(facet[2]) > 0.5) {  // a lid
      return meetFace(o, d, 2, std::copysign(cylinder->height_m / 2.0, o[2] + near_m * d[2]), near_m);
    }
    const double across = d[0] * d[0] + d[1] * d[1], along = o[0] * d[0] + o[1] * d[1];
    const double t =
        nearestRoot(across, along, o[0] * o[0] + o[1] * o[1] - cylinder->radius_m * cylinder->radius_m, near_m);
    return {t, std::abs(along + t * across) / cylinder->radius_m};
  }
  return {near_m, std::abs(dot(facet_normal, ray.direction))};
}

}  // namespace

struct RayTracer::Embree {
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;
  std::vector<Surface> surfaces;

  ~Embree() {
    if (scene) rtcReleaseScene(scene);
    if (device) rtcReleaseDevice(device);
  }

  void addTriangles(const SceneObject& object, const Triangles& triangles, unsigned id) {
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* vertices = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                                                 3 * sizeof(float), triangles.vertices.size()));
    const auto rotation = object.pose.rotation();
    for (const Vector3& local : triangles.vertices) {
      for (std::size_t i = 0; i < 3; ++i)
        *vertices++ = static_cast<float>(object.pose.position_m[i] + dot(rotation[i], local));
    }
    auto* faces = static_cast<unsigned*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                                                 3 * sizeof(unsigned), triangles.faces.size()));
    for (const auto& face : triangles.faces) faces = std::copy(face.begin(), face.end(), faces);
    attach(geometry, id);
  }

  void addSphere(const SceneObject& object, double radius_m, unsigned id) {
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_SPHERE_POINT);
    auto* point = static_cast<float*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4, 4 * sizeof(float), 1));
    for (std::size_t i = 0; i < 3; ++i) point[i] = static_cast<float>(object.pose.position_m[i]);
    point[3] = static_cast<float>(radius_m);
    attach(geometry, id);
  }

  void attach(RTCGeometry geometry, unsigned id) {
    rtcCommitGeometry(geometry);
    rtcAttachGeometryByID(scene, geometry, id);
    rtcReleaseGeometry(geometry);
  }

  [[nodiscard]] RayHit toHit(const Ray& ray, const RTCRayHit& found) const {
    if (found.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};
    const Meeting met = meetExactly(surfaces[found.hit.geomID], ray, found.ray.tfar,
                                    unit({found.hit.Ng_x, found.hit.Ng_y, found.hit.Ng_z}));
    return {met.range_m, std::min(1.0, met.cos_incidence), static_cast<std::int32_t>(found.hit.geomID)};
  }
};

RayTracer::RayTracer(const Scene& scene) : embree_(std::make_unique<Embree>()) {
  embree_->device = rtcNewDevice(nullptr);
  embree_->scene = rtcNewScene(embree_->device);
  rtcSetSceneFlags(embree_->scene, RTC_SCENE_FLAG_ROBUST);  // no ray slips through between two triangles
  for (const SceneObject& object : scene.objects) {
    embree_->surfaces.push_back({object.shape, object.pose.position_m, object.pose.rotation()});
  }
  for (unsigned id = 0; id < scene.objects.size(); ++id) {
    const SceneObject& object = scene.objects[id];
    if (const auto* sphere = std::get_if<Sphere>(&object.shape)) {
      embree_->addSphere(object, sphere->radius_m, id);
    } else {
      embree_->addTriangles(object, trianglesOf(object.shape), id);
    }
  }
  rtcCommitScene(embree_->scene);
}

RayTracer::~RayTracer() = default;
RayTracer::RayTracer(RayTracer&&) noexcept = default;
RayTracer& RayTracer::operator=(RayTracer&&) noexcept = default;

void RayTracer::trace(std::span<const Ray> rays, std::span<RayHit> hits) const {
  std::vector<RTCRayHit> bundle(rays.size());
  for (std::size_t i = 0; i < rays.size(); ++i) {
    RTCRay& ray = bundle[i].ray;
    ray.org_x = static_cast<float>(rays[i].origin_m[0]);
    ray.org_y = static_cast<float>(rays[i].origin_m[1]);
    ray.org_z = static_cast<float>(rays[i].origin_m[2]);
    ray.dir_x = static_cast<float>(rays[i].direction[0]);
    ray.dir_y = static_cast<float>(rays[i].direction[1]);
    ray.dir_z = static_cast<float>(rays[i].direction[2]);
    ray.tnear = 0.0F;
    ray.tfar = std::numeric_limits<float>::infinity();
    ray.mask = ~0U;
    ray.time = 0.0F;
    ray.flags = 0;
    bundle[i].hit.geomID = RTC_INVALID_GEOMETRY_ID;
    bundle[i].hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  }
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  rtcIntersect1M(embree_->scene, &context, bundle.data(), static_cast<unsigned>(bundle.size()), sizeof(RTCRayHit));
  for (std::size_t i = 0; i < rays.size(); ++i) hits[i] = embree_->toHit(rays[i], bundle[i]);
}

}  // namespace model
