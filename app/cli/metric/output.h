#pragma once

#include <iosfwd>
#include <nlohmann/json.hpp>
#include <span>

#include "app/cli/metric/result.h"

namespace app {

/// "fidelis-metric" as formats.md names it.
[[nodiscard]] nlohmann::ordered_json metricDocument(std::span<const MeasurandResult> measurands,
                                                    const MetricRequest& request);

/// For a reader at a terminal.
void writeMetricTable(std::span<const MeasurandResult> measurands, std::ostream& out);

/// Every metric of the program: as a table in Markdown (the one in docs/metrics.md), or as JSON.
[[nodiscard]] std::string metricListAsMarkdown();
[[nodiscard]] nlohmann::ordered_json metricListAsJson();

}  // namespace app
