#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "model/geometry/ray_tracer.h"
#include "model/sensor/beams.h"

namespace model {

/// One sub-ray that met a surface.
struct Hit {
  double range_m = 0.0;
  float cos_incidence = 0.0F;
  float weight = 0.0F;       ///< share of the beam's power, Σ over all sub-rays = 1
  float azimuth_rad = 0.0F;  ///< of the sub-ray itself
  std::int32_t object = -1;
};

/// Everything that the signal pass needs of the geometry: no material, no power, so hypotheses share it.
struct BeamHits {
  std::vector<Beam> beams;
  std::vector<std::uint32_t> first;  ///< hits of beam b are hits[first[b] … first[b + 1])
  std::vector<Hit> hits;

  [[nodiscard]] std::span<const Hit> of(std::size_t beam) const {
    return std::span(hits).subspan(first[beam], first[beam + 1] - first[beam]);
  }
};

/// Traces the sub-rays of every beam from the origin (Embree, all cores). Same result for any number of threads.
[[nodiscard]] BeamHits traceBeams(const RayTracer& tracer, std::vector<Beam> beams, const SubRays& sub_rays);

}  // namespace model
