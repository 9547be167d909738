#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace metrics {

/// A parameter of a model that is known only to lie in a range; every value in it is as likely, on a linear or a
/// logarithmic scale. Parameters are independent.
struct UncertainParameter {
  std::string name;
  double min = 0.0;
  double max = 1.0;
  bool logarithmic = false;

  /// Value at a share u in [0, 1] of the range.
  [[nodiscard]] double at(double u) const;
};

enum class SensitivityMethod {
  Sobol,  ///< two samples and their mixtures: n (k + 2) runs
  Fast    ///< curves through the space of parameters, one for each: c n k runs
};

/// For which parameters the model is to be run, row by row.
///
///   Sobol   A     n rows of the first k dimensions of a Sobol' sequence
///           B     n rows of the other k
///           AB_i  n rows: A, but parameter i from B; one block for each parameter
///   Fast    block i of curve 1, then of curve 2, …: n rows along a curve on which parameter i swings fastest
struct SensitivityPlan {
  SensitivityMethod method = SensitivityMethod::Sobol;
  std::vector<UncertainParameter> parameters;
  std::size_t n = 0;
  std::size_t curves = 1;  ///< Fast only
  std::vector<std::vector<double>> rows;

  /// "A", "B", or the name of the block's parameter.
  [[nodiscard]] std::string blockOf(std::size_t row) const;
  /// From 1; 1 throughout for Sobol.
  [[nodiscard]] std::size_t curveOf(std::size_t row) const;
};

/// How many runs a plan of this shape has, whether or not its rows are there.
[[nodiscard]] std::size_t rowCount(const SensitivityPlan& plan);

/// Rows of the Sobol' sequence (Boost.Random, directions of Joe & Kuo) after a random digital shift: the seed changes
/// the points, not how evenly they lie. n should be a power of two: only then every half, quarter, … of each range has
/// its share. Throws InputError for n < 2, no parameter, more than 1800 of them, a name twice, "A" or "B", or a range
/// that is empty, not finite, or logarithmic and not positive.
/// Source: Saltelli 2010, doi:10.1016/j.cpc.2009.09.018; shift: Cranley & Patterson 1976 (here bitwise).
[[nodiscard]] SensitivityPlan sobolPlan(std::vector<UncertainParameter> parameters, std::size_t n, std::uint64_t seed);

/// x_i = 1/2 + asin(sin(w_i s + phi)) / pi with a random phase phi for each parameter and curve. The parameter of the
/// block swings with w = (n - 1) / (2 M), the others with at most w / (2 M), so that its M = 4 harmonics stand clear.
/// Several curves tell how far the indices are to be trusted. Throws InputError as above, and for n < 4 M^2 + 1 = 65.
/// Source: Saltelli, Tarantola & Chan 1999, doi:10.1080/00401706.1999.10485594.
[[nodiscard]] SensitivityPlan fastPlan(std::vector<UncertainParameter> parameters, std::size_t n, std::size_t curves,
                                       std::uint64_t seed);

/// M above, and the frequency that belongs to n.
constexpr std::size_t kFastHarmonics = 4;
[[nodiscard]] constexpr std::size_t fastFrequency(std::size_t n) { return (n - 1) / (2 * kFastHarmonics); }

}  // namespace metrics
