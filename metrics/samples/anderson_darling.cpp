#include "metrics/samples/anderson_darling.h"

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "core/error.h"
#include "core/random.h"
#include "metrics/distributions/summation.h"
#include "metrics/distributions/value_walk.h"
#include "metrics/samples/sample_values.h"

namespace metrics {

namespace {

constexpr double kPi = boost::math::double_constants::pi;
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// Counts of both samples at one value of the pooled sample. Fractional if weighted.
struct Counts {
  double simulated;
  double measured;
};

std::vector<Counts> countsOf(const SamplePair& samples) {
  const double n = samples.simulated.effectiveN();
  const double m = samples.measured.effectiveN();
  std::vector<Counts> counts;
  double before_simulated = 0.0;
  double before_measured = 0.0;
  eachCommonValue(samples.simulated, samples.measured, [&](double, double simulated, double measured) {
    counts.push_back({.simulated = n * (simulated - before_simulated), .measured = m * (measured - before_measured)});
    before_simulated = simulated;
    before_measured = measured;
  });
  return counts;
}

/// For k = 2 the two samples' terms differ by a factor: N M_1 - n B = -(N M_2 - m B) = m M_1 - n M_2.
double statisticOf(const std::vector<Counts>& counts, double n, double m) {
  const double total = n + m;
  Summation sum;
  double below_simulated = 0.0;
  double below_measured = 0.0;
  for (const Counts& at : counts) {
    const double mid_simulated = below_simulated + at.simulated / 2.0;
    const double mid_measured = below_measured + at.measured / 2.0;
    const double mid = mid_simulated + mid_measured;
    const double ties = at.simulated + at.measured;
    const double variance = mid * (total - mid) - total * ties / 4.0;
    const double gap = m * mid_simulated - n * mid_measured;
    if (variance > 0.0) sum.add(ties / total * gap * gap / variance);
    below_simulated += at.simulated;
    below_measured += at.measured;
  }
  return (total - 1.0) / total * (1.0 / n + 1.0 / m) * sum.value();
}

/// Standard deviation of A^2 of two samples without ties (Scholz & Stephens, the polynomial in N with k = 2).
double deviationOf(double n, double m) {
  const double total = n + m;
  if (total < 4.0) return kNaN;
  const double inverse = 1.0 / n + 1.0 / m;
  const auto last = static_cast<std::int64_t>(std::llround(total)) - 1;
  double harmonic = 0.0;      // h = sum_{i < N} 1/i
  double harmonic_sum = 0.0;  // g = sum_{i < j < N} 1 / ((N - i) j)
  double reverse = 0.0;       // sum_{i < j} 1 / (N - i)
  for (std::int64_t j = 1; j <= last; ++j) {
    harmonic_sum += reverse / static_cast<double>(j);
    harmonic += 1.0 / static_cast<double>(j);
    reverse += 1.0 / static_cast<double>(last + 1 - j);
  }
  const double h = harmonic;
  const double g = harmonic_sum;
  const double a = (4.0 * g - 6.0) + (10.0 - 6.0 * g) * inverse;
  const double b = 4.0 * (2.0 * g - 4.0) + 16.0 * h + (2.0 * g - 14.0 * h - 4.0) * inverse - 8.0 * h + 4.0 * g - 6.0;
  const double c =
      4.0 * (6.0 * h + 2.0 * g - 2.0) + 2.0 * (4.0 * h - 4.0 * g + 6.0) + (2.0 * h - 6.0) * inverse + 4.0 * h;
  const double d = 4.0 * (2.0 * h + 6.0) - 8.0 * h;
  const double variance = (((a * total + b) * total + c) * total + d) / ((total - 1.0) * (total - 2.0) * (total - 3.0));
  return std::sqrt(variance);
}

/// log of the standard normal's upper tail. Far out by its asymptotic series, whose error at z = 25 is below 1e-14.
double logUpperTail(double z) {
  if (z < 25.0) return std::log(0.5 * std::erfc(z / boost::math::double_constants::root_two));
  const double y = 1.0 / (z * z);
  const double series = y * (-1.0 + y * (3.0 + y * (-15.0 + y * (105.0 + y * (-945.0 + y * 10395.0)))));
  return -z * z / 2.0 - std::log(z) - std::log(2.0 * kPi) / 2.0 + std::log1p(series);
}

double sumOf(const Edf& sample, const Normal& normal, double (*log_upper)(double)) {
  const std::span<const double> values = sample.values();
  const std::span<const double> levels = sample.levels();
  Summation sum;
  double below = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double z = (values[i] - normal.mean) / normal.deviation;
    const double p = levels[i];
    sum.add((p - below) * (p + below) * logUpperTail(-z));
    sum.add((p - below) * (2.0 - p - below) * log_upper(z));
    below = p;
  }
  return sum.value();
}

double upperTailAsPublished(double z) { return 1.0 - 0.5 * std::erfc(-z / boost::math::double_constants::root_two); }

}  // namespace

