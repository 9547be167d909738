#include "metrics/resampling/intervals.h"

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <vector>

#include "core/error.h"
#include "metrics/distributions/summation.h"

namespace metrics {

namespace {

const boost::math::normal kNormal;

void check(std::span<const double> replicates, double confidence) {
  if (!(confidence > 0.0 && confidence < 1.0)) {
    throw core::InputError({.item = "confidence"}, fmt::format("is {}; it must lie between 0 and 1.", confidence),
                           "Give 0.95 for 95 per cent.");
  }
  if (replicates.size() < 2) {
    throw core::InputError({.item = "replicates"}, fmt::format("are {}; no interval can be read.", replicates.size()),
                           "Draw 1000 or more.");
  }
}

bool allFinite(double estimate, std::span<const double> replicates) {
  return std::isfinite(estimate) &&
         std::all_of(replicates.begin(), replicates.end(), [](double x) { return std::isfinite(x); });
}

ConfidenceInterval withMoments(double estimate, std::span<const double> replicates, double confidence) {
  const auto count = static_cast<double>(replicates.size());
  Summation sum;
  for (const double x : replicates) sum.add(x - estimate);
  const double bias = sum.value() / count;
  Summation squares;
  for (const double x : replicates) squares.add((x - estimate - bias) * (x - estimate - bias));
  return {.estimate = estimate,
          .low = std::numeric_limits<double>::quiet_NaN(),
          .high = std::numeric_limits<double>::quiet_NaN(),
          .standard_error = std::sqrt(squares.value() / (count - 1.0)),
          .bias = bias,
          .confidence = confidence};
}

/// Between the quantiles of the replicates at two levels.
ConfidenceInterval between(double estimate, std::span<const double> replicates, double confidence, double low_level,
                           double high_level) {
  ConfidenceInterval interval = withMoments(estimate, replicates, confidence);
  std::vector<double> ascending(replicates.begin(), replicates.end());
  std::sort(ascending.begin(), ascending.end());
  interval.low = replicateQuantile(ascending, low_level);
  interval.high = replicateQuantile(ascending, high_level);
  return interval;
}

double shareBelow(double estimate, std::span<const double> replicates) {
  double below = 0.0;
  for (const double x : replicates) below += x < estimate ? 1.0 : x == estimate ? 0.5 : 0.0;
  const auto count = static_cast<double>(replicates.size());
  return std::clamp(below, 0.5, count - 0.5) / count;
}

double accelerationOf(std::span<const double> influences) {
  Summation squares;
  Summation cubes;
  for (const double d : influences) {
    squares.add(d * d);
    cubes.add(d * d * d);
  }
  return squares.value() > 0.0 ? cubes.value() / (6.0 * std::pow(squares.value(), 1.5)) : 0.0;
}

}  // namespace

double replicateQuantile(std::span<const double> ascending, double p) {
  const auto count = static_cast<double>(ascending.size());
  const double rank = std::clamp((count + 1.0) * p, 1.0, count) - 1.0;
  const auto i = static_cast<std::size_t>(rank);
  if (i + 1 == ascending.size()) return ascending.back();
  return std::lerp(ascending[i], ascending[i + 1], rank - std::floor(rank));
}

ConfidenceInterval percentileInterval(double estimate, std::span<const double> replicates, double confidence) {
  check(replicates, confidence);
  if (!allFinite(estimate, replicates)) return withMoments(estimate, replicates, confidence);
  return between(estimate, replicates, confidence, 0.5 * (1.0 - confidence), 0.5 * (1.0 + confidence));
}

ConfidenceInterval bcaInterval(double estimate, std::span<const double> replicates, std::span<const double> influences,
                               double confidence) {
  check(replicates, confidence);
  if (!allFinite(estimate, replicates) || !allFinite(estimate, influences)) {
    return withMoments(estimate, replicates, confidence);
  }
  const double z0 = boost::math::quantile(kNormal, shareBelow(estimate, replicates));
  const double a = accelerationOf(influences);
  const auto level = [&](double nominal) {
    const double z = z0 + boost::math::quantile(kNormal, nominal);
    // Past its pole the correction would exchange the ends: the level is then at the end of the replicates.
    if (1.0 - a * z <= 0.0) return z > 0.0 ? 1.0 : 0.0;
    return boost::math::cdf(kNormal, z0 + z / (1.0 - a * z));
  };
  return between(estimate, replicates, confidence, level(0.5 * (1.0 - confidence)), level(0.5 * (1.0 + confidence)));
}

}  // namespace metrics
