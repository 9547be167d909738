#pragma once

#include <optional>
#include <span>
#include <vector>

#include "app/cli/metric/result.h"
#include "app/cli/session.h"
#include "metrics/resampling/unit_sample.h"

namespace app {

/// Values of one column with the unit (frame, set-up) of each; no units if none were asked for.
struct ChanceSample {
  std::vector<double> values;
  std::vector<std::uint32_t> units;

  [[nodiscard]] metrics::UnitSample view() const { return {.values = values, .units = units}; }
};

/// Both sides of one column.
struct ChanceSamples {
  ChanceSample measured;
  std::vector<ChanceSample> simulated;

  [[nodiscard]] metrics::UnitComparison view() const;
};

/// What chance does to the results: bootstrap intervals, floors and p-values of the area metrics, needed repetitions;
/// each only if the request asks for it. Throws InputError for a metric whose interval or repetitions cannot be had.
void addChance(const ChanceSamples& samples, const MetricRequest& request, const Session& session,
               MeasurandResult& measurand);

}  // namespace app
