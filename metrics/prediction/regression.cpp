#include "metrics/prediction/regression.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <numeric>

#include "core/error.h"
#include "core/text.h"
#include "metrics/prediction/curve_fit.h"

namespace metrics {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using Factorisation = Eigen::ColPivHouseholderQR<MatrixXd>;

constexpr double kRankThreshold = 1e-8;  // a column this close to the span of the others, relative to its length

void standardise(const ErrorSamples& samples, Regression& regression) {
  for (std::size_t k = 0; k < samples.parameters.size(); ++k) {
    double low = samples.point(0)[k];
    double high = low;
    for (std::size_t row = 1; row < samples.size(); ++row) {
      low = std::min(low, samples.point(row)[k]);
      high = std::max(high, samples.point(row)[k]);
    }
    regression.centre.push_back(std::midpoint(low, high));
    regression.scale.push_back(high > low ? 0.5 * (high - low) : 1.0);
  }
}

std::vector<double> standardised(const ErrorSamples& samples, const Regression& regression) {
  std::vector<double> points(samples.points.size());
  const std::size_t p = samples.parameters.size();
  for (std::size_t i = 0; i < points.size(); ++i) {
    points[i] = (samples.points[i] - regression.centre[i % p]) / regression.scale[i % p];
  }
  return points;
}

/// Mean 1, so that residual_sd is that of a sample of average weight.
std::vector<double> weightsOf(const ErrorSamples& samples) {
  if (samples.weights.empty()) return std::vector<double>(samples.size(), 1.0);
  const double mean = std::accumulate(samples.weights.begin(), samples.weights.end(), 0.0) /
                      static_cast<double>(samples.weights.size());
  std::vector<double> weights = samples.weights;
  for (double& w : weights) w /= mean;
  return weights;
}

void refuseConstantParameters(const ErrorSamples& samples) {
  for (std::size_t k = 0; k < samples.parameters.size(); ++k) {
    std::size_t row = 1;
    while (row < samples.size() && samples.point(row)[k] == samples.point(0)[k]) ++row;
    if (row == samples.size()) {
      throw core::InputError(
          {.item = samples.parameters[k]},
          "is " + core::shortestNumber(samples.point(0)[k]) + " in every row; no dependence on it can be learnt.",
          "Leave it out, or add rows with other values.");
    }
  }
}

/// Parameters that are a linear function of those before them have no coefficient of their own.
void refuseCollinearParameters(const ErrorSamples& samples, const std::vector<double>& points) {
  const auto p = static_cast<Index>(samples.parameters.size());
  const auto n = static_cast<Index>(samples.size());
  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  MatrixXd design(n, p + 1);
  design << VectorXd::Ones(n), Eigen::Map<const RowMajor>(points.data(), n, p);
  for (Index k = 1; k < p && n > k + 1; ++k) {
    const MatrixXd before = design.leftCols(k + 1);
    const VectorXd follows = before.colPivHouseholderQr().solve(design.col(k + 1));
    if ((before * follows - design.col(k + 1)).norm() > kRankThreshold * design.col(k + 1).norm()) continue;
    std::vector<std::string> others;
    for (Index j = 1; j <= k; ++j) {
      if (std::abs(follows(j)) > 1e-6) others.push_back(samples.parameters[static_cast<std::size_t>(j - 1)]);
    }
    throw core::InputError({.item = samples.parameters[static_cast<std::size_t>(k)]},
                           "follows from " + core::join(others) + " in these rows: they are collinear.",
                           "Leave one of them out, or add rows in which they change independently.");
  }
}

void checkCount(const ErrorSamples& samples, Family family) {
  const std::size_t needed = coefficientCount(family, samples.parameters.size());
  if (samples.size() < needed) {
    throw core::InputError(
        {.item = samples.target},
        fmt::format("the {} family has {} coefficients; {} rows are too few.", name(family), needed, samples.size()),
        "Add rows, or choose a simpler family.");
  }
}

/// Row i: sqrt(w_i) times the derivatives of f at sample i.
MatrixXd weightedGradients(const Regression& regression, const std::vector<double>& points,
                           const std::vector<double>& weights) {
  const std::size_t p = regression.parameters.size();
  MatrixXd jacobian(static_cast<Index>(weights.size()), static_cast<Index>(regression.coefficients.size()));
  std::array<double, kMaxCoefficients> gradient{};
  for (std::size_t i = 0; i < weights.size(); ++i) {
    valueAndGradient(regression.family, regression.coefficients, std::span(points).subspan(i * p, p), gradient);
    jacobian.row(static_cast<Index>(i)) =
        std::sqrt(weights[i]) * Eigen::Map<const Eigen::RowVectorXd>(gradient.data(), jacobian.cols());
  }
  return jacobian;
}

[[noreturn]] void refuseUndetermined(const Regression& regression, Index column) {
  const auto names = coefficientNames(regression.family, regression.parameters);
  throw core::InputError({.item = std::string(name(regression.family))},
                         "these rows do not determine '" + names[static_cast<std::size_t>(column)] + "'.",
                         "Choose a simpler family, or add rows at other values of the parameters.");
}

/// The gradients with columns of length 1, factorised, and those lengths.
struct Factors {
  VectorXd lengths;
  Factorisation qr;
};

Factors factorise(const Regression& regression, const MatrixXd& jacobian) {
  Factors factors{.lengths = jacobian.colwise().norm(), .qr = {}};
  for (Index k = 0; k < factors.lengths.size(); ++k) {
    if (!(factors.lengths(k) > 0.0) || !std::isfinite(factors.lengths(k))) refuseUndetermined(regression, k);
  }
  factors.qr.setThreshold(kRankThreshold);
  factors.qr.compute(jacobian * factors.lengths.cwiseInverse().asDiagonal());
  const Index rank = factors.qr.rank();
  if (rank < jacobian.cols()) refuseUndetermined(regression, factors.qr.colsPermutation().indices()(rank));
  return factors;
}

/// With J = Q R P' D: (J' J)^-1 = |R^-T P' D^-1|^2.
std::vector<double> rootOf(const Factors& factors) {
  const Index k = factors.lengths.size();
  const MatrixXd permuted =
      factors.qr.colsPermutation().transpose() * MatrixXd(factors.lengths.cwiseInverse().asDiagonal());
  const MatrixXd root =
      factors.qr.matrixR().topLeftCorner(k, k).triangularView<Eigen::Upper>().transpose().solve(permuted);
  std::vector<double> rows;
  for (Index i = 0; i < k; ++i) {
    for (Index j = 0; j < k; ++j) rows.push_back(root(i, j));
  }
  return rows;
}

VectorXd weightedErrors(const ErrorSamples& samples, const std::vector<double>& weights) {
  VectorXd errors(static_cast<Index>(samples.size()));
  for (std::size_t i = 0; i < samples.size(); ++i) {
    errors(static_cast<Index>(i)) = std::sqrt(weights[i]) * samples.errors[i];
  }
  return errors;
}

double residualDeviation(const ErrorSamples& samples, const Regression& regression,
                         const std::vector<double>& weights) {
  if (regression.dof == 0) return std::numeric_limits<double>::quiet_NaN();
  double squares = 0.0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double miss = samples.errors[i] - fittedValue(regression, samples.point(i)).value;
    squares += weights[i] * miss * miss;
  }
  return std::sqrt(squares / static_cast<double>(regression.dof));
}

}  // namespace

