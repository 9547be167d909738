#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/random.h"
#include "metrics/distributions/edf.h"
#include "metrics/resampling/unit_sample.h"

namespace metrics {

/// How often each unit was drawn, or each step of a sample occurs.
using Counts = std::vector<std::uint32_t>;

/// A sample sorted once. What is drawn afterwards is integer weights on its steps, walked linearly: no replicate sorts.
/// Without units the i-th unit is the i-th smallest value, so a result does not depend on the order of the sample.
/// Immutable; safe to share.
class SortedUnits {
 public:
  /// Throws InputError, naming `sample`, if it is empty, a value is not finite or the lengths differ.
  SortedUnits(const UnitSample& units, const std::string& sample);

  [[nodiscard]] std::size_t unitCount() const noexcept { return begins_.size() - 1; }
  /// Numbers of the units, ascending; 0, 1, 2, … if the sample has none.
  [[nodiscard]] std::span<const std::uint32_t> units() const noexcept { return units_; }
  /// Distinct values, ascending.
  [[nodiscard]] std::span<const double> steps() const noexcept { return steps_; }
  /// Steps of the values of the u-th unit.
  [[nodiscard]] std::span<const std::uint32_t> stepsOfUnit(std::size_t u) const noexcept {
    return std::span(step_of_).subspan(begins_[u], begins_[u + 1] - begins_[u]);
  }

  /// How often each step occurs if unit u is taken unit_counts[u] times.
  void countSteps(std::span<const std::uint32_t> unit_counts, Counts& step_counts) const;

 private:
  std::vector<double> steps_;
  std::vector<std::uint32_t> units_;
  std::vector<std::uint32_t> begins_;   // unit u has the values begins_[u] … begins_[u + 1] - 1
  std::vector<std::uint32_t> step_of_;  // each value's step, by unit
};

/// Draws `draws` times from `units` units with replacement, in runs of `block` neighbours (the last run is cut).
/// Source: Efron 1979, doi:10.1214/aos/1176344552 (block = 1); Künsch 1989, doi:10.1214/aos/1176347265.
void drawWithReplacement(std::size_t units, std::size_t draws, std::size_t block, core::Random& random, Counts& counts);

}  // namespace metrics
