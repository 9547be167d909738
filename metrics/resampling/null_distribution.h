#pragma once

#include <cstddef>
#include <vector>

namespace metrics {

/// What a figure is if there is nothing to find: its values under chance alone. [unit of the figure]
class NullDistribution {
 public:
  /// Throws InputError if there are no values or one is not finite.
  explicit NullDistribution(std::vector<double> values);

  [[nodiscard]] const std::vector<double>& ascending() const noexcept { return ascending_; }
  [[nodiscard]] double mean() const noexcept;
  [[nodiscard]] double median() const noexcept { return quantile(0.5); }
  [[nodiscard]] double quantile(double p) const noexcept;
  /// Share of the values that are <= x: how often chance alone passes a threshold x.
  [[nodiscard]] double shareUpTo(double x) const noexcept;

 private:
  std::vector<double> ascending_;
};

/// Chance of a figure at least as large as the observed one: (1 + number of such values) / (1 + B), never 0.
/// Source: Phipson & Smyth 2010, doi:10.2202/1544-6115.1585.
[[nodiscard]] double permutationPValue(double observed, const NullDistribution& null);

}  // namespace metrics
