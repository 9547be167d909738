#include "metrics/prediction/predicted_box.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "core/error.h"

namespace metrics {

PBox widened(const PBox& box, double below, double above) {
  for (const double reach : {below, above}) {
    if (!(reach >= 0.0) || !std::isfinite(reach)) {
      throw core::InputError({.item = "widening"}, fmt::format("{} is not a finite number >= 0.", reach),
                             "Give how far the edge moves outwards.");
    }
  }
  if (below == 0.0 && above == 0.0) return box;
  return PBox::fromEdges(box.left().shifted(-below), box.right().shifted(above));
}

PredictedBox predictedBox(const PBox& simulated, const PredictedErrors& errors, BoundOf bound) {
  const double scatter = std::max(0.0, errors.scatter.value);
  PredictedBox box{.expected = widened(simulated.shifted(-errors.bias.value), scatter, scatter), .bound = {}};
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
