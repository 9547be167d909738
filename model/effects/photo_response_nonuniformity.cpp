#include <algorithm>
#include <cmath>

#include "model/effects/declarations.h"

namespace model::effects {

namespace {

/// The receiver elements of the layers differ in gain, and stay so: a fixed pattern, drawn once from `pattern`.
///   P = P_even · max(0.05, 1 + stddev · N(layer))
/// A measured pattern may be given in its place: `gain_per_layer`, P = P_even · gain. Sensors with more layers than the
/// pattern has repeat it.
/// Source: EMVA Standard 1288, release 4.0, sec. 4 (photo response nonuniformity).
class PhotoResponseNonuniformity final : public Effect {
 public:
  explicit PhotoResponseNonuniformity(const EffectParameters& parameters) {
    gain_ = parameters.listOr("gain_per_layer", {});
    if (!gain_.empty()) return;
    gain_.resize(kDrawnLayers);
    const double stddev = parameters.numberOr("stddev", 0.1);
    const auto pattern = static_cast<std::uint64_t>(std::llround(parameters.numberOr("pattern", 1.0)));
    core::Random random({.seed = pattern, .purpose = core::purposeOf("photo-response-nonuniformity")});
    for (double& gain : gain_) gain = std::max(0.05, 1.0 + stddev * random.normal());
  }

  [[nodiscard]] bool changesPower() const override { return true; }
  [[nodiscard]] double powerFactor(const Reflection& reflection) const override {
    return gain_[static_cast<std::size_t>(reflection.beam.layer) % gain_.size()];
  }

 private:
  static constexpr std::size_t kDrawnLayers = 256;
  std::vector<double> gain_;  ///< by layer
};

}  // namespace

EffectEntry photoResponseNonuniformity() {
  return {
      .info =
          {.name = "photo-response-nonuniformity",
           .title = "Uneven gain of the layers",
           .summary =
               "The layers are not equally sensitive: some report stronger echoes than others from the same surface.",
           .stage = Stage::kReception,
           .percollect = {"62", "66", "68"},
           .parameters = {{"stddev", "", 0.0, 0.5, 0.1, "Standard deviation of the gain over the layers", false, 0.15},
                          {.name = "pattern",
                           .max = 1e6,
                           .default_value = 1.0,
                           .meaning = "Which random pattern",
                           .typical = 1.0,
                           .seed = true}},
           .fitted = {"stddev"},
           .source = "EMVA Standard 1288, release 4.0"},
      .make = makeFrom<PhotoResponseNonuniformity>,
      .lists = {{"gain_per_layer", "", 0.0, 10.0, 0, "Gain of each layer, in place of the random pattern"}}};
}

}  // namespace model::effects
