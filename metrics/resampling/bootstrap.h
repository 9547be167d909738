#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "core/progress.h"
#include "metrics/distributions/comparison.h"
#include "metrics/resampling/intervals.h"
#include "metrics/resampling/unit_sample.h"

namespace metrics {

/// Writes the figures of one comparison to `results`; NaN where undefined. `samples` are the same values without
/// boxes: all simulated runs pooled. Called from several threads at once.
///
///   const Figures dvm = [](const Comparison& boxes, const SamplePair&, std::span<double> results) {
///     const DoubleValidation both = doubleValidationMetric(boxes);
///     results[0] = both.bias;
///     results[1] = both.scatter;
///   };
using Figures = std::function<void(const Comparison& boxes, const SamplePair& samples, std::span<double> results)>;

struct BootstrapOptions {
  std::size_t replicates = 1000;
  std::size_t block = 1;  ///< neighbouring units drawn together; > 1 where units depend on each other in time
  bool paired = false;    ///< units of one number are drawn together on all sides: set-ups that were re-simulated
  double confidence = 0.95;
  IntervalMethod method = IntervalMethod::Percentile;
  std::uint64_t seed = 1;
};

/// The raw material of intervals, figure by figure.
struct BootstrapReplicates {
  std::vector<double> estimates;
  std::vector<std::vector<double>> replicates;
  std::vector<std::vector<double>> influences;  ///< what each group of units moves the figure by (jackknife)
  std::vector<std::size_t> groups;              ///< of those: how many are measured, then of each run; one if paired
};

/// Bootstrap intervals of any figures of a comparison: what would they be, had chance drawn other values?
///
///   drawn are          units of the samples      block    paired
///   detections         none                      1        no
///   frames             the frame                 1        no
///   blocks of frames   the frame                 b > 1    no
///   set-ups            the set-up                1        yes if the same were measured and simulated
///
/// Every side is drawn anew; sizes in units stay. Same seed, same bytes, for any number of threads; without units the
/// order of the samples does not matter either. Samples are sorted once: 1000 replicates of (d_bias, d_CAVM) of
/// 2 x 10^5 values take about two seconds on two cores.
///
/// A distance has no interval that is good near its floor: a replicate carries the noise of the sample and its own, so
/// d_avm and d_cavm of resamples are too large there, and both intervals may lie above a truth of 0. `bias` shows it;
/// compare with permutation_floor.h. d_bias is free of that.
///
/// The jackknife of BCa takes units in groups, some 200 evaluations in all: grouping leaves the acceleration unchanged.
/// Groups are random, or of neighbours if block > 1 (our choice).
/// Throws InputError: too few replicates, a side with one unit, a block as long as a side, unequal units if paired.
/// Source: Efron & Tibshirani 1993, An Introduction to the Bootstrap; samples drawn apart: their ch. 8;
/// moving blocks: Künsch 1989, doi:10.1214/aos/1176347265.
[[nodiscard]] std::vector<ConfidenceInterval> bootstrapIntervals(const UnitComparison& samples,
                                                                 std::size_t figure_count, const Figures& figures,
                                                                 const BootstrapOptions& options,
                                                                 core::Progress& progress);

/// The same up to the replicates. Influences are computed for IntervalMethod::BCa only.
[[nodiscard]] BootstrapReplicates bootstrapReplicates(const UnitComparison& samples, std::size_t figure_count,
                                                      const Figures& figures, const BootstrapOptions& options,
                                                      core::Progress& progress);

/// Of one figure, with the method and the confidence of the options.
[[nodiscard]] ConfidenceInterval intervalOf(const BootstrapReplicates& all, std::size_t figure,
                                            const BootstrapOptions& options);

}  // namespace metrics
