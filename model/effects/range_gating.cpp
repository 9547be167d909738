#include <algorithm>

#include "model/effects/declarations.h"

namespace model::effects {

namespace {

/// The receiver is open for a window of time only: echoes outside [from, to] are dropped, as those outside the
/// profile's own range are. Source: Busck & Heiselberg 2004, doi:10.1364/AO.43.004705.
class RangeGating final : public Effect {
 public:
  explicit RangeGating(const EffectParameters& parameters)
      : from_m_(parameters.number("from_m")), to_m_(parameters.number("to_m")) {}
  void prepare(ChainSettings& settings, const Environment&) override {
    DetectionStage& stage = settings.detection;
    stage.min_range_m = std::max(stage.min_range_m, from_m_.value_or(stage.min_range_m));
    stage.max_range_m = std::min(stage.max_range_m, to_m_.value_or(stage.max_range_m));
  }

 private:
  std::optional<double> from_m_;
  std::optional<double> to_m_;
};

}  // namespace

EffectEntry rangeGating() {
  return {.info = {.name = "range-gating",
                   .title = "Range gate",
                   .summary = "Echoes outside a window of distances are not reported.",
                   .stage = Stage::kPreProcessing,
                   .percollect = {"146"},
                   .parameters = {{"from_m", "m", 0.0, 1000.0, std::nullopt,
                                   "Nearest range reported; without it the profile's", false, 2.0},
                                  {"to_m", "m", 0.0, 1000.0, std::nullopt,
                                   "Farthest range reported; without it the profile's", false, 50.0}},
                   .fitted = {"from_m", "to_m"},
                   .source = "Busck & Heiselberg 2004, doi:10.1364/AO.43.004705"},
          .make = makeFrom<RangeGating>};
}

}  // namespace model::effects
