#include "metrics/sensitivity/sobol_indices.h"

#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <vector>

#include "core/error.h"
#include "core/parallel.h"
#include "metrics/distributions/summation.h"
#include "metrics/resampling/intervals.h"
#include "metrics/resampling/sorted_units.h"

namespace metrics {

namespace {

/// Outputs of the blocks, centred.
struct Blocks {
  std::vector<double> centred;
  std::size_t n;
  double mean;

  [[nodiscard]] std::span<const double> block(std::size_t index) const {
    return std::span(centred).subspan(index * n, n);
  }
};

void check(std::span<const double> outputs, std::size_t parameters, std::size_t n) {
  if (parameters == 0 || n < 2 || outputs.size() != n * (parameters + 2)) {
    throw core::InputError({},
                           fmt::format("{} outputs for {} parameters and n = {}; a plan of Sobol' has n (k + 2) rows.",
                                       outputs.size(), parameters, n),
                           "Give one output for each row of the plan, in its order.");
  }
  mustBeFinite(outputs);
}

Blocks centred(std::span<const double> outputs, std::size_t n) {
  Blocks blocks{.centred = {outputs.begin(), outputs.end()}, .n = n, .mean = 0.0};
  Summation sum;
  for (const double y : outputs.first(2 * n)) sum.add(y);
  blocks.mean = sum.value() / static_cast<double>(2 * n);
  for (double& y : blocks.centred) y -= blocks.mean;
  return blocks;
}

/// Of the rows taken `counts` times; first-order indices, then total ones.
struct Estimate {
  double variance;
  std::vector<double> indices;
};

Estimate estimate(const Blocks& blocks, std::size_t parameters, const Counts& counts, FirstOrderEstimator estimator) {
  const auto a = blocks.block(0);
  const auto b = blocks.block(1);
  const auto n = static_cast<double>(blocks.n);
  Summation sum;
  Summation squares;
  for (std::size_t j = 0; j < blocks.n; ++j) {
    sum.add(counts[j] * (a[j] + b[j]));
    squares.add(counts[j] * (a[j] * a[j] + b[j] * b[j]));
  }
  const double mean = sum.value() / (2.0 * n);
  Estimate result{.variance = squares.value() / (2.0 * n) - mean * mean, .indices = {}};
  std::vector<double> totals;
  for (std::size_t i = 0; i < parameters; ++i) {
    const auto mixed = blocks.block(2 + i);
    Summation first;
    Summation total;
    for (std::size_t j = 0; j < blocks.n; ++j) {
      const double from_b = b[j] - mixed[j];
      first.add(counts[j] *
                (estimator == FirstOrderEstimator::Saltelli ? b[j] * (mixed[j] - a[j]) : -0.5 * from_b * from_b));
      total.add(counts[j] * 0.5 * (a[j] - mixed[j]) * (a[j] - mixed[j]));
    }
    const double whole = estimator == FirstOrderEstimator::Saltelli ? 0.0 : result.variance;
    result.indices.push_back((whole + first.value() / n) / result.variance);
    totals.push_back(total.value() / n / result.variance);
  }
  result.indices.insert(result.indices.end(), totals.begin(), totals.end());
  return result;
}

/// Replicates of each index.
std::vector<std::vector<double>> bootstrapped(const Blocks& blocks, std::size_t parameters,
                                              const SobolOptions& options) {
  std::vector<std::vector<double>> replicates(2 * parameters, std::vector<double>(options.replicates));
  core::parallelFor(options.replicates, 4, [&](std::size_t begin, std::size_t end) {
    Counts counts;
    for (std::size_t r = begin; r < end; ++r) {
      core::Random random(
          {.seed = options.seed, .sample = static_cast<std::uint32_t>(r), .purpose = core::purposeOf("sobol indices")});
      drawWithReplacement(blocks.n, blocks.n, 1, random, counts);
      const Estimate drawn = estimate(blocks, parameters, counts, options.first_order);
      for (std::size_t i = 0; i < drawn.indices.size(); ++i) replicates[i][r] = drawn.indices[i];
    }
  });
  return replicates;
}

}  // namespace

SensitivityResult sobolIndices(std::span<const double> outputs, std::size_t parameters, std::size_t n,
                               const SobolOptions& options) {
  check(outputs, parameters, n);
  const Blocks blocks = centred(outputs, n);
  const Estimate all = estimate(blocks, parameters, Counts(n, 1), options.first_order);
  SensitivityResult result{.mean = blocks.mean, .variance = all.variance, .parameters = {}};
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double rounding = 1e-14 * blocks.mean;  // what remains of a constant once its mean is gone
  if (all.variance <= rounding * rounding) {
    const SensitivityIndex unknown{.value = nan, .low = nan, .high = nan};
    result.parameters.assign(parameters, {.first = unknown, .total = unknown});
    return result;
  }
  const auto replicates = bootstrapped(blocks, parameters, options);
  const auto index = [&](std::size_t i) {
    if (options.replicates == 0) return SensitivityIndex{.value = all.indices[i], .low = nan, .high = nan};
    const ConfidenceInterval interval = percentileInterval(all.indices[i], replicates[i], options.confidence);
    return SensitivityIndex{.value = all.indices[i], .low = interval.low, .high = interval.high};
  };
  for (std::size_t i = 0; i < parameters; ++i) {
    result.parameters.push_back({.first = index(i), .total = index(parameters + i)});
  }
  return result;
}

}  // namespace metrics
