#include <algorithm>

#include "core/physics.h"
#include "model/effects/declarations.h"

namespace model::effects {

namespace {

/// No two laser pulses are alike. Peak power: P = P_mean · max(0, 1 + σ_P N). Duration: the pulses of a shot are longer
/// by x = σ_τ N / FWHM of theirs. A lone pulse's EPW grows by x, an echo that is stretched (oblique surfaces, edges) by
/// less, and its peak grows, as its pulses overlap more: of width W² = w² + σ² by (w/W)² x and (1 - (w/W)²) x, to the
/// first order in x. A range taken at the leading edge comes out shorter by a quarter of what the EPW grows.
/// Source: Rosenberger 2022, doi:10.26083/tuprints-00023034, ch. 10 (scatter of the emitted pulse in the EPW).
class PulseJitter final : public Effect {
 public:
  explicit PulseJitter(const EffectParameters& parameters)
      : duration_stddev_ns_(parameters.numberOr("duration_stddev_ns", 0.0)),
        power_stddev_(parameters.numberOr("power_stddev", 0.0)) {}

  [[nodiscard]] bool fluctuates() const override { return power_stddev_ > 0.0; }
  [[nodiscard]] double fluctuation(const Beam&, core::Random& random) const override {
    return std::max(0.0, 1.0 + power_stddev_ * random.normal());
  }
  [[nodiscard]] bool reports() const override { return duration_stddev_ns_ > 0.0; }
  void report(std::vector<Echo>& echoes, const ChainSettings& settings, core::Random& random) const override {
    // Its own stream begins with the number that made the power; the duration takes the ones behind it.
    (void)random.normal();
    (void)random.normal();
    const double stretch = std::max(-0.9, duration_stddev_ns_ / settings.emitter.pulse_fwhm_ns * random.normal());
    for (Echo& echo : echoes) {
      const double wider_m = std::max(-echo.epw_m, echo.epw_per_width_m * stretch);
      echo.epw_m += wider_m;
      echo.peak_w += echo.signal_w() * echo.peak_per_width * stretch;
      if (settings.detection.range_mode == RangeMode::kLeadingEdge) echo.range_m -= wider_m / 4.0;
    }
  }

 private:
  double duration_stddev_ns_;
  double power_stddev_;
};

}  // namespace

EffectEntry pulseJitter() {
  return {.info = {.name = "pulse-jitter",
                   .title = "Jitter of the emitted pulse",
                   .summary = "Emitted pulses differ in power or duration from shot to shot.",
                   .stage = Stage::kEmission,
                   .percollect = {"5", "109"},
                   .parameters = {{"duration_stddev_ns", "ns", 0.0, 1.0, 0.0,
                                   "Standard deviation of the pulse's duration", false, 0.1},
                                  {"power_stddev", "", 0.0, 0.2, 0.0,
                                   "Standard deviation of the peak power over its mean", false, 0.05}},
                   .fitted = {"duration_stddev_ns", "power_stddev"},
                   .other_forms = {{"of the power", {"power_stddev"}}, {"of the duration", {"duration_stddev_ns"}}},
                   .source = "Rosenberger 2022, doi:10.26083/tuprints-00023034, ch. 10"},
          .make = makeFrom<PulseJitter>};
}

}  // namespace model::effects
