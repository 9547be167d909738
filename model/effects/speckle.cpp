#include "model/effects/declarations.h"

namespace model::effects {

namespace {

/// Coherent light on a rough surface: the received power fluctuates from shot to shot with a gamma distribution of mean
/// 1 and variance 1/M, M the number of independent speckle looks over aperture, band and surface depth. What air and
/// drops send back comes from a depth of pulse lengths, many times the coherence length of a pulsed laser diode: its
/// looks are so many that it does not fluctuate. Source: Goodman 2007, Speckle Phenomena in Optics, sec. 4.4.
class Speckle final : public Effect {
 public:
  explicit Speckle(const EffectParameters& parameters) : looks_(parameters.numberOr("looks", 20.0)) {}

  [[nodiscard]] bool fluctuates() const override { return true; }
  [[nodiscard]] bool fluctuatesOnSurfaces() const override { return true; }
  [[nodiscard]] double fluctuation(const Beam&, core::Random& random) const override {
    return random.gamma(looks_) / looks_;
  }

 private:
  double looks_;
};

}  // namespace

EffectEntry speckle() {
  return {.info = {.name = "speckle",
                   .title = "Speckle",
                   .summary = "Coherent light makes the strength of a surface's echo fluctuate at random, in "
                              "proportion to its strength.",
                   .stage = Stage::kInteraction,
                   .percollect = {"148", "153"},
                   .parameters = {{"looks", "", 1.0, 100.0, 20.0, "Independent speckle patterns that are averaged",
                                   true, 20.0}},
                   .fitted = {"looks"},
                   .source = "Goodman 2007, Speckle Phenomena in Optics, sec. 4.4"},
          .make = makeFrom<Speckle>};
}

}  // namespace model::effects
