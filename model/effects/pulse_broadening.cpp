#include "model/effects/declarations.h"

namespace model::effects {

namespace {

/// The spread of ranges over the footprint of an oblique or stepped surface widens the echo: every sub-ray returns its
/// own pulse (formats.md section 3, step 3). Off: sub-rays on one object count at their power-weighted mean range.
class PulseBroadening final : public Effect {
 public:
  explicit PulseBroadening(const EffectParameters&) {}
  void prepare(ChainSettings& settings, const Environment&) override { settings.broadens_pulses = true; }
};

}  // namespace

EffectEntry pulseBroadening() {
  return {.info = {.name = "pulse-broadening",
                   .title = "Pulse broadening on oblique surfaces",
                   .summary = "On an oblique surface the light of one beam comes back over a longer time: the echo is "
                              "wider and lower.",
                   .stage = Stage::kInteraction,
                   .percollect = {"109", "116"},
                   .source = "Gardner 1992, doi:10.1109/36.175330"},
          .make = makeFrom<PulseBroadening>};
}

}  // namespace model::effects
