#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "metrics/metric_info.h"
#include "metrics/value_input.h"

namespace metrics {

/// Every metric of values, in the order in which results are written. Each room has a list of its own; this joins
/// those of `area` and `samples`.
[[nodiscard]] std::span<const Metric> metricCatalog();

/// Throws InputError that names the nearest metric if there is none of this name.
[[nodiscard]] const Metric& metricNamed(std::string_view name);

/// What is known of the metrics of all rooms, for tables: ascending number in Tab. 4-3, then those that are not in it.
[[nodiscard]] std::vector<MetricInfo> allMetricInfos();

/// Whether a metric means something on data of a scale.
[[nodiscard]] constexpr bool isMeaningful(const MetricInfo& metric, Scale of_data) { return of_data >= metric.scale; }

[[nodiscard]] std::string_view toString(Scale scale);
[[nodiscard]] std::string_view toString(DataKind kind);

/// "nominal", "ordinal", "interval" or "ratio". Throws InputError that lists them for anything else.
[[nodiscard]] Scale scaleNamed(std::string_view name);

}  // namespace metrics
