#include "metrics/prediction/curve_fit.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <unsupported/Eigen/NonLinearOptimization>

#include "core/error.h"

namespace metrics {

namespace {

using Eigen::VectorXd;

/// The residuals sqrt(w) (f(u) - y), as Eigen's optimiser wants to ask for them.
struct Residuals {
  using Scalar = double;
  enum { InputsAtCompileTime = Eigen::Dynamic, ValuesAtCompileTime = Eigen::Dynamic };
  using InputType = VectorXd;
  using ValueType = VectorXd;
  using JacobianType = Eigen::MatrixXd;

  Family family;
  std::size_t parameters;
  std::span<const double> points;
  std::span<const double> errors;
  std::span<const double> weights;

  [[nodiscard]] std::span<const double> point(std::size_t row) const {
    return points.subspan(row * parameters, parameters);
  }
  [[nodiscard]] std::size_t coefficients() const { return coefficientCount(family, parameters); }
  [[nodiscard]] int inputs() const { return static_cast<int>(coefficients()); }
  [[nodiscard]] int values() const { return static_cast<int>(errors.size()); }

  int operator()(const VectorXd& at, VectorXd& residuals) const {
    std::array<double, kMaxCoefficients> gradient{};
    const std::span<const double> c(at.data(), coefficients());
    for (std::size_t i = 0; i < errors.size(); ++i) {
      residuals(static_cast<Eigen::Index>(i)) =
          std::sqrt(weights[i]) * (valueAndGradient(family, c, point(i), gradient) - errors[i]);
    }
    return 0;
  }

