#pragma once

#include <vector>

#include "model/geometry/hits.h"
#include "model/geometry/ray_tracer.h"
#include "model/geometry/second_ways.h"

namespace model {

/// A beam's own axes in single precision; its left axis is level.
struct BeamAxes {
  float forward[3], left[2], up[3];
};

/// Unit directions of sub-rays along the axes of their beam.
struct RayOffsets {
  std::vector<float> forward, left, up;
  std::vector<double> left_slope, up_slope;  ///< tangents of the offsets
};

/// The first pass of the simulation: which sub-ray of which beam meets what. The directions of the beams are worked out
/// once; `trace` then does one stretch of neighbouring beams and may be called from many threads, each with buffers of
/// its own. Tracer and beams must outlive it.
class GeometryPass {
 public:
  GeometryPass(const RayTracer& tracer, std::span<const Beam> beams, SubRays rays, const Vector3& origin_m = {},
               SecondWays second = {});

  [[nodiscard]] std::span<const Beam> beams() const noexcept { return beams_; }
  [[nodiscard]] const SubRays& rays() const noexcept { return rays_; }

  /// What one thread works with, and the result. Reused from call to call.
  struct Tile {
    std::vector<RayPacket> packets;
    Hits hits;
    std::vector<SecondHit> second;
    std::vector<std::uint32_t> first_second;
  };
  /// Hits of the beams [begin, end).
  void trace(std::size_t begin, std::size_t end, Tile& tile) const;

 private:
  void aimPackets(std::size_t begin, std::size_t end, std::vector<RayPacket>& packets) const;
  void collect(std::size_t begin, std::size_t end, Tile& tile) const;
  void collectExactly(std::size_t begin, std::size_t end, Tile& tile) const;
  void follow(std::size_t begin, std::size_t end, Tile& tile) const;
  [[nodiscard]] Ray rayOf(std::size_t beam, const BeamTurn& turn, std::size_t ray) const;

  const RayTracer& tracer_;
  std::span<const Beam> beams_;
  SubRays rays_;
  Vector3 origin_m_;
  SecondWays second_;
  bool timed_ = false;
  std::vector<BeamAxes> axes_;
  RayOffsets offsets_;
};

/// All beams on all cores. Same result for any number of threads.
[[nodiscard]] BeamHits traceBeams(const RayTracer& tracer, std::vector<Beam> beams, const SubRays& rays,
                                  const Vector3& origin_m = {}, const SecondWays& second = {});

/// The moments of the scene that the beams meet.
[[nodiscard]] TimeSpan timesOf(std::span<const Beam> beams);

}  // namespace model
