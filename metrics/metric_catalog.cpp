#include "metrics/metric_catalog.h"

#include <algorithm>
#include <array>
#include <string>

#include "core/error.h"
#include "core/text.h"
#include "metrics/area/area_metrics.h"
#include "metrics/grids/grid_metrics.h"
#include "metrics/objects/object_metrics.h"
#include "metrics/points/point_metrics.h"
#include "metrics/samples/samples_metrics.h"
#include "metrics/series/series_metrics.h"

namespace metrics {

namespace {

constexpr std::array<std::string_view, 4> kScales = {"nominal", "ordinal", "interval", "ratio"};
constexpr std::array<std::string_view, 7> kDataKinds = {"values",         "series",      "point-cloud", "range-image",
                                                        "occupancy-grid", "object-list", "tracks"};

/// A metric of two samples as one of two p-boxes: it takes the pooled runs.
Metric ofPooledRuns(const MetricOf<SamplePair>& metric) {
  return {.info = metric.info,
          .shape = metric.shape,
          .parts = metric.parts,
          .compute = [compute = metric.compute](const MetricInput& input) { return compute(input.samples); }};
}

std::vector<Metric> makeCatalog() {
  std::vector<Metric> catalog(areaMetrics().begin(), areaMetrics().end());
  for (const MetricOf<SamplePair>& metric : samplesMetrics()) catalog.push_back(ofPooledRuns(metric));
  return catalog;
}

template <typename Input>
void append(std::span<const MetricOf<Input>> metrics, std::vector<MetricInfo>& infos) {
  for (const MetricOf<Input>& metric : metrics) infos.push_back(metric.info);
}

}  // namespace

std::span<const Metric> metricCatalog() {
  static const std::vector<Metric> catalog = makeCatalog();
  return catalog;
}

const Metric& metricNamed(std::string_view name) {
  std::vector<std::string> names;
  for (const Metric& metric : metricCatalog()) {
    if (metric.info.name == name) return metric;
    names.emplace_back(metric.info.name);
  }
  const std::string nearest = core::nearestName(name, names);
  throw core::InputError(
      {.item = "metric '" + std::string(name) + "'"}, "is not known.",
      nearest.empty() ? "The metrics are " + core::join(names) + "." : "Did you mean '" + nearest + "'?");
}

std::vector<MetricInfo> allMetricInfos() {
  std::vector<MetricInfo> infos;
  append<MetricInput>(metricCatalog(), infos);
  append<SeriesInput>(seriesMetrics(), infos);
  append<GridInput>(gridMetrics(), infos);
  append<RangeImageInput>(rangeImageMetrics(), infos);
  append<PointCloudInput>(pointMetrics(), infos);
  append<ObjectListInput>(objectMetrics(), infos);
  append<TracksInput>(trackMetrics(), infos);
  std::stable_sort(infos.begin(), infos.end(), [](const MetricInfo& a, const MetricInfo& b) {
    constexpr int kLast = 1000;
    return (a.number == 0 ? kLast : a.number) < (b.number == 0 ? kLast : b.number);
  });
  return infos;
}

std::string_view toString(Scale scale) { return kScales[static_cast<std::size_t>(scale)]; }
std::string_view toString(DataKind kind) { return kDataKinds[static_cast<std::size_t>(kind)]; }

Scale scaleNamed(std::string_view name) {
  const auto found = std::find(kScales.begin(), kScales.end(), name);
  if (found != kScales.end()) return static_cast<Scale>(found - kScales.begin());
  throw core::InputError({.item = "scale '" + std::string(name) + "'"}, "is not known.",
                         "The scales of measurement are nominal, ordinal, interval and ratio.");
}

}  // namespace metrics
