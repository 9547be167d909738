#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace metrics {

/// Most parameters that an error is predicted over; more would need more samples than anybody measures.
inline constexpr std::size_t kMaxParameters = 6;

/// What a prediction learns from: one kind of error (d_bias, d_CAVM, …) at validated points of the parameter space.
///
///   row 1   points: 10.0, 0.2   error: -0.027   setup: "A"
///   row 2   points: 15.0, 0.2   error:  0.006   setup: "B"
///           [units of the parameters]  [unit of the measurand]
struct ErrorSamples {
  std::string target;                    ///< name of the error, "d_bias"
  std::vector<std::string> parameters;   ///< names, "range_m" …: 1 to kMaxParameters
  std::vector<double> points;            ///< row after row, one number for each parameter
  std::vector<double> errors;            ///< one for each row
  std::vector<double> weights = {};      ///< > 0, proportional to 1 / variance; empty: all 1
  std::vector<std::string> setups = {};  ///< rows of one set-up share an error of the reference; empty: none do

  [[nodiscard]] std::size_t size() const noexcept { return errors.size(); }
  [[nodiscard]] std::span<const double> point(std::size_t row) const {
    return std::span(points).subspan(row * parameters.size(), parameters.size());
  }
  [[nodiscard]] double weight(std::size_t row) const { return weights.empty() ? 1.0 : weights[row]; }
};

/// Throws InputError, with the row counted from 1, if lengths differ, there is no row, a number is not finite, a weight
/// is not positive, or parameters have no name or the same.
void check(const ErrorSamples& samples);

/// Only these rows, in this order.
[[nodiscard]] ErrorSamples rowsOf(const ErrorSamples& samples, std::span<const std::size_t> rows);

}  // namespace metrics
