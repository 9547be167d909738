#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/detections.h"
#include "model/effects/effect.h"
#include "model/geometry/geometry_pass.h"
#include "model/lidar_model.h"
#include "model/signal/disturbances.h"
#include "model/signal/lone_pulses.h"
#include "model/signal/power_stage.h"
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
  int first_frame = 0;
};

/// What happened in one shot besides its echoes; written down on demand.
struct ShotRecord {
  std::vector<Pulse> pulses;  ///< before the fluctuation
  Fluctuation fluctuation;
  Receiver receiver;            ///< as it was for this beam
  std::vector<double> noise_w;  ///< per part of the waveform
  std::vector<Echo> echoes;     ///< all of them, with their fates
};

/// The signal pass of the reference chain (formats.md section 3, steps 2 to 6) with the model's effects switched on.
/// Immutable after construction; safe to share.
class SignalChain {
 public:
  SignalChain(const SensorProfile& sensor, const std::vector<ActiveEffect>& effects, const Environment& environment);
  ~SignalChain();
  SignalChain(SignalChain&&) noexcept;
  SignalChain& operator=(SignalChain&&) noexcept;

  [[nodiscard]] const ChainSettings& settings() const noexcept { return settings_; }
  [[nodiscard]] std::span<const Effect* const> effects() const noexcept { return all_effects_; }

  // --- what the effects change before rays are traced
  /// The beams of a frame as the effects turn them.
  void aim(std::vector<Beam>& beams) const;
  /// The beam's sub-rays: a grid over its cross-section, and what effects add to it.
  [[nodiscard]] SubRays subRays(int horizontal, int vertical, Grid grid = Grid::kEven) const;
  /// The surfaces behind which, or by way of which, light goes on.
  [[nodiscard]] SecondWays secondWays(const Scene& scene) const;

  // --- hits to detections
  /// Received pulses of one beam. Peak power before noise; broadening on: one per sub-ray, off: one per object.
  [[nodiscard]] std::vector<Pulse> pulsesOf(const BeamHits& geometry, std::size_t beam, const Scene& scene) const;
  /// All detections, frame by frame and beam by beam.
  [[nodiscard]] std::vector<Shot> run(const BeamHits& geometry, const Scene& scene, const RunOptions& options) const;
  /// The same, tracing as it goes: no more than a tile of hits per thread is ever held.
  [[nodiscard]] std::vector<Shot> run(const GeometryPass& pass, const Scene& scene, const RunOptions& options) const;
  /// Whether the pulses of a beam depend on other beams; then all of them are held at once.
  [[nodiscard]] bool couplesBeams() const noexcept { return !coupling_effects_.empty(); }

  /// One shot, written down: `run` yields its echoes whose fate is kDetected.
  [[nodiscard]] ShotRecord record(const BeamHits& geometry, std::size_t beam, const Scene& scene,
                                  const RunOptions& options, int frame) const;

 private:
  struct Scratch;
  /// A beam whose pulses are known, ready to be fired in every frame.
  struct Loaded {
    std::uint32_t index;  ///< of the beam in the scan
    const BeamView& view;
    std::span<const Pulse> pulses;
  };

  void fireTile(const TracedBeams& traced, const Pulses& pulses, const PowerStage& power, std::size_t first_beam,
                const RunOptions& options, const Disturbances& disturbances, Scratch& scratch,
                std::vector<Shot>& out) const;
  void load(const Loaded& beam, const Receiver& receiver, Scratch& scratch) const;
  void fireBeam(const Loaded& beam, const RunOptions& options, const Disturbances& disturbances, Scratch& scratch,
                std::vector<Shot>& out) const;
  void fireShot(const Loaded& beam, const Receiver& receiver, const core::Random::Key& key,
                const Disturbances& disturbances, Scratch& scratch, ShotRecord* record) const;
  void listenTo(const std::vector<WaveformPart>& parts, const Receiver& receiver, const Fluctuation& fluctuation,
                const core::Random::Key& key, Scratch& scratch, ShotRecord* record) const;
  [[nodiscard]] Receiver receiverOf(const BeamView& view) const;
  /// Standard deviation of a beam's noise, that of its receiver given.
  [[nodiscard]] double noiseOf_w(const BeamView& view, const Receiver& receiver) const;
  [[nodiscard]] double lowestLevel(const Receiver& receiver) const;
  [[nodiscard]] Pulses coupledPulses(const BeamHits& geometry, const PowerStage& power) const;
  void fireLone(const TracedBeams& traced, const RunOptions& options, Scratch& scratch, std::vector<Shot>& out) const;
  [[nodiscard]] Fluctuation fluctuationOf(const Beam& beam, const core::Random::Key& shot) const;
  void count(Echo& echo) const;
  [[nodiscard]] bool insideWindow(const Echo& echo) const;
  void finish(const Receiver& receiver, const core::Random::Key& key, Scratch& scratch, ShotRecord* record) const;

  ChainSettings settings_;
  BeamProfile beam_profile_;
  std::vector<std::unique_ptr<Effect>> effects_;
  std::vector<const Effect*> all_effects_;
  std::vector<const Effect*> coupling_effects_;
  std::vector<const Effect*> receiver_effects_;
  std::vector<const Effect*> noise_effects_;
  std::vector<const Effect*> echo_effects_;
  std::vector<DrawingEffect> disturbing_effects_;
  std::vector<DrawingEffect> fluctuating_effects_;
  std::vector<DrawingEffect> reporting_effects_;
};

/// Detections with the directions of their beams; the columns that the profile puts out.
[[nodiscard]] core::Detections toDetections(const std::vector<Shot>& shots, const std::vector<Beam>& beams,
                                            const SensorProfile& sensor);

}  // namespace model
