#include <algorithm>

#include "model/effects/declarations.h"

namespace model::effects {

namespace {

/// The receiver's output clips at a power: the reported peak is capped. Where the waveform crosses the threshold it is
/// unchanged, as long as the cap lies above the threshold, so range and EPW stay (slow recovery is dead-time's).
/// Source: Wagner et al. 2006, doi:10.1016/j.isprsjprs.2005.12.001 (dynamic range of full-waveform receivers).
class Saturation final : public Effect {
 public:
  explicit Saturation(const EffectParameters& parameters) : saturation_w_(parameters.number("saturation_w")) {}

  void prepare(ChainSettings& settings, const Environment&) override {
    if (saturation_w_) settings.receiver.saturation_w = saturation_w_;
  }
  [[nodiscard]] bool changesEchoes() const override { return true; }
  void process(Echo& echo, const Receiver& receiver, const ChainSettings&) const override {
    if (receiver.saturation_w) echo.peak_w = std::min(echo.peak_w, *receiver.saturation_w);
  }

 private:
  std::optional<double> saturation_w_;
};

}  // namespace

EffectEntry saturation() {
  return {.info = {.name = "saturation",
                   .title = "Saturation of the receiver",
                   .stage = Stage::kReception,
                   .percollect = {"142"},
                   .parameters = {{"saturation_w", "W", 1e-10, 1e-3, std::nullopt,
                                   "Power at which the output clips; without it the profile's", true, 1e-6}},
                   .fitted = {"saturation_w"},
                   .source = "Wagner et al. 2006, doi:10.1016/j.isprsjprs.2005.12.001"},
          .make = makeFrom<Saturation>};
}

}  // namespace model::effects
