#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "model/experiment.h"
#include "model/lidar_model.h"
#include "model/signal/signal_chain.h"
#include "model/simulate.h"

namespace model {

/// Why a beam yielded a detection, or none.
enum class Reason {
  kDetected,
  kNoHit,
  kBelowThreshold,
  kBlinded,
  kLost,
  kOutsideWindow,
};
[[nodiscard]] std::string toString(Reason reason);
[[nodiscard]] std::string toString(Fate fate);

/// A sub-ray and what it met; `object` is empty if it met nothing.
struct SubRayExplanation {
  double azimuth_rad = 0.0;
  double elevation_rad = 0.0;
  double weight = 0.0;  ///< share of the beam's power
  std::string object;
  std::string material;
  double range_m = 0.0;  ///< the whole way, by way of panes and mirrors
  double incidence_rad = 0.0;
  double power_w = 0.0;  ///< received peak power, before fluctuation and noise
  int turns = 0;         ///< panes and mirrors on the way
};

/// A sample of the received signal without noise.
struct WaveformSample {
  double range_m = 0.0;
  double power_w = 0.0;
};

/// Everything that led from one beam of one frame to its detections.
struct BeamExplanation {
  Beam beam;
  Reason reason = Reason::kNoHit;
  std::vector<SubRayExplanation> rays;
  std::vector<WaveformSample> waveform;  ///< wherever there are pulses, sixteen samples a width
  ShotRecord shot;
};

/// Explains the beams of one sample of an experiment, as `simulate` fires them with the same seed. Geometry is traced
/// once. Experiment and model must outlive it.
class Explainer {
 public:
  Explainer(const Experiment& experiment, const LidarModel& model, std::size_t sample,
            std::optional<std::uint64_t> seed = std::nullopt);

  [[nodiscard]] const std::vector<Beam>& beams() const noexcept { return traced_.hits.beams; }
  /// The beam whose axis lies nearest to a direction; any layer if none is given.
  [[nodiscard]] std::size_t beamNear(std::optional<int> layer, double azimuth_rad) const;
  [[nodiscard]] Reason reasonOf(std::size_t beam, int frame) const;
  [[nodiscard]] BeamExplanation explain(std::size_t beam, int frame) const;

 private:
  [[nodiscard]] ShotRecord recordOf(std::size_t beam, int frame) const;
  [[nodiscard]] Reason reasonOf(std::size_t beam, const ShotRecord& shot) const;
  [[nodiscard]] std::vector<SubRayExplanation> raysOf(std::size_t beam) const;

  TracedSample traced_;
  SignalChain chain_;
  RunOptions options_;
};

}  // namespace model
