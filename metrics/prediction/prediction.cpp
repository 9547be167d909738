#include "metrics/prediction/prediction.h"

#include <algorithm>
#include <array>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <fmt/format.h>

#include "core/error.h"

namespace metrics {

namespace {

/// The linear family over the same u, for its leverage. Absent if the samples do not span all parameters.
std::vector<double> linearRoot(const ErrorSamples& samples) {
  if (samples.parameters.size() < 2) return {};
  ErrorSamples unweighted = samples;
  unweighted.weights.clear();
  try {
    return regress(unweighted, Family::Linear).root;
  } catch (const core::InputError&) {
    return {};  // too few, or all in a plane: no ellipsoid has a volume
  }
}

double linearLeverage(const std::vector<double>& root, std::span<const double> u) {
  const std::size_t count = u.size() + 1;
  double leverage = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    double sum = root[i * count];
    for (std::size_t k = 0; k < u.size(); ++k) sum += root[i * count + 1 + k] * u[k];
    leverage += sum * sum;
  }
  return leverage;
}

double linearLeverage(const std::vector<double>& root, const Regression& r, std::span<const double> x) {
  std::array<double, kMaxParameters> u{};
  for (std::size_t k = 0; k < x.size(); ++k) u[k] = (x[k] - r.centre[k]) / r.scale[k];
  return linearLeverage(root, std::span(u).first(x.size()));
}

Domain domainOf(const ErrorSamples& samples, const Regression& regression) {
  Domain domain;
  for (std::size_t k = 0; k < samples.parameters.size(); ++k) {
    Interval range{.low = samples.point(0)[k], .high = samples.point(0)[k]};
    for (std::size_t row = 1; row < samples.size(); ++row) {
      range.low = std::min(range.low, samples.point(row)[k]);
      range.high = std::max(range.high, samples.point(row)[k]);
    }
    domain.ranges.push_back(range);
  }
  domain.root = linearRoot(samples);
  for (std::size_t row = 0; row < samples.size() && !domain.root.empty(); ++row) {
    domain.largest_leverage =
        std::max(domain.largest_leverage, linearLeverage(domain.root, regression, samples.point(row)));
  }
  return domain;
}

double weightedMean(const ErrorSamples& samples) {
  double sum = 0.0;
  double weights = 0.0;
  for (std::size_t row = 0; row < samples.size(); ++row) {
    sum += samples.weight(row) * samples.errors[row];
    weights += samples.weight(row);
  }
  return sum / weights;
}

/// Infinite where it is not known, be it for want of degrees of freedom or beyond the range of numbers.
Interval around(double value, double half_width) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  if (!std::isfinite(half_width) || !std::isfinite(value)) return {.low = -kInfinity, .high = kInfinity};
  return {.low = value - half_width, .high = value + half_width};
}

void cutAtZero(PredictedError& error) {
  for (double* number :
       {&error.value, &error.confidence.low, &error.confidence.high, &error.observation.low, &error.observation.high}) {
    *number = std::max(0.0, *number);
  }
}

void checkPoint(const Prediction& prediction, std::span<const double> x) {
  const auto& names = prediction.regression.parameters;
  if (x.size() != names.size()) {
    throw core::InputError({.item = prediction.target},
                           fmt::format("a point with {} numbers is asked for; it is predicted over {} parameters.",
                                       x.size(), names.size()),
                           "Give one number for each parameter.");
  }
  for (std::size_t k = 0; k < x.size(); ++k) {
    if (!std::isfinite(x[k])) {
      throw core::InputError({.item = names[k]}, fmt::format("{} is not a finite number.", x[k]),
                             "Ask for a point inside the numbers.");
    }
  }
}

}  // namespace

double PredictedError::largest() const noexcept {
  return std::abs(confidence.low) > std::abs(confidence.high) ? confidence.low : confidence.high;
}

PredictedError Prediction::at(std::span<const double> x) const {
  checkPoint(*this, x);
  const FittedValue fitted = fittedValue(regression, x);
  const double half = quantile * regression.residual_sd;  // NaN without degrees of freedom
  PredictedError error{.value = fitted.value,
                       .confidence = around(fitted.value, half * std::sqrt(fitted.leverage)),
                       .observation = around(fitted.value, half * std::sqrt(1.0 + fitted.leverage))};
  if (never_negative) cutAtZero(error);
  for (std::size_t k = 0; k < x.size(); ++k) {
    if (x[k] < domain.ranges[k].low || x[k] > domain.ranges[k].high) error.outside |= 1u << k;
  }
  if (error.outside == 0 && !domain.root.empty()) {
    // A sample itself must not fall out by rounding.
    const double limit = domain.largest_leverage * (1.0 + 1e-9);
    error.outside_joint = linearLeverage(domain.root, regression, x) > limit;
  }
  return error;
}

Prediction predict(const ErrorSamples& samples, const PredictionOptions& options) {
  Prediction prediction{.target = samples.target, .never_negative = options.never_negative};
  prediction.regression = regress(samples, options.family);
  prediction.domain = domainOf(samples, prediction.regression);
  prediction.mean_error = weightedMean(samples);
  return atLevel(std::move(prediction), options.level);
}

Prediction atLevel(Prediction prediction, double level) {
  if (!(level > 0.0 && level < 1.0)) {
    throw core::InputError({.item = "level"}, fmt::format("{} is not between 0 and 1.", level), "Give 0.95 for 95 %.");
  }
  prediction.level = level;
  prediction.quantile = std::numeric_limits<double>::infinity();
  if (prediction.regression.dof > 0) {
    const boost::math::students_t student(static_cast<double>(prediction.regression.dof));
    prediction.quantile = boost::math::quantile(student, 0.5 + 0.5 * level);
  }
  return prediction;
}

}  // namespace metrics
