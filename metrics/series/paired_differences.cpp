#include "metrics/series/paired_differences.h"

#include <algorithm>
#include <cmath>

#include "metrics/distributions/summation.h"

namespace metrics {

namespace {

/// Sum of term(simulated - measured) over all pairs.
template <typename Term>
double sumOverPairs(const SeriesPair& pair, Term term) {
  requirePaired(pair);
  Summation sum;
  for (std::size_t i = 0; i < pair.measured.size(); ++i) sum.add(term(pair.simulated[i] - pair.measured[i]));
  return sum.value();
}

double count(const SeriesPair& pair) { return static_cast<double>(pair.measured.size()); }

}  // namespace

double manhattanDistance(const SeriesPair& pair) {
  return sumOverPairs(pair, [](double d) { return std::abs(d); });
}

double residualSumOfSquares(const SeriesPair& pair) {
  return sumOverPairs(pair, [](double d) { return d * d; });
}

double chebyshevDistance(const SeriesPair& pair) {
  requirePaired(pair);
  double largest = 0.0;
  for (std::size_t i = 0; i < pair.measured.size(); ++i) {
    largest = std::max(largest, std::abs(pair.simulated[i] - pair.measured[i]));
  }
  return largest;
}

double euclideanDistance(const SeriesPair& pair) { return std::sqrt(residualSumOfSquares(pair)); }
double meanSquareError(const SeriesPair& pair) { return residualSumOfSquares(pair) / count(pair); }
double rootMeanSquareError(const SeriesPair& pair) { return std::sqrt(meanSquareError(pair)); }
double meanAbsoluteError(const SeriesPair& pair) { return manhattanDistance(pair) / count(pair); }

double meanSignedError(const SeriesPair& pair) {
  return sumOverPairs(pair, [](double d) { return d; }) / count(pair);
}

}  // namespace metrics
