#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/detections.h"
#include "model/effects/effect.h"
#include "model/geometry/geometry_pass.h"
#include "model/lidar_model.h"
#include "model/signal/waveform.h"

namespace model {

/// One detection, by index of its beam: what the signal pass yields and the diagnosis compares.
struct Shot {
  std::uint32_t beam = 0;
  std::int32_t frame = 0;
  std::int32_t echo = 1;
  double range_m = 0.0;
  double epw_m = 0.0;
  double intensity_nw = 0.0;
};

/// What a run of the chain depends on besides geometry and effects.
struct RunOptions {
  std::uint64_t seed = 1;
  std::uint32_t sample = 0;  ///< tells the random streams of samples apart
  int frames = 1;
};

/// The signal pass of the reference chain (formats.md section 3, steps 2 to 6) with the model's effects switched on.
/// Immutable after construction; safe to share.
///
///   received peak power of a sub-ray, laser radar equation (Rasshofer et al. 2011, doi:10.5194/ars-9-49-2011):
///     P = P_t · w · η A_r · T² · χ · (Γ/π) · cos θ / r²,   A_r = π D² / 4
class SignalChain {
 public:
  SignalChain(const SensorProfile& sensor, const std::vector<ActiveEffect>& effects, const Environment& environment);
  ~SignalChain();
  SignalChain(SignalChain&&) noexcept;
  SignalChain& operator=(SignalChain&&) noexcept;

  [[nodiscard]] const ChainSettings& settings() const noexcept { return settings_; }
  /// The beams of a frame as the effects turn them.
  void aim(std::vector<Beam>& beams) const;
  /// Received pulses of one beam. Peak power before noise; broadening on: one per sub-ray, off: one per object.
  [[nodiscard]] std::vector<Pulse> pulsesOf(const Beam& beam, std::span<const Hit> hits, const Scene& scene) const;
  /// All detections, frame by frame and beam by beam.
  [[nodiscard]] std::vector<Shot> run(const BeamHits& geometry, const Scene& scene, const RunOptions& options) const;

 private:
  struct Scratch;
  /// An effect that draws random numbers has a stream of its own: switching it on changes nobody else's noise.
  struct Drawing {
    const Effect* effect;
    std::uint32_t purpose;
    [[nodiscard]] core::Random stream(core::Random::Key key) const;
  };
  void fireBeam(std::uint32_t index, const BeamHits& geometry, const Scene& scene, const RunOptions& options,
                Scratch& scratch, std::vector<Shot>& out) const;
  void fireFrame(const Beam& beam, const std::vector<WaveformPart>& parts, const core::Random::Key& key,
                 Scratch& scratch) const;
  [[nodiscard]] Echo toEcho(const Stretch& stretch) const;
  void finish(std::vector<Echo>& echoes, core::Random& random, const core::Random::Key& key) const;

  ChainSettings settings_;
  std::vector<std::unique_ptr<Effect>> effects_;
  std::vector<const Effect*> power_effects_;
  std::vector<Drawing> fluctuating_effects_;
  std::vector<Drawing> reporting_effects_;
};

/// Detections with the directions of their beams; the columns that the profile puts out.
[[nodiscard]] core::Detections toDetections(const std::vector<Shot>& shots, const std::vector<Beam>& beams,
                                            const SensorProfile& sensor);

}  // namespace model
