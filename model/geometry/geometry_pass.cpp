#include "model/geometry/geometry_pass.h"

#include <cmath>

#include "core/parallel.h"

namespace model {

namespace {

/// A surface nearer than this touches the sensor: the beam is lost in it, and 1/r² means nothing there.
constexpr double kNearest_m = 1e-3;

/// Direction at angular offsets to the left and up in the beam's own plane.
Vector3 directionOf(const Beam& beam, double left_rad, double up_rad) {
  const double ca = std::cos(beam.azimuth_rad), sa = std::sin(beam.azimuth_rad);
  const double ce = std::cos(beam.elevation_rad), se = std::sin(beam.elevation_rad);
  const double l = std::tan(left_rad), u = std::tan(up_rad);
  const Vector3 d = {ce * ca - l * sa - u * se * ca, ce * sa + l * ca - u * se * sa, se + u * ce};
  const double length = std::sqrt(1.0 + l * l + u * u);
  return {d[0] / length, d[1] / length, d[2] / length};
}

}  // namespace

BeamHits traceBeams(const RayTracer& tracer, std::vector<Beam> beams, const SubRays& sub_rays) {
  const std::size_t rays_per_beam = sub_rays.weight.size();
  std::vector<std::vector<Hit>> per_beam(beams.size());
  core::parallelFor(beams.size(), 32, [&](std::size_t begin, std::size_t end) {
    std::vector<Ray> rays(rays_per_beam);
    std::vector<RayHit> found(rays_per_beam);
    for (std::size_t b = begin; b < end; ++b) {
      for (std::size_t i = 0; i < rays_per_beam; ++i) {
        rays[i] = {{}, directionOf(beams[b], sub_rays.left_rad[i], sub_rays.up_rad[i])};
      }
      tracer.trace(rays, found);
      for (std::size_t i = 0; i < rays_per_beam; ++i) {
        if (found[i].object < 0 || !(found[i].range_m >= kNearest_m)) continue;
        per_beam[b].push_back(
            {found[i].range_m, static_cast<float>(found[i].cos_incidence), static_cast<float>(sub_rays.weight[i]),
             static_cast<float>(std::atan2(rays[i].direction[1], rays[i].direction[0])), found[i].object});
      }
    }
  });
  BeamHits result;
  result.beams = std::move(beams);
  result.first.reserve(per_beam.size() + 1);
  result.first.push_back(0);
  for (const std::vector<Hit>& hits : per_beam) {
    result.hits.insert(result.hits.end(), hits.begin(), hits.end());
    result.first.push_back(static_cast<std::uint32_t>(result.hits.size()));
  }
  return result;
}

}  // namespace model
