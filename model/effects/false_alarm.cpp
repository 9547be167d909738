#include <cmath>

#include "core/physics.h"
#include "model/effects/declarations.h"

namespace model::effects {

namespace {

/// Noise crosses the threshold: a Poisson number of echoes a shot, evenly over the range. By how much Gaussian noise
/// tops a high threshold is exponential with mean σ²/P_th (Rice); the noise has passed the receiver, so its peaks have
/// the pulse's shape and width; near an echo they are one with it (signal/merging.h). Source: Rice 1945,
/// doi:10.1002/j.1538-7305.1945.tb00453.x, sec. 3.3 and 3.6.
class FalseAlarm final : public Effect {
 public:
  explicit FalseAlarm(const EffectParameters& parameters) : rate_(parameters.numberOr("rate_per_beam", 0.0)) {}

  [[nodiscard]] bool reports() const override { return true; }
  void report(std::vector<Echo>& echoes, const ChainSettings& settings, core::Random& random) const override {
    const DetectionStage& stage = settings.detection;
    const double threshold_w = settings.receiver.threshold_w;
    const double mean_excess = std::pow(settings.receiver.noise_w / threshold_w, 2);
    const std::uint32_t count = random.poisson(rate_);
    for (std::uint32_t i = 0; i < count; ++i) {
      const double over_threshold = 1.0 - mean_excess * std::log(random.uniform());
      echoes.push_back(
          {.range_m = stage.min_range_m + (stage.max_range_m - stage.min_range_m) * random.uniform(),
           .epw_m = core::kMetresPerNanosecond * settings.emitter.pulse_fwhm_ns * std::sqrt(std::log2(over_threshold)),
           .peak_w = over_threshold * threshold_w});
    }
  }

 private:
  double rate_;
};

}  // namespace

EffectEntry falseAlarm() {
  return {
      .info = {.name = "false-alarm",
               .title = "False alarms from noise",
               .summary = "Noise crosses the threshold now and then and is reported as an echo, at any distance.",
               .stage = Stage::kDetection,
               .percollect = {"1", "43"},
               .parameters = {{"rate_per_beam", "", 0.0, 0.1, 0.0, "Mean number of false echoes a shot", true, 0.01}},
               .fitted = {"rate_per_beam"},
               .source = "Rice 1945, doi:10.1002/j.1538-7305.1945.tb00453.x"},
      .make = makeFrom<FalseAlarm>};
}

}  // namespace model::effects
