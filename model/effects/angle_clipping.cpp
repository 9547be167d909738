#include "model/effects/declarations.h"

namespace model::effects {

namespace {

/// Detections are reported at the centre of their beam, wherever in the beam the echo arose. The reference chain
/// reports so in any case (formats.md section 3, step 6), so switching this on changes no byte; a model file may list
/// it to say that its author knows, and the graph's node is then covered by the model.
class AngleClipping final : public Effect {
 public:
  explicit AngleClipping(const EffectParameters&) {}
};

}  // namespace

EffectEntry angleClipping() {
  return {.info = {.name = "angle-clipping",
                   .title = "Angle clipping to the beam's centre",
                   .stage = Stage::kDetection,
                   .source = "Rosenberger 2022, doi:10.26083/tuprints-00023034, ch. 10"},
          .make = makeFrom<AngleClipping>};
}

}  // namespace model::effects
