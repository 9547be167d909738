#include <Eigen/Dense>
#include <cmath>
#include <limits>

#include "metrics/prediction/regression.h"

namespace metrics {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// What the coefficients over x are, and their derivatives by those over u = (x - centre) / scale.
struct InUnitsOfX {
  VectorXd values;
  MatrixXd derivatives;
};

/// Each u = x / scale - centre / scale multiplied out: the map is linear.
InUnitsOfX polynomial(const Regression& r) {
  const std::size_t p = r.family == Family::Constant ? 0 : r.parameters.size();
  const auto count = static_cast<Index>(r.coefficients.size());
  MatrixXd map = MatrixXd::Zero(count, count);
  map(0, 0) = 1.0;
  for (std::size_t i = 0; i < p; ++i) {
    const auto term = static_cast<Index>(1 + i);
    map(term, term) = 1.0 / r.scale[i];
    map(0, term) = -r.centre[i] / r.scale[i];
  }
  Index term = static_cast<Index>(1 + p);
  for (std::size_t i = 0; i < p && term < count; ++i) {
    for (std::size_t j = i; j < p; ++j, ++term) {
      const double unit = 1.0 / (r.scale[i] * r.scale[j]);
      map(term, term) = unit;
      map(static_cast<Index>(1 + i), term) -= r.centre[j] * unit;
      map(static_cast<Index>(1 + j), term) -= r.centre[i] * unit;
      map(0, term) = r.centre[i] * r.centre[j] * unit;
    }
  }
  return {.values = map * Eigen::Map<const VectorXd>(r.coefficients.data(), count), .derivatives = map};
}

/// The exponent's constant part goes to the factor of an exponential and to the shift of a sigmoid.
InUnitsOfX curve(const Regression& r) {
  const auto count = static_cast<Index>(r.coefficients.size());
  const auto p = static_cast<Index>(r.parameters.size());
  const Index first = count - p;
  InUnitsOfX result{.values = Eigen::Map<const VectorXd>(r.coefficients.data(), count),
                    .derivatives = MatrixXd::Identity(count, count)};
  double constant = 0.0;
  for (Index k = 0; k < p; ++k) {
    const auto at = static_cast<std::size_t>(k);
    constant -= result.values(first + k) * r.centre[at] / r.scale[at];
    result.values(first + k) /= r.scale[at];
    result.derivatives(first + k, first + k) = 1.0 / r.scale[at];
  }
  const bool exponential = r.family == Family::Exponential;
  const double growth = exponential ? std::exp(constant) : 1.0;
  const double by_constant = exponential ? result.values(1) * growth : 1.0;
  const Index receiver = first - 1;
  for (Index k = 0; k < p; ++k) {
    const auto at = static_cast<std::size_t>(k);
    result.derivatives(receiver, first + k) = -by_constant * r.centre[at] / r.scale[at];
  }
  result.derivatives(receiver, receiver) = growth;
  result.values(receiver) = exponential ? by_constant : result.values(receiver) + constant;
  return result;
}

}  // namespace

std::vector<Coefficient> coefficientsOf(const Regression& regression) {
  const InUnitsOfX map = isLinearInCoefficients(regression.family) ? polynomial(regression) : curve(regression);
  const auto names = coefficientNames(regression.family, regression.parameters);
  const Index count = map.values.size();
  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const MatrixXd root = Eigen::Map<const RowMajor>(regression.root.data(), count, count);
  const VectorXd deviations = (root * map.derivatives.transpose()).colwise().norm() * regression.residual_sd;
  std::vector<Coefficient> coefficients;
  for (Index k = 0; k < count; ++k) {
    coefficients.push_back(
        {.name = names[static_cast<std::size_t>(k)], .value = map.values(k), .standard_error = deviations(k)});
  }
  return coefficients;
}

}  // namespace metrics
