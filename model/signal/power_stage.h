#pragma once

#include <span>
#include <vector>

#include "model/effects/effect.h"

namespace model {

/// The traced hits of some neighbouring beams, however they are kept.
struct TracedBeams {
  std::span<const Beam> beams;
  const SubRays& rays;
  const Hits& hits;
  std::size_t first_beam;  ///< index of beams[0] in hits.first
  std::span<const SecondHit> second;
  std::span<const std::uint32_t> first_second;  ///< of beams[0] …; empty if there are none
  std::span<const double> power_w = {};         ///< of all `hits` and of `second`, if known from elsewhere (BeamHits)
  std::span<const double> second_power_w = {};

  [[nodiscard]] HitsOfBeam hitsOf(std::size_t b) const { return {hits, first_beam + b}; }
  [[nodiscard]] std::span<const SecondHit> secondOf(std::size_t b) const {
    if (first_second.empty()) return {};
    return second.subspan(first_second[b], first_second[b + 1] - first_second[b]);
  }
};

/// Pulses of neighbouring beams; beam b's are those from first[b] to first[b + 1].
struct Pulses {
  std::vector<std::uint32_t> first{0};
  std::vector<Pulse> pulses;

  [[nodiscard]] std::span<const Pulse> of(std::size_t beam) const {
    return std::span(pulses).subspan(first[beam], first[beam + 1] - first[beam]);
  }
  void clear();
  void add(std::span<const Pulse> of_next_beam);
};

/// From hits to received pulses: laser radar equation (Rasshofer et al. 2011, doi:10.5194/ars-9-49-2011) and every
/// effect that changes power.
///
///   P = P_t · w · η A_r · T² · χ · (Γ/π) · cos θ / r²,   A_r = π D² / 4
///
/// Broadening on: one pulse per sub-ray; off: one per object, at the mean range weighted with power.
/// Settings, effects and scene must outlive it.
class PowerStage {
 public:
  PowerStage(const ChainSettings& settings, std::span<const Effect* const> effects, const Scene& scene);

  /// Buffers that a thread reuses.
  struct Scratch {
    std::vector<double> power_w;
    std::vector<std::int32_t> objects;
    std::vector<Pulse> of_beam;
  };
  /// Pulses of all beams; peak powers before anything random.
  void receive(const TracedBeams& traced, Scratch& scratch, Pulses& out) const;
  /// Received power of every straight hit of these beams, in their order. [W]
  void powersOf(const TracedBeams& traced, std::vector<double>& power_w) const;
  /// Received power by way of panes and mirrors. [W]
  [[nodiscard]] double powerOf(const Beam& beam, const SubRays& rays, const SecondHit& second) const;

  [[nodiscard]] BeamView viewOf(const Beam& beam, const HitsOfBeam& hits, const SubRays& rays) const;

 private:
  void receiveOtherwise(const TracedBeams& traced, std::size_t beam, Scratch& scratch, Pulses& out) const;
  void weaken(const TracedBeams& traced, std::size_t begin, const Effect& effect, std::span<double> power_w) const;

  const ChainSettings& settings_;
  const Scene& scene_;
  double constant_w_m2_;                      ///< P_t η A_r
  std::vector<const Material*> materials_;    ///< by object
  std::vector<double> reflectivity_over_pi_;  ///< by object
  std::vector<const Effect*> power_effects_;
  std::vector<const Effect*> pulse_effects_;
};

}  // namespace model
