#include "metrics/prediction/aggregation.h"

#include "metrics/prediction/predicted_box.h"

namespace metrics {

ModelFormUncertainty modelFormOf(const AreaPortions& portions) {
  return {.below = portions.d_minus, .above = portions.d_plus};
}

ModelFormUncertainty modelFormOf(double area) { return {.below = area, .above = area}; }

ModelFormUncertainty modelFormOf(const PredictedPortions& portions) {
  return {.below = portions.d_minus.observation.high, .above = portions.d_plus.observation.high};
}

AggregatedUncertainty aggregate(const Uncertainties& parts) {
  const PBox with_model_form = widened(parts.input, parts.model_form.below, parts.model_form.above);
  return {.total = widened(with_model_form, parts.numerical, parts.numerical), .with_model_form = with_model_form};
}

}  // namespace metrics
