#include "metrics/resampling/exchange.h"

#include <algorithm>
#include <cassert>
#include <fmt/format.h>
#include <utility>

#include "core/error.h"
#include "metrics/resampling/sorted_units.h"

namespace metrics {

namespace {

void check(std::span<const UnitSample> samples) {
  for (std::size_t k = 0; k < samples.size(); ++k) {
    if (samples[k].units.empty() == samples.front().units.empty()) continue;
    throw core::InputError({.item = fmt::format("sample {}", k + 1)},
                           "has units where the first sample has none, or none where it has; they cannot be exchanged.",
                           "Give units of one kind to all samples, or to none.");
  }
}

}  // namespace

Exchange::Exchange(std::span<const UnitSample> samples, std::span<const double> shifts) : samples_(samples.size()) {
  assert(samples.size() == shifts.size());
  check(samples);
  std::vector<std::pair<double, std::uint32_t>> values;  // value, unit
  for (std::size_t k = 0; k < samples.size(); ++k) {
    const SortedUnits sorted(samples[k], fmt::format("sample {}", k + 1));
    const auto first = static_cast<std::uint32_t>(sample_of_.size());
    sample_of_.insert(sample_of_.end(), sorted.unitCount(), static_cast<std::uint32_t>(k));
    for (std::size_t u = 0; u < sorted.unitCount(); ++u) {
      for (const std::uint32_t step : sorted.stepsOfUnit(u)) {
        values.emplace_back(sorted.steps()[step] + shifts[k], first + static_cast<std::uint32_t>(u));
      }
    }
  }
  std::sort(values.begin(), values.end());
  for (const auto& [value, unit] : values) {
    ascending_.push_back(value);
    unit_of_.push_back(unit);
  }
}

std::vector<Edf> Exchange::dealt(core::Random& random) const {
  std::vector<std::uint32_t> sample_of = sample_of_;
  for (std::size_t i = sample_of.size() - 1; i > 0; --i) {
    std::swap(sample_of[i], sample_of[random.below(static_cast<std::uint32_t>(i + 1))]);
  }
  struct Steps {
    std::vector<double> values;
    Counts counts;
  };
  std::vector<Steps> steps(samples_);
  for (std::size_t i = 0; i < ascending_.size(); ++i) {
    Steps& mine = steps[sample_of[unit_of_[i]]];
    if (!mine.values.empty() && mine.values.back() == ascending_[i]) {
      ++mine.counts.back();
    } else {
      mine.values.push_back(ascending_[i]);
      mine.counts.push_back(1);
    }
  }
  std::vector<Edf> edfs;
  for (const Steps& one : steps) edfs.push_back(Edf::repeated(one.values, one.counts));
  return edfs;
}

}  // namespace metrics
