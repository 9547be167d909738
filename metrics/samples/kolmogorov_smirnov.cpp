#include "metrics/samples/kolmogorov_smirnov.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "metrics/distributions/value_walk.h"

namespace metrics {

namespace {

double stephensPValue(double statistic, double n, double m) {
  if (n <= 0.0 || m <= 0.0) return std::numeric_limits<double>::quiet_NaN();
  const double root = std::sqrt(n * m / (n + m));
  const double lambda = (root + 0.12 + 0.11 / root) * statistic;
  if (lambda < 0.2) return 1.0;  // 1 - p < 1e-12, and the series converges slowly there
  double sum = 0.0;
  double sign = 1.0;
  for (int j = 1; j <= 100; ++j, sign = -sign) {
    const double term = std::exp(-2.0 * j * j * lambda * lambda);
    sum += sign * term;
    if (term < 1e-18) break;
  }
  return std::clamp(2.0 * sum, 0.0, 1.0);
}

}  // namespace

KolmogorovSmirnov kolmogorovSmirnovTest(const SamplePair& samples) {
  double statistic = 0.0;
  eachCommonValue(samples.simulated, samples.measured, [&](double, double simulated, double measured) {
    statistic = std::max(statistic, std::abs(simulated - measured));
  });
  return {.statistic = statistic,
          .p_value = stephensPValue(statistic, samples.simulated.effectiveN(), samples.measured.effectiveN())};
}

}  // namespace metrics
