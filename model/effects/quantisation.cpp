#include <cmath>

#include "model/effects/declarations.h"

namespace model::effects {

namespace {

/// Coarse counters: the outputs come in these steps, and are then rounded to the profile's resolution as all outputs
/// are (formats.md section 3, step 6). With `intensity_bits` the intensity has 2^bits levels up to the full scale.
class Quantisation final : public Effect {
 public:
  explicit Quantisation(const EffectParameters& parameters) : parameters_(parameters) {}

  void prepare(ChainSettings& settings, const Environment&) override {
    CounterSteps& counters = settings.counters;
    counters.range_m = parameters_.numberOr("range_step_m", counters.range_m);
    counters.epw_m = parameters_.numberOr("epw_step_m", counters.epw_m);
    if (const auto bits = parameters_.number("intensity_bits")) {
      counters.intensity_full_scale_nw = parameters_.numberOr("intensity_full_scale_nw", 1e5);
      counters.intensity_nw = counters.intensity_full_scale_nw / (std::exp2(std::round(*bits)) - 1.0);
    }
  }

 private:
  EffectParameters parameters_;
};

}  // namespace

EffectEntry quantisation() {
  return {.info = {.name = "quantisation",
                   .title = "Quantisation of the outputs",
                   .summary = "Values are reported in coarse steps.",
                   .stage = Stage::kPreProcessing,
                   .percollect = {"70", "71", "144"},
                   .parameters =
                       {{"range_step_m", "m", 0.0, 2.0, std::nullopt, "Step of the range", true, 0.1},
                        {"epw_step_m", "m", 0.0, 2.0, std::nullopt, "Step of the echo pulse width", true, 0.2},
                        {"intensity_bits", "", 1.0, 24.0, std::nullopt, "Bits of the intensity", false, 8.0, 0.0, true},
                        {"intensity_full_scale_nw", "nW", 1.0, 1e9, 1e5, "Intensity of the highest level", true, 1e5}},
                   .fitted = {"range_step_m"},
                   .other_forms = {{"echo pulse width", {"epw_step_m"}}, {"intensity", {"intensity_bits"}}},
                   .source = "Widrow & Kollár 2008, Quantization Noise, ch. 4"},
          .make = makeFrom<Quantisation>};
}

}  // namespace model::effects
