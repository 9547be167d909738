#include <algorithm>
#include <cmath>

#include "core/physics.h"
#include "model/effects/declarations.h"

namespace model::effects {

namespace {

/// The threshold is kept at a multiple of the noise floor, as a detector of constant false alarm rate does: more noise,
/// fewer weak echoes. The noise is the one that the receiver has after all effects before this one; a receiver without
/// noise keeps its threshold. The factor holds for the sensor's noise and not beam by beam.
///
/// `window` w > 0: over the first w metres the threshold also follows the range, as the power of a target does, so that
/// near haze and reflections in the window stay below it (sensitivity time control):
///
///   P_th(r) = P_th · k,   k = (w/r)² for r < w, 1 beyond
///
/// The crossings move with it as those of one Gaussian pulse do (formats.md section 3):
/// EPW'² = EPW² - (c FWHM)² log2 k, and the leading edge comes later by (EPW - EPW')/4. Echoes that overlap are still
/// told apart at the lower threshold.
/// Source: Richards 2014, Fundamentals of Radar Signal Processing, ch. 6.5 (constant false alarm rate); Skolnik 2001,
/// Introduction to Radar Systems, 3rd ed. (sensitivity time control).
class DynamicThreshold final : public Effect {
 public:
  explicit DynamicThreshold(const EffectParameters& parameters)
      : factor_(parameters.numberOr("factor", 5.0)), window_m_(parameters.numberOr("window", 0.0)) {}

  void prepare(ChainSettings& settings, const Environment&) override {
    if (settings.receiver.noise_w > 0.0) settings.receiver.threshold_w = factor_ * settings.receiver.noise_w;
  }
  [[nodiscard]] bool changesEchoes() const override { return window_m_ > 0.0; }
  void process(Echo& echo, const Receiver&, const ChainSettings& settings) const override {
    const double raised = raisedFor(echo, settings);
    if (raised <= 1.0) return;
    const double width_m = core::kMetresPerNanosecond * settings.emitter.pulse_fwhm_ns;
    const double square = echo.epw_m * echo.epw_m - width_m * width_m * std::log2(raised);
    const double narrower_m = echo.epw_m - std::sqrt(std::max(0.0, square));
    echo.epw_m -= narrower_m;
    if (settings.detection.range_mode == RangeMode::kLeadingEdge) echo.range_m += narrower_m / 4.0;
  }
  [[nodiscard]] bool reports() const override { return window_m_ > 0.0; }
  void report(std::vector<Echo>& echoes, const ChainSettings& settings, core::Random&) const override {
    for (Echo& echo : echoes) {
      const double raised = raisedFor(echo, settings);
      if (raised > 1.0 && echo.peak_w <= raised * settings.receiver.threshold_w) echo.fate = Fate::kBelowThreshold;
    }
  }

 private:
  /// k at the echo's peak, which lies a quarter of the width behind its leading edge.
  [[nodiscard]] double raisedFor(const Echo& echo, const ChainSettings& settings) const {
    const bool edge = settings.detection.range_mode == RangeMode::kLeadingEdge;
    const double peak_m = echo.range_m + (edge ? echo.epw_m / 4.0 : 0.0);
    return peak_m > 0.0 && peak_m < window_m_ ? window_m_ / peak_m * window_m_ / peak_m : 1.0;
  }

  double factor_;
  double window_m_;
};

}  // namespace

EffectEntry dynamicThreshold() {
  return {.info = {.name = "dynamic-threshold",
                   .title = "Threshold that follows the noise",
                   .summary = "The detection threshold is not fixed: it follows the noise or the distance, and with it "
                              "the width of echoes and what is lost.",
                   .stage = Stage::kPreProcessing,
                   .percollect = {"2", "43"},
                   .parameters = {{"factor", "", 1.0, 50.0, 5.0, "Threshold over standard deviation of the noise",
                                   false, 6.0},
                                  {"window", "m", 0.0, 100.0, 0.0,
                                   "Range up to which the threshold falls with the square of the range", false, 10.0}},
                   .fitted = {"factor"},
                   .other_forms = {{"falling with range", {"factor", "window"}}},
                   .source =
                       "Richards 2014, Fundamentals of Radar Signal Processing, ch. 6.5; Skolnik 2001, Introduction to "
                       "Radar Systems"},
          .make = makeFrom<DynamicThreshold>};
}

}  // namespace model::effects
