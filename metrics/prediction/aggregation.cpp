#include "metrics/prediction/aggregation.h"

namespace metrics {

Margin modelFormOf(const AreaPortions& portions) { return {.below = portions.d_minus, .above = portions.d_plus}; }

Margin modelFormOf(double area) { return {.below = area, .above = area}; }

Margin modelFormOf(const PredictedPortions& portions) {
  return {.below = portions.d_minus.observation.high, .above = portions.d_plus.observation.high};
}

AggregatedUncertainty aggregate(const Uncertainties& parts) {
  const PBox with_model_form = widened(parts.input, parts.model_form);
  return {.total = widened(with_model_form, {.below = parts.numerical, .above = parts.numerical}),
          .with_model_form = with_model_form};
}

}  // namespace metrics