  int df(const VectorXd& at, Eigen::MatrixXd& jacobian) const {
    std::array<double, kMaxCoefficients> gradient{};
    const std::span<const double> c(at.data(), coefficients());
    for (std::size_t i = 0; i < errors.size(); ++i) {
      valueAndGradient(family, c, point(i), gradient);
      jacobian.row(static_cast<Eigen::Index>(i)) =
          std::sqrt(weights[i]) * Eigen::Map<const Eigen::RowVectorXd>(gradient.data(), inputs());
    }
    return 0;
  }
};

/// Where in the parameters the exponent may grow: along each of them, and along the steepest plane through the data.
std::vector<VectorXd> directions(const Residuals& data) {
  const auto p = static_cast<Eigen::Index>(data.parameters);
  std::vector<VectorXd> all;
  for (Eigen::Index k = 0; k < p; ++k) all.emplace_back(VectorXd::Unit(p, k));
  if (p == 1) return all;
  Eigen::MatrixXd design(data.values(), p + 1);
  VectorXd errors(data.values());
  for (Eigen::Index i = 0; i < design.rows(); ++i) {
    const auto row = static_cast<std::size_t>(i);
    design(i, 0) = 1.0;
    design.row(i).tail(p) = Eigen::Map<const Eigen::RowVectorXd>(data.point(row).data(), p);
    errors(i) = data.errors[row];
  }
  const VectorXd plane = design.colPivHouseholderQr().solve(errors).tail(p);
  if (plane.norm() > 0.0) all.emplace_back(plane / plane.cwiseAbs().sum());  // reaches at most 1 over [-1, 1]^p
  return all;
}

/// Exponents to begin with; offset and factor are still 0.
std::vector<VectorXd> exponents(const Residuals& data) {
  const bool sigmoid = data.family == Family::Sigmoid;
  const auto p = static_cast<Eigen::Index>(data.parameters);
  std::vector<VectorXd> starts;
  const auto add = [&](const VectorXd& slopes, double shift) {
    VectorXd start = VectorXd::Zero(data.inputs());
    if (sigmoid) start(2) = shift;
    start.tail(p) = slopes;
    starts.push_back(std::move(start));
  };
  for (const VectorXd& direction : directions(data)) {
    for (const double steepness : {0.25, 0.5, 1.0, 2.0, 4.0, 8.0, 16.0}) {
      if (!sigmoid) {
        add(steepness * direction, 0.0);
        add(-steepness * direction, 0.0);
        continue;
      }
      for (int eighth = -7; eighth <= 7; ++eighth) add(steepness * direction, -steepness * eighth / 8.0);
    }
  }
  return starts;
}

/// Fills in the offset and factor that suit the start's exponent; returns the sum of squares.
double completeStart(const Residuals& data, VectorXd& start) {
  start(0) = 0.0;
  start(1) = 1.0;
  Eigen::MatrixXd jacobian(data.values(), data.inputs());
  data.df(start, jacobian);
  VectorXd errors(data.values());
  for (Eigen::Index i = 0; i < errors.size(); ++i) {
    const auto row = static_cast<std::size_t>(i);
    errors(i) = std::sqrt(data.weights[row]) * data.errors[row];
  }
  const Eigen::MatrixXd linear = jacobian.leftCols(2);
  start.head(2) = linear.colPivHouseholderQr().solve(errors);
  return (linear * start.head(2) - errors).squaredNorm();
}

struct Start {
  double squares;
  VectorXd coefficients;
};

std::vector<Start> bestStarts(const Residuals& data) {
  constexpr std::size_t kRefined = 5;
  std::vector<Start> starts;
  for (VectorXd& start : exponents(data)) {
    const double squares = completeStart(data, start);
    if (std::isfinite(squares)) starts.push_back({squares, std::move(start)});
  }
  std::stable_sort(starts.begin(), starts.end(), [](const Start& a, const Start& b) { return a.squares < b.squares; });
  if (starts.size() > kRefined) starts.resize(kRefined);
  return starts;
}

/// False if the optimiser gave up.
bool refine(const Residuals& data, Start& start) {
  Residuals copy = data;
  Eigen::LevenbergMarquardt<Residuals> optimiser(copy);
  optimiser.parameters.maxfev = 2000;
  optimiser.parameters.ftol = optimiser.parameters.xtol = 1e-15;
  const auto status = optimiser.minimize(start.coefficients);
  start.squares = optimiser.fvec.squaredNorm();
  using namespace Eigen::LevenbergMarquardtSpace;
  return status != ImproperInputParameters && status != TooManyFunctionEvaluation && std::isfinite(start.squares) &&
         start.coefficients.allFinite();
}

/// How far the exponent runs over the samples.
double reach(const Residuals& data, const VectorXd& coefficients) {
  double least = 0.0;
  double most = 0.0;
  for (std::size_t i = 0; i < data.errors.size(); ++i) {
    const Eigen::Map<const VectorXd> u(data.point(i).data(), static_cast<Eigen::Index>(data.parameters));
    const double exponent = coefficients.tail(u.size()).dot(u);
    least = i == 0 ? exponent : std::min(least, exponent);
    most = i == 0 ? exponent : std::max(most, exponent);
  }
  return most - least;
}

/// What the curve adds to its offset is no more than rounding.
bool isFlat(const Residuals& data, const VectorXd& coefficients) {
  std::array<double, kMaxCoefficients> gradient{};
  const std::span<const double> c(coefficients.data(), data.coefficients());
  double deviation = 0.0;
  double magnitude = 0.0;
  const double first = valueAndGradient(data.family, c, data.point(0), gradient);
  for (std::size_t i = 0; i < data.errors.size(); ++i) {
    deviation = std::max(deviation, std::abs(valueAndGradient(data.family, c, data.point(i), gradient) - first));
    magnitude = std::max(magnitude, std::abs(data.errors[i]));
  }
  return deviation <= 1e-10 * magnitude;
}

/// b / (1 + e^-z) = b - b / (1 + e^z): of the two ways to write a sigmoid the one that rises with x1.
void turnUpwards(Family family, VectorXd& c) {
  if (family != Family::Sigmoid || c(3) >= 0.0) return;
  c(0) += c(1);
  c(1) = -c(1);
  c.tail(c.size() - 2) = -c.tail(c.size() - 2);
}

[[noreturn]] void refuse(Family family, const char* why) {
  throw core::InputError({.item = std::string(name(family))}, why, "Use a simpler family, or measure in between.");
}

}  // namespace

std::vector<double> fitCurve(Family family, std::size_t parameters, std::span<const double> points,
                             std::span<const double> errors, std::span<const double> weights) {
  const Residuals data{
      .family = family, .parameters = parameters, .points = points, .errors = errors, .weights = weights};
  Start best{.squares = std::numeric_limits<double>::infinity(), .coefficients = {}};
  for (Start& start : bestStarts(data)) {
    if (refine(data, start) && start.squares < best.squares) best = std::move(start);
  }
  if (best.coefficients.size() == 0) refuse(family, "no fit converges.");
  const double span = reach(data, best.coefficients);
  if (span < 1e-3 || isFlat(data, best.coefficients))
    refuse(family, "the errors bend too little to tell it from a simpler family.");
  if (span > 200.0) refuse(family, "the errors jump; how steeply cannot be told.");
  turnUpwards(family, best.coefficients);
  return {best.coefficients.begin(), best.coefficients.end()};
}

}  // namespace metrics
