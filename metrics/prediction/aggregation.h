#pragma once

#include "metrics/area/area_metric.h"
#include "metrics/distributions/p_box.h"
#include "metrics/distributions/propagation.h"
#include "metrics/prediction/prediction.h"

namespace metrics {

/// Model-form uncertainty: how far reality may lie beside the simulation for want of a perfect model.
///
///   below  to smaller values: d-, by which the simulation is too high
///   above  to larger values:  d+, by which it is too low
///
/// Each part on its side (Roy & Balch 2012):
[[nodiscard]] Margin modelFormOf(const AreaPortions& portions);

/// d_AVM on both sides (Roy & Oberkampf 2011).
[[nodiscard]] Margin modelFormOf(double area);

/// Where there was no measurement: the upper bounds of d+ and d- for one more sample (the regression's prediction
/// interval, as Roy & Oberkampf 2011 extrapolate d_AVM). Infinite without degrees of freedom: aggregate() refuses it.
struct PredictedPortions {
  const PredictedError& d_plus;
  const PredictedError& d_minus;
};
[[nodiscard]] Margin modelFormOf(const PredictedPortions& portions);

/// What is known to be uncertain in a simulated result.
struct Uncertainties {
  const PBox& input;       ///< propagated through the model: aleatory shape, epistemic width
  Margin model_form;       ///< from validation
  double numerical = 0.0;  ///< U_num >= 0: discretisation, sampling of rays, rounding
};

/// One box that holds them all, and how far it grew. Independent of the order in which they are appended.
///
///   p 1 |      _____      ____
///       |   __|  __|  in |   __|        left edge:   - d- - U_num
///     0 |__|____|________|__|____ x     right edge:  + d+ + U_num
struct AggregatedUncertainty {
  PBox total;
  PBox with_model_form;  ///< before the numerical part
};

/// Throws InputError if a part is negative or not finite.
/// Source: Roy & Oberkampf 2011, doi:10.1016/j.cma.2011.03.016; Roy & Balch 2012, A holistic approach to uncertainty
/// quantification with application to supersonic nozzle thrust, Int. J. Uncertainty Quantification 2(4).
[[nodiscard]] AggregatedUncertainty aggregate(const Uncertainties& parts);

}  // namespace metrics
