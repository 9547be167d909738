#include <cmath>

#include "model/effects/declarations.h"
#include "model/overlap.h"

namespace model::effects {

namespace {

/// Emitter and receiver look out side by side: near the sensor the receiver does not see the whole illuminated spot.
/// P = P_coaxial · χ(r), see model/overlap.h.
class ApertureOffset final : public Effect {
 public:
  explicit ApertureOffset(const EffectParameters& parameters) : given_m_(parameters.number("offset_m")) {}

  void prepare(ChainSettings& settings, const Environment&) override {
    settings.receiver.axis_offset_m = std::abs(given_m_.value_or(settings.receiver.axis_offset_m));
    emitter_ = settings.emitter;
    receiver_ = settings.receiver;
  }
  [[nodiscard]] bool changesPower() const override { return true; }
  [[nodiscard]] double powerFactor(const Reflection& reflection) const override {
    return overlap(emitter_, receiver_, reflection.range_m);
  }

 private:
  std::optional<double> given_m_;
  Emitter emitter_;
  Receiver receiver_;
};

}  // namespace

EffectEntry apertureOffset() {
  return {.info = {.name = "aperture-offset",
                   .title = "Offset of the receiver's axis",
                   .summary = "Emitter and receiver look along axes side by side, so that the receiver misses a part "
                              "of the beam at short range.",
                   .stage = Stage::kEmission,
                   .percollect = {"14", "73", "107"},
                   .parameters = {{"offset_m", "m", 0.0, 0.1, std::nullopt,
                                   "Distance of the axes; without it the profile's", false, 0.03}},
                   .fitted = {"offset_m"},
                   .source = "Stelmaszczyk et al. 2005, doi:10.1364/AO.44.001323"},
          .make = makeFrom<ApertureOffset>};
}

}  // namespace model::effects
