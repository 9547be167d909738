#include "metrics/samples/divergences.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <functional>
#include <limits>
#include <string_view>
#include <vector>

#include "core/error.h"
#include "metrics/distributions/summation.h"
#include "metrics/samples/sample_values.h"

namespace metrics {

namespace {

constexpr double kMadOfNormal = 0.674489750196081743;  // 75 % quantile of the standard normal

std::vector<double> normalised(std::span<const double> numbers, std::string_view side) {
  Summation total;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (!(numbers[i] >= 0.0 && std::isfinite(numbers[i]))) {
      throw core::InputError({.item = fmt::format("{} cell {}", side, i + 1)},
                             fmt::format("is {}; a probability is finite and not negative.", numbers[i]),
                             "Correct it; nothing is dropped silently.");
    }
    total.add(numbers[i]);
  }
  if (!(total.value() > 0.0)) {
    throw core::InputError({.item = fmt::format("{} cells", side)}, "have no positive probability.",
                           "Check the bins or the file.");
  }
  std::vector<double> shares(numbers.begin(), numbers.end());
  for (double& share : shares) share /= total.value();
  return shares;
}

/// sum p log(p/q) in nats; >= 0 but for rounding, which is cut off.
double klNats(std::span<const double> p, std::span<const double> q) {
  Summation sum;
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (p[i] == 0.0) continue;
    if (q[i] == 0.0) return std::numeric_limits<double>::infinity();
    sum.add(p[i] * (std::log(p[i]) - std::log(q[i])));  // p/q may overflow
  }
  return std::max(0.0, sum.value());
}

/// (D(p||m) + D(q||m)) / 2 in nats. Always finite.
double jsNats(std::span<const double> p, std::span<const double> q) {
  const auto towardsMiddle = [](double a, double b) { return a == 0.0 ? 0.0 : a * std::log(2.0 * (a / (a + b))); };
  Summation sum;
  for (std::size_t i = 0; i < p.size(); ++i) sum.add(towardsMiddle(p[i], q[i]) + towardsMiddle(q[i], p[i]));
  return std::clamp(sum.value() / 2.0, 0.0, std::log(2.0));
}

/// Heights of the sample's steps: the weights of its distinct values.
std::vector<double> stepsOf(const Edf& sample) {
  std::vector<double> steps;
  double below = 0.0;
  for (const double level : sample.levels()) {
    steps.push_back(level - below);
    below = level;
  }
  return steps;
}

double checkedBandwidth(const Edf& sample, std::string_view side) {
  const double h = kdeBandwidth(sample);
  if (h > 0.0 && std::isfinite(h)) return h;
  throw core::InputError({.item = fmt::format("{} sample", side)},
                         fmt::format("has a kernel bandwidth of {}: more than half of its values are equal, or it "
                                     "is no sample.",
                                     h),
                         "Count in bins instead (histogramDivergences).");
}

/// As many points as asked for, and more where they would lie further apart than the narrower kernel is wide.
std::size_t enoughPoints(std::size_t asked, double range, double h) {
  const double needed = std::ceil(range / h) + 1.0;
  if (needed > 1e6) {
    throw core::InputError(
        {}, fmt::format("the values spread over {:.3g} bandwidths; no density can be read there.", needed),
        "Remove outliers, or count in bins (histogramDivergences).");
  }
  return std::max(asked, static_cast<std::size_t>(needed));
}

/// Kernel density at equidistant places, up to a common factor.
std::vector<double> densityOf(const Edf& sample, double h, double first, double step, std::size_t points) {
  const std::vector<double> steps = stepsOf(sample);
  const std::span<const double> values = sample.values();
  std::vector<double> density(points);
  for (std::size_t k = 0; k < points; ++k) {
    const double x = first + static_cast<double>(k) * step;
    // Beyond 40 bandwidths exp() is exactly 0.
    const auto from = std::lower_bound(values.begin(), values.end(), x - 40.0 * h) - values.begin();
    const auto to = std::upper_bound(values.begin(), values.end(), x + 40.0 * h) - values.begin();
    double sum = 0.0;
    for (auto i = static_cast<std::size_t>(from); i < static_cast<std::size_t>(to); ++i) {
      const double z = (x - values[i]) / h;
      sum += steps[i] * std::exp(-z * z / 2.0);
    }
    density[k] = sum;
  }
  return density;
}

