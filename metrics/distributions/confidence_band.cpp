#include "metrics/distributions/confidence_band.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "core/error.h"

namespace metrics {

namespace {

void mustHold(const Edf& edf, const Interval& support) {
  if (edf.n() == 0) {
    throw core::InputError({}, "a distribution without a sample (table, edge, mixture) has no confidence band.",
                           "Give the sample itself.");
  }
  if (!std::isfinite(support.low) || !std::isfinite(support.high)) {
    throw core::InputError({}, fmt::format("the support [{}, {}] is not bounded.", support.low, support.high),
                           "Give the smallest and the largest value that the measurand can have.");
  }
  if (!support.contains(edf.min()) || !support.contains(edf.max())) {
    throw core::InputError({},
                           fmt::format("the sample reaches from {} to {}, outside the support [{}, {}].", edf.min(),
                                       edf.max(), support.low, support.high),
                           "Give the smallest and the largest value that the measurand can have.");
  }
}

}  // namespace

double confidenceHalfWidth(double n, double alpha) {
  if (!(n > 0.0) || !std::isfinite(n)) {
    throw core::InputError({}, fmt::format("a confidence band of {} values; it needs at least one.", n),
                           "Give the size of the sample.");
  }
  if (!(alpha > 0.0 && alpha < 1.0)) {
    throw core::InputError({}, fmt::format("alpha is {}; it lies between 0 and 1, both excluded.", alpha),
                           "Give the probability of an error: 0.05 for a confidence of 95 %.");
  }
  return std::sqrt(std::log(2.0 / alpha) / (2.0 * n));
}

PBox confidenceBand(const Edf& edf, double alpha, const Interval& support) {
  mustHold(edf, support);
  const double eps = confidenceHalfWidth(edf.effectiveN(), alpha);
  EdfBuilder left;
  EdfBuilder right;
  left.reserve(edf.values().size() + 1);
  right.reserve(edf.values().size() + 1);
  left.step(support.low, std::min(1.0, eps));
  for (std::size_t i = 0; i < edf.values().size(); ++i) {
    left.step(edf.values()[i], std::min(1.0, edf.level(i) + eps));
    right.step(edf.values()[i], std::max(0.0, edf.level(i) - eps));
  }
  right.step(support.high, 1.0);
  return PBox::fromEdges(std::move(left).build(), std::move(right).build());
}

}  // namespace metrics
