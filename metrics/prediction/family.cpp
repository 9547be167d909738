#include "metrics/prediction/family.h"

#include <cmath>

namespace metrics {

namespace {

/// 1, x1 … xp and, for a quadratic, x1 x1, x1 x2, …, xp xp.
void polynomialTerms(bool squares, std::span<const double> x, std::span<double> terms) {
  std::size_t next = 0;
  terms[next++] = 1.0;
  for (const double value : x) terms[next++] = value;
  if (!squares) return;
  for (std::size_t i = 0; i < x.size(); ++i) {
    for (std::size_t j = i; j < x.size(); ++j) terms[next++] = x[i] * x[j];
  }
}

/// shift + c1 x1 + … + cp xp.
double weightedSum(double shift, std::span<const double> slopes, std::span<const double> x) {
  for (std::size_t i = 0; i < x.size(); ++i) shift += slopes[i] * x[i];
  return shift;
}

double exponential(std::span<const double> coefficients, std::span<const double> x, std::span<double> gradient) {
  const double growth = std::exp(weightedSum(0.0, coefficients.subspan(2), x));
  gradient[0] = 1.0;
  gradient[1] = growth;
  for (std::size_t i = 0; i < x.size(); ++i) gradient[2 + i] = coefficients[1] * growth * x[i];
  return coefficients[0] + coefficients[1] * growth;
}

double sigmoid(std::span<const double> coefficients, std::span<const double> x, std::span<double> gradient) {
  const double share = 1.0 / (1.0 + std::exp(-weightedSum(coefficients[2], coefficients.subspan(3), x)));
  const double steepness = coefficients[1] * share * (1.0 - share);
  gradient[0] = 1.0;
  gradient[1] = share;
  gradient[2] = steepness;
  for (std::size_t i = 0; i < x.size(); ++i) gradient[3 + i] = steepness * x[i];
  return coefficients[0] + coefficients[1] * share;
}

}  // namespace

std::string_view name(Family family) {
  constexpr std::array<std::string_view, kFamilies.size()> kNames{"constant", "linear", "quadratic", "exponential",
                                                                  "sigmoid"};
  return kNames[static_cast<std::size_t>(family)];
}

std::size_t coefficientCount(Family family, std::size_t parameters) {
  switch (family) {
    case Family::Constant:
      return 1;
    case Family::Linear:
      return 1 + parameters;
    case Family::Quadratic:
      return 1 + parameters + parameters * (parameters + 1) / 2;
    case Family::Exponential:
      return 2 + parameters;
    case Family::Sigmoid:
      return 3 + parameters;
  }
  return 0;
}

std::vector<std::string> coefficientNames(Family family, std::span<const std::string> parameters) {
  std::vector<std::string> names;
  if (isLinearInCoefficients(family)) {
    names = {"intercept"};
  } else if (family == Family::Exponential) {
    names = {"offset", "factor"};
  } else {
    names = {"offset", "height", "shift"};
  }
  if (family == Family::Constant) return names;
  const std::string prefix = isLinearInCoefficients(family) ? "" : family == Family::Exponential ? "rate " : "slope ";
  for (const std::string& parameter : parameters) names.push_back(prefix + parameter);
  if (family != Family::Quadratic) return names;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    names.push_back(parameters[i] + "^2");
    for (std::size_t j = i + 1; j < parameters.size(); ++j) names.push_back(parameters[i] + "*" + parameters[j]);
  }
  return names;
}

double valueAndGradient(Family family, std::span<const double> coefficients, std::span<const double> x,
                        std::span<double> gradient) {
  if (family == Family::Exponential) return exponential(coefficients, x, gradient);
  if (family == Family::Sigmoid) return sigmoid(coefficients, x, gradient);
  if (family == Family::Constant) x = {};
  polynomialTerms(family == Family::Quadratic, x, gradient);
  double value = 0.0;
  for (std::size_t i = 0; i < coefficients.size(); ++i) value += coefficients[i] * gradient[i];
  return value;
}

}  // namespace metrics
