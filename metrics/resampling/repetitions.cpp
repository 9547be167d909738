#include "metrics/resampling/repetitions.h"

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <fmt/format.h>
#include <limits>

#include "core/error.h"
#include "metrics/distributions/edf.h"
#include "metrics/distributions/summation.h"

namespace metrics {

namespace {

void mustBePositive(double half_width) {
  if (half_width > 0.0 && std::isfinite(half_width)) return;
  throw core::InputError({.item = "half width"}, fmt::format("is {}; it must be positive.", half_width),
                         "Give the largest error of the figure that is of no consequence.");
}

void mustBeAChance(double confidence) {
  if (confidence > 0.0 && confidence < 1.0) return;
  throw core::InputError({.item = "confidence"}, fmt::format("is {}; it must lie between 0 and 1.", confidence),
                         "Give 0.95 for 95 per cent.");
}

/// A factor in proportion to a variance that is known with these degrees of freedom.
Repetitions withUncertainty(double factor, double degrees, double confidence) {
  const boost::math::chi_squared distribution(degrees);
  return {.factor = factor,
          .low = factor * degrees / boost::math::quantile(distribution, 0.5 * (1.0 + confidence)),
          .high = factor * degrees / boost::math::quantile(distribution, 0.5 * (1.0 - confidence))};
}

/// Part of the variance of a figure that one side brings.
struct SideVariance {
  double variance;  ///< sum D^2
  double variance_of_it;
};

SideVariance sideVariance(std::span<const double> influences) {
  Summation sum;
  for (const double d : influences) sum.add(d * d);
  const auto groups = static_cast<double>(influences.size());
  const double mean = sum.value() / groups;
  Summation squares;
  for (const double d : influences) squares.add((d * d - mean) * (d * d - mean));
  return {.variance = sum.value(), .variance_of_it = squares.value() * groups / (groups - 1.0)};
}

struct FigureVariance {
  double degrees;
  double measured_share;
};

FigureVariance figureVariance(std::span<const double> influences, std::span<const std::size_t> groups) {
  double variance = 0.0;
  double variance_of_it = 0.0;
  double measured = 0.0;
  double most_degrees = 0.0;
  std::size_t begin = 0;
  for (std::size_t side = 0; side < groups.size(); ++side) {
    const SideVariance part = sideVariance(influences.subspan(begin, groups[side]));
    begin += groups[side];
    variance += part.variance;
    variance_of_it += part.variance_of_it;
    most_degrees += static_cast<double>(groups[side]) - 1.0;
    if (side == 0) measured = part.variance;
  }
  const double nan = std::numeric_limits<double>::quiet_NaN();
  return {.degrees =
              variance_of_it > 0.0 ? std::min(most_degrees, 2.0 * variance * variance / variance_of_it) : most_degrees,
          .measured_share = groups.size() > 1 && variance > 0.0 ? measured / variance : nan};
}

}  // namespace

std::size_t Repetitions::of(std::size_t pilot) const {
  // 1e-9: a factor of exactly 2 may come out as 2 and a rounding.
  return static_cast<std::size_t>(std::max(2.0, std::ceil(factor * static_cast<double>(pilot) * (1.0 - 1e-9))));
}

Repetitions repetitionsForMean(std::span<const double> pilot, double half_width, double confidence) {
  mustBePositive(half_width);
  mustBeAChance(confidence);
  if (pilot.size() < 2) {
    throw core::InputError({.item = "pilot"}, fmt::format("has {} values; its scatter is not known.", pilot.size()),
                           "Repeat the pilot twice or more.");
  }
  const double deviation = Edf(std::vector<double>(pilot.begin(), pilot.end())).standardDeviation();
  const double z = boost::math::quantile(boost::math::normal(), 0.5 * (1.0 + confidence));
  const auto n = static_cast<double>(pilot.size());
  return withUncertainty(std::pow(z * deviation / half_width, 2.0) / n, n - 1.0, confidence);
}

std::vector<FigureRepetitions> repetitionsForFigures(const UnitComparison& samples, std::span<const double> half_widths,
                                                     const Figures& figures, const BootstrapOptions& options,
                                                     core::Progress& progress) {
  std::for_each(half_widths.begin(), half_widths.end(), mustBePositive);
  mustBeAChance(options.confidence);
  BootstrapOptions with_influences = options;
  with_influences.method = IntervalMethod::BCa;
  const BootstrapReplicates all = bootstrapReplicates(samples, half_widths.size(), figures, with_influences, progress);
  std::vector<FigureRepetitions> results;
  for (std::size_t f = 0; f < half_widths.size(); ++f) {
    const ConfidenceInterval interval = intervalOf(all, f, options);
    const FigureVariance variance = figureVariance(all.influences[f], all.groups);
    const double factor = std::pow(interval.width() / (2.0 * half_widths[f]), 2.0);
    results.push_back({.repetitions = withUncertainty(factor, variance.degrees, options.confidence),
                       .pilot = interval,
                       .measured_share = variance.measured_share});
  }
  return results;
}

}  // namespace metrics
