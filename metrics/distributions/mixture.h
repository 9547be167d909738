#pragma once

#include <span>

#include "metrics/distributions/edf.h"
#include "metrics/distributions/p_box.h"

namespace metrics {

/// Mixture: the distribution of a value that is drawn from part i with probability w_i / sum w.
///
///   F(x) = sum_i w_i F_i(x) / sum_i w_i
///
/// For circumstances whose shares are known (so much rain, so much sun): the choice of the part is aleatory. If the
/// shares are not known it is epistemic, and PBox::envelope is right: it contains every mixture.
/// With the sample sizes as weights it is the distribution of the pooled sample.
///
/// Exact: it steps where a part steps, by its weight; no grid. It has no sample: n() is 0.
/// Throws InputError if there is no part, the lengths differ, a weight is negative or not finite, or none is positive.
[[nodiscard]] Edf mixture(std::span<const Edf> parts, std::span<const double> weights);

/// All mixtures of one distribution from each box: mixture of the left edges, mixture of the right edges. Tight, for
/// F grows with every F_i. Source: Ferson et al. 2003, SAND2002-4015.
[[nodiscard]] PBox mixture(std::span<const PBox> parts, std::span<const double> weights);

}  // namespace metrics
