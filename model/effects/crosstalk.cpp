#include <cmath>

#include "core/physics.h"
#include "model/effects/declarations.h"

namespace model::effects {

namespace {

constexpr double kExcess = 10.0;  ///< foreign pulses come one way and are seldom weak

/// Pulses of a foreign lidar arrive whenever they like: a Poisson number in the time that one shot listens,
/// mean = rate · 2 (r_max - r_min) / c, at ranges that have nothing to do with the scene. Their power above the
/// threshold is drawn from an exponential distribution, whose mean depends on the foreign lidar and its distance
/// (`excess`, in thresholds); their width follows from it as for any Gaussian pulse. Near an echo they are one
/// with it (signal/merging.h). Source:
/// Kim, Eom, Park 2015, IEEE Intelligent Vehicles Symposium (mutual interference of pulsed lidar scanners).
class Crosstalk final : public Effect {
 public:
  explicit Crosstalk(const EffectParameters& parameters)
      : rate_1_s_(parameters.numberOr("rate_1_s", 0.0)), excess_(parameters.numberOr("excess", kExcess)) {}

  [[nodiscard]] bool reports() const override { return true; }
  void report(std::vector<Echo>& echoes, const ChainSettings& settings, core::Random& random) const override {
    const DetectionStage& stage = settings.detection;
    const double span_m = stage.max_range_m - stage.min_range_m;
    const std::uint32_t count = random.poisson(rate_1_s_ * 2.0 * span_m / core::kSpeedOfLight_m_s);
    for (std::uint32_t i = 0; i < count; ++i) {
      const double over_threshold = 1.0 - excess_ * std::log(random.uniform());
      echoes.push_back(
          {.range_m = stage.min_range_m + span_m * random.uniform(),
           .epw_m = core::kMetresPerNanosecond * settings.emitter.pulse_fwhm_ns * std::sqrt(std::log2(over_threshold)),
           .peak_w = over_threshold * settings.receiver.threshold_w});
    }
  }

 private:
  double rate_1_s_;
  double excess_;
};

}  // namespace

EffectEntry crosstalk() {
  return {
      .info =
          {.name = "crosstalk",
           .title = "Crosstalk from foreign lidars",
           .summary =
               "Pulses of other lidars are received as echoes, at distances that have nothing to do with the scene.",
           .stage = Stage::kPropagation,
           .percollect = {"84", "85"},
           .parameters = {{"rate_1_s", "1/s", 0.0, 1e6, 0.0, "Foreign pulses that the receiver meets", true, 1e4},
                          {"excess", "", 0.3, 1000.0, kExcess,
                           "Mean power of a foreign pulse above the threshold, in thresholds", true, kExcess}},
           .fitted = {"rate_1_s", "excess"},
           .source = "Kim, Eom, Park 2015, IEEE Intelligent Vehicles Symposium"},
      .make = makeFrom<Crosstalk>};
}

}  // namespace model::effects
