#include <cmath>
#include <limits>

#include "core/physics.h"
#include "model/effects/declarations.h"
#include "model/sensor/saturation_knee.h"

namespace model::effects {

namespace {

/// The receiver's output clips at a power: the reported peak is capped. Where the waveform crosses the threshold it is
/// unchanged by the clipping itself, as long as the cap lies above the threshold. An overdriven amplifier recovers
/// slowly: its overdrive decays with the time constant τ = `recovery_ns`, so the falling crossing comes late,
///
///   P_out = min(P, P_sat),   EPW' = EPW + c τ ln(P/P_sat) for P > P_sat
///
/// and with range at the centre of the crossings r' = r + c/4 · τ ln(P/P_sat); peak and leading edge stay. (What the
/// receiver cannot see meanwhile is dead-time's.) The recovery is that of a first-order stage.
/// An amplifier may bend long before it clips, with a knee of some sharpness; noise comes behind it
/// (saturation_knee.h). Source: Wagner et al. 2006, doi:10.1016/j.isprsjprs.2005.12.001 (dynamic range of full-waveform
/// receivers); Rapp 1991, Proc. 2nd European Conf. on Satellite Communications, ESA SP-332, pp. 179-184 (the knee).
class Saturation final : public Effect {
 public:
  explicit Saturation(const EffectParameters& parameters)
      : saturation_w_(parameters.number("saturation_w")),
        recovery_ns_(parameters.numberOr("recovery_ns", 0.0)),
        knee_sharpness_(parameters.number("knee_sharpness")) {}

  void prepare(ChainSettings& settings, const Environment&) override {
    Receiver& receiver = settings.receiver;
    if (saturation_w_) receiver.saturation_w = saturation_w_;
    receiver.knee_sharpness = knee_sharpness_.value_or(std::numeric_limits<double>::infinity());
  }
  [[nodiscard]] bool changesEchoes() const override { return true; }
  [[nodiscard]] double processesAbove_w(const Receiver& receiver) const override {
    constexpr double kHardlyBent = 1e-4;  // of the power, below which it is left as it is
    const double most_w = receiver.saturation_w.value_or(std::numeric_limits<double>::infinity());
    return knee_sharpness_ ? most_w * std::pow(*knee_sharpness_ * kHardlyBent, 1.0 / *knee_sharpness_) : most_w;
  }
  void process(Echo& echo, const Receiver& receiver, const ChainSettings& settings) const override {
    if (!receiver.saturation_w) return;
    const double ratio = echo.signal_w() / *receiver.saturation_w;
    if (ratio > 1.0 && recovery_ns_ > 0.0) {
      const double later_m = core::kMetresPerNanosecond * recovery_ns_ * std::log(ratio);
      echo.epw_m += later_m;
      if (settings.detection.range_mode == RangeMode::kCentre) echo.range_m += later_m / 4.0;
    }
    echo.peak_w = outputOf_w(echo.signal_w(), receiver) + echo.noise_w;
  }

 private:
  std::optional<double> saturation_w_;
  double recovery_ns_;
  std::optional<double> knee_sharpness_;
};

}  // namespace

EffectEntry saturation() {
  return {.info = {.name = "saturation",
                   .title = "Saturation of the receiver",
                   .summary = "The receiver cannot follow echoes above a certain power: they are cut off, and come out "
                              "too weak and with another width.",
                   .stage = Stage::kReception,
                   .percollect = {"142"},
                   .parameters = {{"saturation_w", "W", 1e-10, 1e-3, std::nullopt,
                                   "Power at which the output clips; without it the profile's", true, 1e-6},
                                  {"recovery_ns", "ns", 0.0, 50.0, 0.0, "Time constant of the recovery", false, 5.0},
                                  {"knee_sharpness", "", 1.0, 50.0, std::nullopt,
                                   "How suddenly the output bends; without it, it clips", true, 4.0}},
                   .fitted = {"saturation_w"},
                   .other_forms = {{"with recovery", {"saturation_w", "recovery_ns"}},
                                   {"soft knee", {"saturation_w", "knee_sharpness"}}},
                   .source = "Wagner et al. 2006, doi:10.1016/j.isprsjprs.2005.12.001; Rapp 1991, ESA SP-332, 179-184"},
          .make = makeFrom<Saturation>};
}

}  // namespace model::effects
