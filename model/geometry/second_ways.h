#pragma once

#include <cstdint>
#include <vector>

#include "model/geometry/hits.h"
#include "model/geometry/ray_tracer.h"

namespace model {

/// Which surfaces a sub-ray does not end on, by object, and how many of them a path may have.
struct SecondWays {
  std::size_t most_turns = 0;  ///< at most SecondHit::kMostTurns; 0: nothing of the kind
  std::vector<bool> through;
  std::vector<bool> mirrored;
};

/// The ways on behind panes and by way of mirrors, of many sub-rays at once: all that took as many turns are traced
/// together, for single rays leave the ray tracer's packets empty. Tracer and rules must outlive it.
class WaysOn {
 public:
  WaysOn(const RayTracer& tracer, const SecondWays& rules) : tracer_(tracer), rules_(rules) {}

  /// Whether a ray goes on from an object at all.
  [[nodiscard]] bool leadFrom(std::int32_t object) const;
  /// A sub-ray, and where it first met such an object.
  void begin(const Ray& ray, const RayHit& met, std::uint32_t sub_ray);
  /// Follows them all, appends what they met (first those that began first, of each the mirrored way before the one
  /// straight on) and forgets them.
  void finish(std::vector<SecondHit>& hits);

 private:
  struct Way {
    Ray ray;
    double length_m = 0.0;  ///< of the path up to the ray's origin
    SecondHit path;         ///< its hit: nothing, until the ray met something
    std::size_t next = 0;   ///< the first of the ways on from there,
    std::size_t count = 0;  ///< and how many there are
  };
  void turn(std::size_t way, const RayHit& met);
  void follow();
  void append(const Way& way, std::vector<SecondHit>& hits) const;

  const RayTracer& tracer_;
  const SecondWays& rules_;
  std::vector<Way> ways_;
  std::vector<std::size_t> begun_, open_;  ///< which of them began something; which are to be traced next
};

}  // namespace model
