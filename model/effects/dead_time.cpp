#include <algorithm>

#include "core/physics.h"
#include "model/effects/declarations.h"

namespace model::effects {

namespace {

/// After an echo the receiver is blind for a while (non-paralysable counter: an echo that it misses does not prolong
/// the blindness). An echo is lost if it comes less than c/2 · τ behind the last one that was seen. Source: Knoll 2010,
/// Radiation Detection and Measurement, ch. 4 VII.
class DeadTime final : public Effect {
 public:
  explicit DeadTime(const EffectParameters& parameters)
      : blind_m_(core::kMetresPerNanosecond * parameters.numberOr("dead_time_ns", 1.0) / 2.0) {}

  [[nodiscard]] bool reports() const override { return true; }
  void report(std::vector<Echo>& echoes, const ChainSettings&, core::Random&) const override {
    if (echoes.size() < 2) return;
    std::stable_sort(echoes.begin(), echoes.end(), [](const Echo& a, const Echo& b) { return a.range_m < b.range_m; });
    double seen_m = -blind_m_;
    for (Echo& echo : echoes) {
      if (echo.range_m - seen_m < blind_m_) {
        echo.fate = Fate::kBlinded;
      } else {
        seen_m = echo.range_m;
      }
    }
  }

 private:
  double blind_m_;
};

}  // namespace

EffectEntry deadTime() {
  return {
      .info = {.name = "dead-time",
               .title = "Dead time of the receiver",
               .summary = "After an echo the receiver is blind for a moment, and misses what follows shortly after.",
               .stage = Stage::kReception,
               .percollect = {"64", "67"},
               .parameters = {{"dead_time_ns", "ns", 1.0, 100.0, 1.0, "Blindness after an echo", true, 20.0}},
               .fitted = {"dead_time_ns"},
               .source = "Knoll 2010, Radiation Detection and Measurement, ch. 4"},
      .make = makeFrom<DeadTime>};
}

}  // namespace model::effects
