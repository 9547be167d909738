#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "model/scene/scene.h"

namespace model {

struct Ray {
  Vector3 origin_m;
  Vector3 direction;  ///< unit length
};

/// Where a ray first meets a surface.
struct RayHit {
  double range_m = 0.0;
  double cos_incidence = 0.0;  ///< of the angle between the ray and the surface normal, in [0, 1]
  std::int32_t object = -1;    ///< index into Scene::objects; -1: nothing was hit
};

/// The scene as the ray tracer sees it (Embree). Building it is the costly part; tracing is thread-safe.
/// Ranges and incidence angles come from the shapes' own equations in double precision; only the outline of a cylinder
/// is that of a 256-sided prism, and a mesh is its facets in single precision.
class RayTracer {
 public:
  /// Throws InputError if a mesh file cannot be read.
  explicit RayTracer(const Scene& scene);
  ~RayTracer();
  RayTracer(RayTracer&&) noexcept;
  RayTracer& operator=(RayTracer&&) noexcept;

  /// First hits of a coherent bundle of rays. `hits` has the size of `rays`.
  void trace(std::span<const Ray> rays, std::span<RayHit> hits) const;

 private:
  struct Embree;
  std::unique_ptr<Embree> embree_;
};

}  // namespace model
