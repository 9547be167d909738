#include "metrics/prediction/predicted_box.h"

#include <algorithm>
#include <cmath>

#include "metrics/distributions/propagation.h"

namespace metrics {

PredictedBox predictedBox(const PBox& simulated, const PredictedErrors& errors, BoundOf bound) {
  const double scatter = std::max(0.0, errors.scatter.value);
  PredictedBox box{.expected = widened(simulated.shifted(-errors.bias.value), {.below = scatter, .above = scatter}),
                   .bound = {}};
  const bool confidence = bound == BoundOf::Confidence;
  const Interval bias = confidence ? errors.bias.confidence : errors.bias.observation;
  const double most = confidence ? errors.scatter.confidence.high : errors.scatter.observation.high;
  if (std::isfinite(bias.low) && std::isfinite(bias.high) && std::isfinite(most)) {
    const double reach = std::max(0.0, most);
    box.bound =
        PBox::fromEdges(simulated.left().shifted(-bias.high - reach), simulated.right().shifted(-bias.low + reach));
  }
  return box;
}

}  // namespace metrics
