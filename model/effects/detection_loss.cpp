#include "model/effects/declarations.h"

namespace model::effects {

namespace {

/// Random misses: every echo is lost with the same probability, independently (Bernoulli).
class DetectionLoss final : public Effect {
 public:
  explicit DetectionLoss(const EffectParameters& parameters) : probability_(parameters.numberOr("probability", 0.0)) {}

  [[nodiscard]] bool reports() const override { return true; }
  void report(std::vector<Echo>& echoes, const ChainSettings&, core::Random& random) const override {
    for (Echo& echo : echoes) {
      if (random.uniform() < probability_) echo.fate = Fate::kLost;
    }
  }

 private:
  double probability_;
};

}  // namespace

EffectEntry detectionLoss() {
  return {.info = {.name = "detection-loss",
                   .title = "Random loss of detections",
                   .summary = "Detections are lost at random, whatever the echo's strength.",
                   .stage = Stage::kDetection,
                   .percollect = {"0", "39"},
                   .parameters = {{"probability", "", 0.0, 1.0, 0.0, "Probability of losing an echo", false, 0.05}},
                   .fitted = {"probability"},
                   .source = "Bernoulli trials",
                   .every_shot_alike = true},
          .make = makeFrom<DetectionLoss>};
}

}  // namespace model::effects
