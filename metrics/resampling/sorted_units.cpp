#include "metrics/resampling/sorted_units.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <numeric>

#include "core/error.h"

namespace metrics {

namespace {

void check(const UnitSample& sample, const std::string& name) {
  if (sample.values.empty()) {
    throw core::InputError({.item = name}, "has no values; there is nothing to draw from.",
                           "Check the gate or the file.");
  }
  if (!sample.units.empty() && sample.units.size() != sample.values.size()) {
    throw core::InputError({.item = name},
                           fmt::format("{} values have {} units.", sample.values.size(), sample.units.size()),
                           "Give one unit for each value, or none at all.");
  }
  if (sample.values.size() > std::numeric_limits<std::uint32_t>::max()) {
    throw core::InputError({.item = name}, "has more than 2^32 - 1 values.", "Compare a part of them.");
  }
  const auto bad = std::find_if(sample.values.begin(), sample.values.end(), [](double x) { return !std::isfinite(x); });
  if (bad != sample.values.end()) {
    throw core::InputError({.item = fmt::format("{}, value {}", name, bad - sample.values.begin() + 1)},
                           fmt::format("is {}; resampling needs finite numbers.", *bad),
                           "Remove or correct it; nothing is dropped silently.");
  }
}

}  // namespace

SortedUnits::SortedUnits(const UnitSample& units, const std::string& sample) {
  check(units, sample);
  const std::size_t n = units.values.size();
  const Edf edf(std::vector<double>(units.values.begin(), units.values.end()));
  steps_.assign(edf.values().begin(), edf.values().end());
  const auto stepOf = [this](double x) {
    return static_cast<std::uint32_t>(std::lower_bound(steps_.begin(), steps_.end(), x) - steps_.begin());
  };

  step_of_.resize(n);
  std::transform(units.values.begin(), units.values.end(), step_of_.begin(), stepOf);
  if (units.units.empty()) {
    std::sort(step_of_.begin(), step_of_.end());
    units_.resize(n);
    std::iota(units_.begin(), units_.end(), 0u);
    begins_.resize(n + 1);
    std::iota(begins_.begin(), begins_.end(), 0u);
    return;
  }
  std::vector<std::pair<std::uint32_t, std::uint32_t>> members(n);  // unit, step
  for (std::size_t i = 0; i < n; ++i) members[i] = {units.units[i], step_of_[i]};
  std::sort(members.begin(), members.end());
  for (std::size_t i = 0; i < n; ++i) {
    step_of_[i] = members[i].second;
    if (i > 0 && members[i].first == members[i - 1].first) continue;
    units_.push_back(members[i].first);
    begins_.push_back(static_cast<std::uint32_t>(i));
  }
  begins_.push_back(static_cast<std::uint32_t>(n));
}

void SortedUnits::countSteps(std::span<const std::uint32_t> unit_counts, Counts& step_counts) const {
  step_counts.assign(steps_.size(), 0);
  for (std::size_t u = 0; u < unit_counts.size(); ++u) {
    for (const std::uint32_t step : stepsOfUnit(u)) step_counts[step] += unit_counts[u];
  }
}

void drawWithReplacement(std::size_t units, std::size_t draws, std::size_t block, core::Random& random,
                         Counts& counts) {
  counts.assign(units, 0);
  const auto starts = static_cast<std::uint32_t>(units - block + 1);
  for (std::size_t drawn = 0; drawn < draws;) {
    const std::size_t start = random.below(starts);
    const std::size_t end = start + std::min(block, draws - drawn);
    for (std::size_t u = start; u < end; ++u) ++counts[u];
    drawn += end - start;
  }
}

}  // namespace metrics
