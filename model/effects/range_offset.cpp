#include "model/effects/declarations.h"

namespace model::effects {

namespace {

/// Constant timing offset: every range is off by the same length.
class RangeOffset final : public Effect {
 public:
  explicit RangeOffset(const EffectParameters& parameters) : offset_m_(parameters.numberOr("offset_m", 0.0)) {}
  void prepare(ChainSettings& settings, const Environment&) override { settings.range_offset_m += offset_m_; }

 private:
  double offset_m_;
};

}  // namespace

EffectEntry rangeOffset() {
  return {.info = {.name = "range-offset",
                   .title = "Range offset",
                   .summary = "All ranges are wrong by the same amount.",
                   .stage = Stage::kPreProcessing,
                   .parameters = {{"offset_m", "m", -0.5, 0.5, 0.0, "Reported minus true range", false, 0.02}},
                   .fitted = {"offset_m"},
                   .source = "Glennie & Lichti 2010, doi:10.3390/rs2061610, eq. 1"},
          .make = makeFrom<RangeOffset>};
}

}  // namespace model::effects
