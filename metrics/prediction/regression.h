#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "metrics/prediction/error_samples.h"
#include "metrics/prediction/family.h"

namespace metrics {

/// A function fitted to errors by least squares, and how well the data determine it. A plain value: store it, and what
/// it says is the same afterwards.
///
///   d(x) = f(u; c) + noise,   u_k = (x_k - centre_k) / scale_k in [-1, 1] over the samples
///   variance of f(u; c) = residual_sd^2 h,   h = g' (J' W J)^-1 g = |root g|^2   (leverage)
///
///   g  derivatives of f by its coefficients at u;  J  the same, one row a sample;  W  weights of mean 1
///
/// Exact for families that are linear in their coefficients; for exponential and sigmoid f is replaced by its tangent
/// (delta method), so what follows from h is approximate, the better the smaller the noise.
/// Errors of different rows are taken as independent and, at equal weight, equally scattered.
/// Source: Seber & Wild 1989, Nonlinear Regression, doi:10.1002/0471725315, ch. 2 and 5.
struct Regression {
  Family family = Family::Constant;
  std::vector<std::string> parameters;
  std::vector<double> centre;        ///< [units of the parameters]
  std::vector<double> scale;         ///< > 0
  std::vector<double> coefficients;  ///< c: of the function over u
  std::vector<double> root;          ///< square matrix, row after row
  std::size_t n = 0;                 ///< samples
  std::size_t dof = 0;               ///< n minus coefficients; 0: the function runs through every sample
  double residual_sd = 0.0;          ///< NaN if dof is 0. [unit of the measurand]

  /// False: bounds rest on the delta method.
  [[nodiscard]] bool boundsAreExact() const noexcept { return isLinearInCoefficients(family); }
};

/// Throws InputError if the samples are bad (check()), fewer than the coefficients, or do not determine them: a
/// parameter that never changes and parameters that follow from each other are named.
[[nodiscard]] Regression regress(const ErrorSamples& samples, Family family);

/// One number of the formula in family.h, in the units of the parameters; for readers.
struct Coefficient {
  std::string name;
  double value;
  double standard_error;  ///< NaN if dof is 0
};
[[nodiscard]] std::vector<Coefficient> coefficientsOf(const Regression& regression);

struct FittedValue {
  double value;
  double leverage;  ///< h >= 0
};
/// x as the samples had it, one number a parameter. Allocates nothing.
[[nodiscard]] FittedValue fittedValue(const Regression& regression, std::span<const double> x) noexcept;

}  // namespace metrics
