#include "model/effects/declarations.h"

namespace model::effects {

namespace {

/// The threshold is kept at a multiple of the noise floor, as a detector of constant false alarm rate does: more noise,
/// fewer weak echoes. The noise is the one that the receiver has after all effects before this one; a receiver without
/// noise keeps its threshold.
/// Source: Richards 2014, Fundamentals of Radar Signal Processing, ch. 6.5.
class DynamicThreshold final : public Effect {
 public:
  explicit DynamicThreshold(const EffectParameters& parameters) : factor_(parameters.numberOr("factor", 5.0)) {}

  void prepare(ChainSettings& settings, const Environment&) override {
    if (settings.receiver.noise_w > 0.0) settings.receiver.threshold_w = factor_ * settings.receiver.noise_w;
  }

 private:
  double factor_;
};

}  // namespace

EffectEntry dynamicThreshold() {
  return {.info = {.name = "dynamic-threshold",
                   .title = "Threshold that follows the noise",
                   .stage = Stage::kPreProcessing,
                   .percollect = {"2", "43"},
                   .parameters = {{"factor", "", 1.0, 50.0, 5.0, "Threshold over standard deviation of the noise",
                                   false, 6.0}},
                   .fitted = {"factor"},
                   .source = "Richards 2014, Fundamentals of Radar Signal Processing, ch. 6.5"},
          .make = makeFrom<DynamicThreshold>};
}

}  // namespace model::effects
