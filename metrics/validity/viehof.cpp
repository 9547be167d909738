#include "metrics/validity/viehof.h"

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <fmt/format.h>
#include <set>

#include "core/error.h"

namespace metrics {

namespace {

void check(const ViehofOptions& options) {
  if (0.0 <= options.red && options.red <= options.yellow && options.yellow <= options.green && options.green <= 1.0) {
    return;
  }
  throw core::InputError({.item = "thresholds of labels"},
                         fmt::format("are green {}, yellow {}, red {}; they must fall from at most 1 to at least 0.",
                                     options.green, options.yellow, options.red),
                         "Give shares of the simulated interval, the largest for green.");
}

double shareInside(const ToleranceInterval& inner, const ToleranceInterval& outer) {
  const double low = std::max(inner.low, outer.low);
  const double high = std::min(inner.high, outer.high);
  if (low > high) return 0.0;
  const double width = inner.high - inner.low;
  return width > 0.0 ? (high - low) / width : 1.0;
}

ValidityLabel labelOf(double share, const ViehofOptions& options) {
  if (share >= options.green) return ValidityLabel::Green;
  if (share >= options.yellow) return ValidityLabel::Yellow;
  return share > options.red ? ValidityLabel::Red : ValidityLabel::Black;
}

void mustBeDistinct(const std::vector<std::string>& names, const char* what) {
  if (names.empty()) {
    throw core::InputError({}, fmt::format("a validity map without {}s.", what), "Give at least one.");
  }
  std::set<std::string> seen;
  for (const std::string& name : names) {
    if (seen.insert(name).second) continue;
    throw core::InputError({.item = fmt::format("{} '{}'", what, name)}, "is twice in the map.",
                           "Give every name once.");
  }
}

}  // namespace

ToleranceInterval toleranceInterval(const Edf& repetitions, double confidence) {
  if (!(confidence > 0.0 && confidence < 1.0)) {
    throw core::InputError({.item = "confidence"}, fmt::format("is {}; it must lie between 0 and 1.", confidence),
                           "Give 0.95 for 95 per cent.");
  }
  const double deviation = repetitions.standardDeviation();
  if (std::isnan(deviation)) {
    throw core::InputError({}, "a tolerance interval needs two repetitions or more.", "Repeat the experiment.");
  }
  const auto n = static_cast<double>(repetitions.n());
  const double t = boost::math::quantile(boost::math::students_t(n - 1.0), 0.5 * (1.0 + confidence));
  const double half = t * deviation * std::sqrt(1.0 + 1.0 / n);
  return {.low = repetitions.mean() - half, .high = repetitions.mean() + half};
}

ViehofResult viehofLabel(const SamplePair& samples, const ViehofOptions& options) {
  check(options);
  const ToleranceInterval measured = toleranceInterval(samples.measured, options.confidence);
  const ToleranceInterval simulated =
      samples.simulated.n() == 1 ? ToleranceInterval{.low = samples.simulated.min(), .high = samples.simulated.min()}
                                 : toleranceInterval(samples.simulated, options.confidence);
  const double share = shareInside(simulated, measured);
  return {.simulated = simulated, .measured = measured, .share_inside = share, .label = labelOf(share, options)};
}

ValidityMap::ValidityMap(std::vector<std::string> parameter_samples, std::vector<std::string> measurands)
    : rows_(std::move(parameter_samples)), columns_(std::move(measurands)) {
  mustBeDistinct(rows_, "parameter sample");
  mustBeDistinct(columns_, "measurand");
  labels_.assign(rows_.size() * columns_.size(), ValidityLabel::Green);
}

ValidityLabel& ValidityMap::at(std::size_t parameter_sample, std::size_t measurand) {
  return labels_.at(parameter_sample * columns_.size() + measurand);
}

ValidityLabel ValidityMap::at(std::size_t parameter_sample, std::size_t measurand) const {
  return labels_.at(parameter_sample * columns_.size() + measurand);
}

ValidityLabel ValidityMap::worstOf(std::size_t parameter_sample) const {
  const auto row = std::span(labels_).subspan(parameter_sample * columns_.size(), columns_.size());
  return *std::max_element(row.begin(), row.end());
}

double ValidityMap::shareUpTo(ValidityLabel label) const {
  const auto as_good = std::count_if(labels_.begin(), labels_.end(), [label](ValidityLabel x) { return x <= label; });
  return static_cast<double>(as_good) / static_cast<double>(labels_.size());
}

}  // namespace metrics
