#include "metrics/series/correlation.h"

#include <algorithm>
#include <limits>

#include "metrics/distributions/summation.h"
#include "metrics/series/centred_series.h"
#include "metrics/series/paired_differences.h"

namespace metrics {

namespace {

constexpr double kUndefined = std::numeric_limits<double>::quiet_NaN();

/// Asked of the values, not of their variance: the mean of equal values may round, and the rest would correlate.
bool isConstant(std::span<const double> series) {
  return std::all_of(series.begin(), series.end(), [&](double value) { return value == series.front(); });
}

}  // namespace

std::optional<std::string_view> whyUncorrelated(const SeriesPair& pair) {
  const bool simulated = isConstant(pair.simulated);
  const bool measured = isConstant(pair.measured);
  if (simulated && measured) return "both series are constant";
  if (simulated) return "the simulated series is constant";
  if (measured) return "the measured series is constant";
  return std::nullopt;
}

double pearsonCorrelation(const SeriesPair& pair) {
  requirePaired(pair);
  if (whyUncorrelated(pair)) return kUndefined;
  const CentredSeries simulated(pair.simulated);
  const CentredSeries measured(pair.measured);
  Summation products;
  for (std::size_t i = 0; i < measured.values.size(); ++i) products.add(simulated.values[i] * measured.values[i]);
  return std::clamp(products.value() / simulated.norm() / measured.norm(), -1.0, 1.0);  // rounding may exceed 1
}

double coefficientOfDetermination(const SeriesPair& pair) {
  const double residual = residualSumOfSquares(pair);
  if (isConstant(pair.measured)) return kUndefined;
  return 1.0 - residual / CentredSeries(pair.measured).square_sum;
}

}  // namespace metrics