// Smirnov's formula for sum_j chi^2_j / lambda_j with lambda_j = j (j + 1):
//   P(A^2 > z) = 1/pi sum_k (-1)^(k+1) int_{lambda_{2k-1}}^{lambda_{2k}} exp(-z u / 2) / (u sqrt|D(u)|) du,
// where D(u) = prod_j (1 - u / lambda_j) = -cos(pi/2 sqrt(1 + 4u)) / (pi u). With s = sqrt(1 + 4u) = 4k + v the
// intervals are -1 < v < 1, and the square roots at their ends make it a Gauss-Chebyshev sum, exact to rounding with 64
// nodes.
double andersonDarlingTail(double z) {
  if (std::isnan(z)) return kNaN;
  if (z < 0.02) return 1.0;  // 1 - p < 1e-25
  constexpr int kNodes = 64;
  double tail = 0.0;
  for (int k = 1; k <= 200; ++k) {
    double sum = 0.0;
    for (int i = 0; i < kNodes; ++i) {
      const double v = std::cos((i + 0.5) * kPi / kNodes);
      const double s = 4.0 * k + v;
      const double u4 = s * s - 1.0;
      sum += std::sqrt((1.0 - v * v) / (u4 * std::cos(kPi * v / 2.0))) * s * std::exp(-z * u4 / 8.0);
    }
    const double term = sum * kPi / kNodes / std::sqrt(kPi);
    tail += k % 2 == 1 ? term : -term;
    if (term < 1e-18 * std::abs(tail)) break;
  }
  return std::clamp(tail, 0.0, 1.0);
}

AndersonDarling andersonDarlingTest(const SamplePair& samples) {
  const double n = samples.simulated.effectiveN();
  const double m = samples.measured.effectiveN();
  if (n <= 0.0 || m <= 0.0) return {.statistic = kNaN, .standardised = kNaN, .p_value = kNaN};
  const std::vector<Counts> counts = countsOf(samples);
  const double statistic = statisticOf(counts, n, m);
  const double standardised = counts.size() < 2 ? kNaN : (statistic - 1.0) / deviationOf(n, m);
  const double limit_deviation = std::sqrt(2.0 * (kPi * kPi - 9.0) / 3.0);
  return {.statistic = statistic,
          .standardised = standardised,
          .p_value = andersonDarlingTail(1.0 + limit_deviation * standardised)};
}

AndersonDarling andersonDarlingPermutationTest(const SamplePair& samples, std::uint32_t shuffles, std::uint64_t seed) {
  if (shuffles == 0) {
    throw core::InputError({.item = "shuffles"}, "is 0; a permutation test needs at least one.", "Usual is 999.");
  }
  const std::vector<double> simulated = sampleValues(samples.simulated, "simulated");
  const std::vector<double> measured = sampleValues(samples.measured, "measured");
  const auto n = static_cast<double>(simulated.size());
  const auto m = static_cast<double>(measured.size());
  AndersonDarling result = andersonDarlingTest(samples);

  std::vector<Counts> counts = countsOf(samples);
  std::vector<std::uint32_t> group;  // of each pooled value
  std::vector<char> is_simulated;
  for (std::size_t x = 0; x < counts.size(); ++x) {
    for (auto left = std::llround(counts[x].simulated + counts[x].measured); left > 0; --left) {
      group.push_back(static_cast<std::uint32_t>(x));
      is_simulated.push_back(is_simulated.size() < simulated.size());
    }
  }
  core::Random random({.seed = seed, .purpose = core::purposeOf("anderson_darling_permutation")});
  const double observed = result.statistic * (1.0 - 1e-12);  // the same order must count as at least as large
  std::uint32_t at_least = 0;
  for (std::uint32_t shuffle = 0; shuffle < shuffles; ++shuffle) {
    for (std::size_t i = group.size(); i > 1; --i) {
      std::swap(is_simulated[i - 1], is_simulated[random.below(static_cast<std::uint32_t>(i))]);
    }
    std::fill(counts.begin(), counts.end(), Counts{.simulated = 0.0, .measured = 0.0});
    for (std::size_t i = 0; i < group.size(); ++i) {
      (is_simulated[i] ? counts[group[i]].simulated : counts[group[i]].measured) += 1.0;
    }
    if (statisticOf(counts, n, m) >= observed) ++at_least;
  }
  result.p_value = (1.0 + at_least) / (1.0 + shuffles);
  return result;
}

AndersonDarlingToNormal andersonDarlingToNormal(const Edf& sample, const Normal& normal) {
  if (!(normal.deviation > 0.0 && std::isfinite(normal.deviation) && std::isfinite(normal.mean))) {
    throw core::InputError({.item = "normal distribution"},
                           fmt::format("has mean {} and deviation {}.", normal.mean, normal.deviation),
                           "Fit it to at least two values that differ.");
  }
  const double n = sample.effectiveN() > 0.0 ? sample.effectiveN() : kNaN;
  const auto rounded_off = std::count_if(sample.values().begin(), sample.values().end(), [&](double x) {
    return upperTailAsPublished((x - normal.mean) / normal.deviation) == 0.0;
  });
  const auto published = [](double z) { return std::log(upperTailAsPublished(z)); };
  return {.statistic = -n * (1.0 + sumOf(sample, normal, logUpperTail)),
          .as_published = rounded_off > 0 ? n * kInfinity : -n * (1.0 + sumOf(sample, normal, published)),
          .rounded_off = static_cast<std::size_t>(rounded_off)};
}

AndersonDarlingToNormal andersonDarlingToFittedNormal(const SamplePair& samples) {
  return andersonDarlingToNormal(samples.simulated,
                                 {.mean = samples.measured.mean(), .deviation = samples.measured.standardDeviation()});
}

}  // namespace metrics
