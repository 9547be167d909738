#include "metrics/distributions/propagation.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "core/error.h"

namespace metrics {

namespace {

void mustBeOutputs(const std::vector<double>& outputs, std::size_t sample) {
  if (outputs.empty()) {
    throw core::InputError({.item = fmt::format("aleatory sample {}", sample)},
                           "has no output; each needs one for every epistemic choice.",
                           "Simulate it, or remove the sample.");
  }
  const auto bad = std::find_if(outputs.begin(), outputs.end(), [](double y) { return !std::isfinite(y); });
  if (bad == outputs.end()) return;
  throw core::InputError(
      {.item = fmt::format("aleatory sample {}, epistemic choice {}", sample, bad - outputs.begin() + 1)},
      fmt::format("is {}; a distribution needs finite numbers.", *bad),
      "Remove or correct it; nothing is dropped silently.");
}

void mustBeInterval(const Interval& value, std::size_t row) {
  if (std::isfinite(value.low) && std::isfinite(value.high) && value.low <= value.high) return;
  throw core::InputError({.item = fmt::format("value {}", row)},
                         fmt::format("[{}, {}] is no interval.", value.low, value.high),
                         "Give two finite ends, the lower one first.");
}

}  // namespace

PBox aleatoryOuter(std::span<const std::vector<double>> outputs) {
  std::vector<Interval> ranges;
  ranges.reserve(outputs.size());
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    mustBeOutputs(outputs[i], i + 1);
    const auto [low, high] = std::minmax_element(outputs[i].begin(), outputs[i].end());
    ranges.push_back({.low = *low, .high = *high});
  }
  return fromIntervals(ranges);
}

PBox fromIntervals(std::span<const Interval> values) {
  std::vector<double> low;
  std::vector<double> high;
  low.reserve(values.size());
  high.reserve(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    mustBeInterval(values[i], i + 1);
    low.push_back(values[i].low);
    high.push_back(values[i].high);
  }
  return PBox::fromEdges(Edf(std::move(low)), Edf(std::move(high)));
}

PBox widened(const PBox& box, const Margin& margin) {
  for (const double m : {margin.below, margin.above}) {
    if (std::isfinite(m) && m >= 0.0) continue;
    throw core::InputError({}, fmt::format("a margin of {}; it must be finite and not negative.", m),
                           "Give the magnitude: what a value may be below and above what was read.");
  }
  return PBox::fromEdges(box.left().shifted(-margin.below), box.right().shifted(margin.above));
}

}  // namespace metrics
