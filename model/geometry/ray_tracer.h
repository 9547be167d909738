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
  double scene_time_s = 0.0;
};

/// Where a ray first meets a surface.
struct RayHit {
  double range_m = 0.0;
  double cos_incidence = 0.0;  ///< of the angle between the ray and the surface normal, in [0, 1]
  std::int32_t object = -1;    ///< index into Scene::objects; -1: nothing was hit
  Vector3 normal{};            ///< of the surface, unit length; towards either side
};

/// Sixteen rays side by side with what they meet, laid out as Embree wants them (single precision).
struct alignas(64) RayPacket {
  static constexpr std::size_t kRays = 16;
  using Numbers = float[kRays];
  using Words = std::uint32_t[kRays];
  static constexpr std::uint32_t kNothing = 0xFFFFFFFF;

  Numbers origin_x, origin_y, origin_z, nearest, direction_x, direction_y, direction_z, time, range_m;
  Words mask, id, flags;
  Numbers normal_x, normal_y, normal_z, u, v;  ///< the normal is not of unit length
  Words primitive, geometry, instance;

  /// Rays from `origin` that have met nothing yet; directions and times are the caller's.
  void reset(const Vector3& origin_m);
  /// Forgets what was met, for another use with the same origin.
  void rewind();
};

/// Moments of a scene between which its objects move evenly.
struct TimeSpan {
  double from_s = 0.0;
  double to_s = 0.0;
};

/// The scene as the ray tracer sees it (Embree). Building it is the costly part; tracing is thread-safe.
/// Ranges and incidence angles come from the shapes' own equations in double precision; only the outline of a cylinder
/// is that of a 256-sided prism, and a mesh is its facets in single precision.
class RayTracer {
 public:
  /// Throws InputError if a mesh file cannot be read. Objects with a velocity move within `times`.
  explicit RayTracer(const Scene& scene, TimeSpan times = {});
  ~RayTracer();
  RayTracer(RayTracer&&) noexcept;
  RayTracer& operator=(RayTracer&&) noexcept;

  /// First hits of a coherent bundle of rays. `hits` has the size of `rays`.
  void trace(std::span<const Ray> rays, std::span<RayHit> hits) const;

  /// The fast way: fills in what the rays meet, to single precision.
  void trace(std::span<RayPacket> packets) const;
  /// `RayPacket::time` of a moment.
  [[nodiscard]] float timeOf(double scene_time_s) const noexcept;
  /// Object that a lane of a traced packet met, -1 if none.
  [[nodiscard]] std::int32_t objectOf(const RayPacket& packet, std::size_t lane) const noexcept;
  /// Whether the packet's own numbers are all that is known of an object's surface (a mesh); else ask `exactly`.
  [[nodiscard]] bool isFaceted(std::int32_t object) const noexcept;
  [[nodiscard]] bool allFaceted() const noexcept;
  /// What Embree holds for this scene. [bytes]
  [[nodiscard]] std::size_t memory_bytes() const noexcept;
  /// What a ray met, from the shape's own equation.
  [[nodiscard]] RayHit exactly(const Ray& ray, const RayPacket& packet, std::size_t lane) const;

 private:
  struct Embree;
  std::unique_ptr<Embree> embree_;
};

}  // namespace model
