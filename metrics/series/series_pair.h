#pragma once

#include <cstddef>
#include <span>

namespace metrics {

/// Two series in step with each other: value i of one side was simulated for the instant, beam or pixel at which value
/// i of the other was measured. Metrics that pair values throw InputError unless both sides have the same number of
/// them, at least one, all finite: nothing is dropped or filled in. Referred to, not owned.
struct SeriesPair {
  std::span<const double> simulated;
  std::span<const double> measured;
};

/// Throws InputError, with the number of the value, unless the sides have equally many values, at least one, all
/// finite.
void requirePaired(const SeriesPair& pair);

/// The same without equal lengths, for metrics that find the partner of a value themselves.
void requireFinite(const SeriesPair& pair);

/// Throws InputError unless there are `n` instants that ascend in even steps. A step that deviates from the mean step
/// by more than half of it is refused: a value may be lost there, and a lag counted in values would mean nothing.
void requireEvenSteps(std::span<const double> times_s, std::size_t n);

}  // namespace metrics
