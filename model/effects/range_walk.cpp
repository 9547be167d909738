#include <cmath>

#include "core/physics.h"
#include "model/effects/declarations.h"

namespace model::effects {

namespace {

/// A comparator fires on the pulse's leading edge: strong echoes cross the threshold earlier, so weak echoes come out
/// too far. Without a coefficient the range is the rising crossing itself, in place of peak or centre:
///
///   r = r_peak - c FWHM/4 · sqrt(log2(P/P_th))          (Gaussian pulse, formats.md section 3)
///
/// `calibrated_at_snr`: the sensor's constant offset is set so that an echo of that peak power over threshold is right.
/// `coefficient_m` k: linear front instead, r = r_peak + k · P_th/P, the first-order walk of a constant-slope edge.
/// Source: Amann et al. 2001, doi:10.1117/1.1330700, sec. 3.3.
class RangeWalk final : public Effect {
 public:
  explicit RangeWalk(const EffectParameters& parameters)
      : coefficient_m_(parameters.number("coefficient_m")),
        calibrated_at_snr_(parameters.number("calibrated_at_snr")) {}

  void prepare(ChainSettings& settings, const Environment&) override {
    if (coefficient_m_) return;
    settings.detection.range_mode = RangeMode::kLeadingEdge;
    if (calibrated_at_snr_ && *calibrated_at_snr_ > 1.0) {
      const double width_m = core::kMetresPerNanosecond * settings.emitter.pulse_fwhm_ns / 2.0;
      settings.range_offset_m += width_m / 2.0 * std::sqrt(std::log2(*calibrated_at_snr_));
    }
  }
  [[nodiscard]] bool changesEchoes() const override { return coefficient_m_.has_value(); }
  void process(Echo& echo, const Receiver& receiver, const ChainSettings&) const override {
    if (echo.peak_w > 0.0) echo.range_m += *coefficient_m_ * receiver.threshold_w / echo.peak_w;
  }

 private:
  std::optional<double> coefficient_m_;
  std::optional<double> calibrated_at_snr_;
};

}  // namespace

EffectEntry rangeWalk() {
  return {
      .info = {.name = "range-walk",
               .title = "Range walk",
               .summary = "The reported range depends on how strong an echo is: a weak one crosses the threshold later "
                          "than a strong one, and so comes out too far away.",
               .stage = Stage::kPreProcessing,
               .percollect = {"2", "39"},
               .parameters = {{"coefficient_m", "m", -2.0, 2.0, std::nullopt,
                               "Linear front: error of an echo at the threshold", false, 0.1},
                              {"calibrated_at_snr", "", 1.0, 1e6, std::nullopt,
                               "Peak power over threshold at which the range is right; without it the bare crossing",
                               true, 50.0}},
               .fitted = {"calibrated_at_snr"},
               .other_forms = {{"bare crossing", {}}, {"linear front", {"coefficient_m"}}},
               .source = "Amann et al. 2001, doi:10.1117/1.1330700"},
      .make = makeFrom<RangeWalk>};
}

}  // namespace model::effects
