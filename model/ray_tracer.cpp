#include "model/ray_tracer.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "model/triangles.h"

namespace model {

namespace {

double dot(const Vector3& a, const Vector3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Vector3 unit(const Vector3& v) {
  const double length = std::sqrt(dot(v, v));
  return {v[0] / length, v[1] / length, v[2] / length};
}

/// Outward normal of the curved part of a shape at a point of its surface (world frame); the geometric one elsewhere.
Vector3 exactNormal(const SceneObject& object, const Vector3& point, const Vector3& geometric) {
  if (std::holds_alternative<Sphere>(object.shape)) {
    const Vector3& c = object.pose.position_m;
    return unit({point[0] - c[0], point[1] - c[1], point[2] - c[2]});
  }
  if (std::holds_alternative<Cylinder>(object.shape)) {
    const auto r = object.pose.rotation();
    const Vector3 axis = {r[0][2], r[1][2], r[2][2]};
    if (std::abs(dot(unit(geometric), axis)) > 0.5) return unit(geometric);  // a lid
    const Vector3 local = object.pose.toLocal(point);
    const Vector3 tip = object.pose.toWorld({local[0], local[1], 0.0});
    return unit({tip[0] - object.pose.position_m[0], tip[1] - object.pose.position_m[1],
                 tip[2] - object.pose.position_m[2]});
  }
  return unit(geometric);
}

}  // namespace

struct RayTracer::Embree {
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;
  std::vector<SceneObject> objects;

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
      for (std::size_t i = 0; i < 3; ++i) *vertices++ = static_cast<float>(object.pose.position_m[i] + dot(rotation[i], local));
    }
    auto* faces = static_cast<unsigned*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                                                 3 * sizeof(unsigned), triangles.faces.size()));
    for (const auto& face : triangles.faces) faces = std::copy(face.begin(), face.end(), faces);
    attach(geometry, id);
  }

  void addSphere(const SceneObject& object, double radius_m, unsigned id) {
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_SPHERE_POINT);
    auto* point = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4,
                                                              4 * sizeof(float), 1));
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
    const double range = found.ray.tfar;
    const Vector3 point = {ray.origin_m[0] + range * ray.direction[0], ray.origin_m[1] + range * ray.direction[1],
                           ray.origin_m[2] + range * ray.direction[2]};
    const Vector3 normal = exactNormal(objects[found.hit.geomID], point, {found.hit.Ng_x, found.hit.Ng_y, found.hit.Ng_z});
    return {range, std::min(1.0, std::abs(dot(normal, ray.direction))), static_cast<std::int32_t>(found.hit.geomID)};
  }
};

RayTracer::RayTracer(const Scene& scene) : embree_(std::make_unique<Embree>()) {
  embree_->device = rtcNewDevice(nullptr);
  embree_->scene = rtcNewScene(embree_->device);
  rtcSetSceneFlags(embree_->scene, RTC_SCENE_FLAG_ROBUST);  // no ray slips through between two triangles
  embree_->objects = scene.objects;
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