void mustRise(std::span<const double> edges) {
  const bool finite = std::all_of(edges.begin(), edges.end(), [](double x) { return std::isfinite(x); });
  const bool rises = std::adjacent_find(edges.begin(), edges.end(), std::greater_equal<>()) == edges.end();
  if (edges.size() >= 2 && finite && rises) return;
  throw core::InputError({.item = "edges"}, "must be two or more finite numbers, each larger than the one before.",
                         "Sort them and remove repeated ones.");
}

std::vector<double> countsOf(const Edf& sample, std::span<const double> edges, std::string_view side) {
  if (sample.min() < edges.front() || sample.max() > edges.back()) {
    throw core::InputError({.item = fmt::format("{} sample", side)},
                           fmt::format("reaches from {} to {}, the bins only from {} to {}.", sample.min(),
                                       sample.max(), edges.front(), edges.back()),
                           "Let the bins hold every value; nothing is dropped silently.");
  }
  const std::vector<double> steps = stepsOf(sample);
  std::vector<double> counts(edges.size() - 1);
  std::size_t bin = 0;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    while (bin + 1 < counts.size() && sample.values()[i] >= edges[bin + 1]) ++bin;
    counts[bin] += steps[i];
  }
  return counts;
}

}  // namespace

Divergences divergences(const Probabilities& cells, InformationUnit unit) {
  if (cells.simulated.size() != cells.measured.size()) {
    throw core::InputError(
        {}, fmt::format("{} simulated cells, {} measured.", cells.simulated.size(), cells.measured.size()),
        "Count both samples in the same cells.");
  }
  const std::vector<double> p = normalised(cells.measured, "measured");
  const std::vector<double> q = normalised(cells.simulated, "simulated");
  const double per_nat = unit == InformationUnit::Nat ? 1.0 : 1.0 / std::log(2.0);
  const double kl = klNats(p, q) * per_nat;
  const double kl_reverse = klNats(q, p) * per_nat;
  const double js = jsNats(p, q) * per_nat;
  return {.kl = kl,
          .kl_reverse = kl_reverse,
          .symmetrised = (kl + kl_reverse) / 2.0,
          .js = js,
          .js_distance = std::sqrt(js)};
}

Divergences histogramDivergences(const SamplePair& samples, std::span<const double> edges, InformationUnit unit) {
  mustRise(edges);
  const std::vector<double> simulated = countsOf(samples.simulated, edges, "simulated");
  const std::vector<double> measured = countsOf(samples.measured, edges, "measured");
  return divergences({.simulated = simulated, .measured = measured}, unit);
}

double kdeBandwidth(const Edf& sample) {
  if (sample.effectiveN() <= 0.0) return std::numeric_limits<double>::quiet_NaN();
  const double centre = sample.median();
  const bool plain = isPlainSample(sample);
  std::vector<double> distances(sample.values().begin(), sample.values().end());
  if (plain) distances = sampleValues(sample, "a");
  for (double& x : distances) x = std::abs(x - centre);
  const double mad = (plain ? Edf(distances) : Edf::weighted(distances, stepsOf(sample))).median();
  return 1.06 * mad / kMadOfNormal * std::pow(sample.effectiveN(), -0.2);
}

Divergences kdeDivergences(const SamplePair& samples, InformationUnit unit, std::size_t points) {
  if (points < 2) {
    throw core::InputError({.item = "points"}, fmt::format("is {}; a density is read at two places or more.", points),
                           "Usual is 100.");
  }
  const double h_simulated = checkedBandwidth(samples.simulated, "simulated");
  const double h_measured = checkedBandwidth(samples.measured, "measured");
  const double first = std::min(samples.simulated.min() - 3.0 * h_simulated, samples.measured.min() - 3.0 * h_measured);
  const double last = std::max(samples.simulated.max() + 3.0 * h_simulated, samples.measured.max() + 3.0 * h_measured);
  points = enoughPoints(points, last - first, std::min(h_simulated, h_measured));
  const double step = (last - first) / static_cast<double>(points - 1);
  const std::vector<double> simulated = densityOf(samples.simulated, h_simulated, first, step, points);
  const std::vector<double> measured = densityOf(samples.measured, h_measured, first, step, points);
  return divergences({.simulated = simulated, .measured = measured}, unit);
}

}  // namespace metrics
