#include "acceptance/sample_values.h"

#include <algorithm>
#include <array>
#include <limits>
#include <string_view>

#include "core/error.h"
#include "gap/distance/existence.h"

namespace acceptance {

namespace {

constexpr double kUndefined = std::numeric_limits<double>::quiet_NaN();

/// What every report shows, used or not.
constexpr std::array<std::string_view, 7> kAlways = {"d_avm",  "d_plus",        "d_minus",  "d_bias",
                                                     "d_cavm", "residual_bias", "pbox_area"};

std::vector<double> column(const core::Detections& detections, const std::string& name, std::string_view side) {
  if (detections.size() == 0) return {};
  const std::vector<double>* values = detections.values(name);
  if (!values) {
    throw core::InputError({.item = std::string(side)}, "has no column '" + name + "'.",
                           "Choose a measurand that both the measurement and the model's output have.");
  }
  return *values;
}

bool isShown(const metrics::Metric& metric, std::span<const std::string> wanted) {
  return std::find(kAlways.begin(), kAlways.end(), metric.info.name) != kAlways.end() || isWanted(metric, wanted);
}

void addMetrics(std::map<std::string, double>& values, const Distributions& distributions, metrics::Scale scale,
                std::span<const std::string> wanted, const metrics::MetricOptions& options) {
  const metrics::Edf measured(distributions.measured);
  std::vector<metrics::Edf> runs;
  std::vector<double> pooled;
  for (const std::vector<double>& run : distributions.simulated) {
    runs.emplace_back(run);
    pooled.insert(pooled.end(), run.begin(), run.end());
  }
  const metrics::PBox measured_box = measured;
  const metrics::PBox simulated_box = metrics::PBox::envelope(runs);
  const metrics::Edf simulated(std::move(pooled));
  const metrics::MetricInput input({.simulated = simulated_box, .measured = measured_box},
                                   {.simulated = simulated, .measured = measured}, options);
  for (const metrics::Metric& metric : metrics::metricCatalog()) {
    if (!isShown(metric, wanted) || !metrics::isMeaningful(metric.info, scale)) continue;
    const std::vector<double> numbers = metric.compute(input);
    for (std::size_t part = 0; part < numbers.size(); ++part) values[variableName(metric, part)] = numbers[part];
  }
}

}  // namespace

std::string variableName(const metrics::Metric& metric, std::size_t part) {
  if (metric.parts.empty()) return std::string(metric.info.name);
  return std::string(metric.info.name) + "_" + std::string(metric.parts[part]);
}

bool isWanted(const metrics::Metric& metric, std::span<const std::string> wanted) {
  if (std::find(wanted.begin(), wanted.end(), metric.info.name) != wanted.end()) return true;
  for (std::size_t part = 0; part < metric.parts.size(); ++part) {
    if (std::find(wanted.begin(), wanted.end(), variableName(metric, part)) != wanted.end()) return true;
  }
  return false;
}

bool Distributions::complete() const {
  return !measured.empty() && std::none_of(simulated.begin(), simulated.end(), [](auto& run) { return run.empty(); });
}

Distributions distributionsOf(const Sides& sides) {
  Distributions distributions;
  distributions.measured = column(sides.measured, sides.column, "measurement");
  for (const core::Detections& run : sides.simulated) {
    distributions.simulated.push_back(column(run, sides.column, "simulation"));
  }
  return distributions;
}

std::map<std::string, double> valuesOf(const Sides& sides, const Distributions& distributions,
                                       std::span<const std::string> wanted, const metrics::MetricOptions& options) {
  std::map<std::string, double> values;
  for (const metrics::Metric& metric : metrics::metricCatalog()) {
    for (std::size_t part = 0; part < std::max<std::size_t>(1, metric.parts.size()); ++part) {
      if (isShown(metric, wanted)) values[variableName(metric, part)] = kUndefined;
    }
  }
  if (distributions.complete()) addMetrics(values, distributions, sides.scale, wanted, options);

  const gap::Frames measured = {sides.measured, sides.measured_frames};
  const gap::Frames simulated = {sides.simulated.front(), sides.simulated_frames};
  const gap::ExistenceGap existence = gap::existenceGap(simulated, measured);
  values["n_real"] = static_cast<double>(sides.measured.size());
  values["n_sim"] = static_cast<double>(sides.simulated.front().size());
  values["frames_real"] = sides.measured_frames;
  values["frames_sim"] = sides.simulated_frames;
  values["detection_rate_real"] = gap::detectionRate(measured, sides.beams_per_frame);
  values["detection_rate_sim"] = gap::detectionRate(simulated, sides.beams_per_frame);
  values["missing_fraction"] = existence.missing;
  values["extra_fraction"] = existence.extra;
  return values;
}

}  // namespace acceptance
