#include "metrics/samples/wasserstein.h"

#include <cmath>

#include "metrics/distributions/summation.h"
#include "metrics/distributions/value_walk.h"

namespace metrics {

double wassersteinDistance(const SamplePair& samples) {
  Summation sum;
  double before = 0.0;
  double gap = 0.0;  // |F - G| between `before` and the next value; 0 left of the first
  eachCommonValue(samples.simulated, samples.measured, [&](double x, double simulated, double measured) {
    sum.add(gap * (x - before));
    gap = std::abs(simulated - measured);
    before = x;
  });
  return sum.value();
}

}  // namespace metrics
