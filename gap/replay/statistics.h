#pragma once

#include <cstddef>
#include <vector>

namespace gap {

/// Of values that are not empty, which it reorders; the upper of the two middle ones of an even number.
[[nodiscard]] double medianOf(std::vector<double>& values);

/// Probability that a standard normal number is above z; beyond 37 what it is at 37, which a double still holds.
[[nodiscard]] double upperTail(double z);

/// The same of one more number, z standard deviations above the mean of so many runs, both taken from these runs:
/// Student's t with n - 1 degrees of freedom, at z / sqrt(1 + 1/n).
[[nodiscard]] double upperTail(double z, std::size_t runs);

/// Probability that some normal numbers about zero have a mean as far from it: Student's t, to both sides. Two at
/// least.
[[nodiscard]] double meanByChance(const std::vector<double>& values);

/// Mean and standard deviation (n - 1) of some runs, two at least.
struct Distribution {
  double mean = 0.0;
  double stddev = 0.0;

  explicit Distribution(const std::vector<double>& values);
  /// A value in standard deviations from the mean.
  [[nodiscard]] double z(double value) const;
};

}  // namespace gap
