#include "metrics/grids/map_score.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "core/text.h"
#include "metrics/distributions/summation.h"

namespace metrics {

double mapScore(const GridPair& grids, double clip) {
  const SeriesPair cells = cellByCell(grids);
  if (!(clip >= 0.0 && clip < 0.5)) {
    throw core::InputError({.item = "clip of the map score"}, "is " + core::shortestNumber(clip) + ".",
                           "Give a probability in [0, 0.5): how far from 0 and 1 certainty ends.");
  }
  double impossible = 0.0;  // -inf once two certain cells differ: apart, because inf - inf would spoil the summation
  Summation sum;
  for (std::size_t i = 0; i < cells.measured.size(); ++i) {
    const double p = std::clamp(cells.simulated[i], clip, 1.0 - clip);
    const double q = std::clamp(cells.measured[i], clip, 1.0 - clip);
    const double score = 1.0 + std::log2(p * q + (1.0 - p) * (1.0 - q));
    if (std::isinf(score)) {
      impossible = score;
    } else {
      sum.add(score);
    }
  }
  return sum.value() + impossible;
}

double mapScorePerCell(const GridPair& grids, double clip) {
  return mapScore(grids, clip) / static_cast<double>(grids.measured.probabilities.size());
}

}  // namespace metrics
