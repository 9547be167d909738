#include "metrics/samples/kolmogorov_smirnov.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <vector>

#include "metrics/distributions/value_walk.h"
#include "metrics/samples/sample_values.h"

namespace metrics {

namespace {

constexpr double kHeavyTies = 0.05;

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

/// Share of the paths to (n, m) that touch the distance, from the shares of the two points before: the last step to
/// (i, j) came from (i - 1, j) for i of its i + j ancestors.
double exactPValue(double statistic, std::int64_t n, std::int64_t m) {
  const std::int64_t common = std::gcd(n, m);
  const std::int64_t step_n = m / common;  // distances in units of 1 / lcm(n, m) are integers
  const std::int64_t step_m = n / common;
  const auto distance = std::llround(statistic * static_cast<double>(n * step_n));
  std::vector<double> share(static_cast<std::size_t>(m) + 1);
  for (std::int64_t i = 0; i <= n; ++i) {
    for (std::int64_t j = 0; j <= m; ++j) {
      double& here = share[static_cast<std::size_t>(j)];  // holds (i - 1, j)
      if (std::abs(i * step_n - j * step_m) >= distance) {
        here = 1.0;
      } else if (i + j == 0) {
        here = 0.0;
      } else {
        const double from_left = j == 0 ? 0.0 : share[static_cast<std::size_t>(j - 1)] * static_cast<double>(j);
        here = (here * static_cast<double>(i) + from_left) / static_cast<double>(i + j);
      }
    }
  }
  return share.back();
}

}  // namespace

KolmogorovSmirnov kolmogorovSmirnovTest(const SamplePair& samples, KsPValue method) {
  const auto& [simulated, measured] = samples;
  double statistic = 0.0;
  std::size_t distinct = 0;
  eachCommonValue(simulated, measured, [&](double, double at_simulated, double at_measured) {
    statistic = std::max(statistic, std::abs(at_simulated - at_measured));
    ++distinct;
  });
  const double n = simulated.effectiveN();
  const double m = measured.effectiveN();
  const bool sized = simulated.n() > 0 && measured.n() > 0;
  const double values = static_cast<double>(simulated.n() + measured.n());
  const double tie_share = sized ? 1.0 - static_cast<double>(distinct) / values : 0.0;

  const bool exact =
      method == KsPValue::ExactIfSmall && isPlainSample(simulated) && isPlainSample(measured) && n * m <= kExactKsLimit;
  return {.statistic = statistic,
          .p_value = exact ? exactPValue(statistic, static_cast<std::int64_t>(simulated.n()),
                                         static_cast<std::int64_t>(measured.n()))
                           : stephensPValue(statistic, n, m),
          .method = exact ? KsPValue::ExactIfSmall : KsPValue::Stephens,
          .tie_share = tie_share,
          .heavy_ties = tie_share > kHeavyTies};
}

}  // namespace metrics
