#include "model/effects/declarations.h"

namespace model::effects {

namespace {

/// Detections are reported at the centre of their beam, wherever in the beam the echo arose.
///
/// Switching this on changes no byte, and there is no hook below: a scanning sensor measures no direction within its
/// beam, it only knows where it pointed, so the reference chain reports the beam's centre in any case (formats.md
/// section 3, step 6). The alternative, directions of the sub-rays that made the echo, would be a sensor that does not
/// exist. The name stays for what a cause-effect graph calls an effect: a model file may list it to say that its author
/// knows of it. A diagnosis does not try it.
class AngleClipping final : public Effect {
 public:
  explicit AngleClipping(const EffectParameters&) {}
};

}  // namespace

EffectEntry angleClipping() {
  return {
      .info = {.name = "angle-clipping",
               .title = "Angle clipping to the beam's centre",
               .summary =
                   "Every detection is reported at the centre of its beam, wherever in the beam the echo came from.",
               .stage = Stage::kDetection,
               .source = "Rosenberger 2022, doi:10.26083/tuprints-00023034, ch. 10"},
      .make = makeFrom<AngleClipping>};
}

}  // namespace model::effects