Regression regress(const ErrorSamples& samples, Family family) {
  check(samples);
  checkCount(samples, family);
  if (family != Family::Constant) refuseConstantParameters(samples);
  Regression regression{.family = family, .parameters = samples.parameters};
  standardise(samples, regression);
  const std::vector<double> points = standardised(samples, regression);
  if (family != Family::Constant) refuseCollinearParameters(samples, points);
  const std::vector<double> weights = weightsOf(samples);
  regression.n = samples.size();
  regression.coefficients.assign(coefficientCount(family, samples.parameters.size()), 0.0);
  regression.dof = regression.n - regression.coefficients.size();
  if (!isLinearInCoefficients(family)) {
    regression.coefficients = fitCurve(family, samples.parameters.size(), points, samples.errors, weights);
  }
  const Factors factors = factorise(regression, weightedGradients(regression, points, weights));
  if (isLinearInCoefficients(family)) {
    const VectorXd solution = factors.qr.solve(weightedErrors(samples, weights)).cwiseQuotient(factors.lengths);
    regression.coefficients.assign(solution.begin(), solution.end());
  }
  regression.root = rootOf(factors);
  regression.residual_sd = residualDeviation(samples, regression, weights);
  return regression;
}

FittedValue fittedValue(const Regression& regression, std::span<const double> x) noexcept {
  std::array<double, kMaxParameters> u{};
  for (std::size_t k = 0; k < x.size(); ++k) u[k] = (x[k] - regression.centre[k]) / regression.scale[k];
  std::array<double, kMaxCoefficients> gradient{};
  FittedValue result{};
  result.value = valueAndGradient(regression.family, regression.coefficients, std::span(u).first(x.size()), gradient);
  const std::size_t count = regression.coefficients.size();
  const double* root = regression.root.data();
  for (std::size_t i = 0; i < count; ++i, root += count) {
    double sum = 0.0;
    for (std::size_t j = 0; j < count; ++j) sum += root[j] * gradient[j];
    result.leverage += sum * sum;
  }
  return result;
}

}  // namespace metrics
