#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "core/progress.h"
#include "metrics/area/double_validation_metric.h"
#include "metrics/resampling/null_distribution.h"
#include "metrics/resampling/unit_sample.h"

namespace metrics {

/// What d_avm and d_cavm are although nothing is wrong. Two samples of one distribution are never equal, and a
/// distance cannot be negative, so its values begin well above 0:
///
///   n = m          30          100          1000        identical N(0, s), mean over samples
///   d_avm         0.31 s      0.18 s       0.057 s
///   d_cavm        0.23 s      0.13 s       0.043 s
///
/// Both fall as sqrt(1/n + 1/m). A p-box of several runs has a lower floor, as its own noise excuses
/// (box_width_floor.h).
struct Floor {
  NullDistribution area;     ///< of d_avm
  NullDistribution scatter;  ///< of d_cavm
};

struct FloorOptions {
  std::size_t replicates = 1000;
  Shift shift = Shift::One;  ///< how d_cavm removes the bias
  std::uint64_t seed = 1;
};

/// From measurement and simulation as they are: their units are thrown together and dealt out anew. Under it p-values
/// are exact for d_avm, and approximate for d_cavm: there the simulation is moved by -d_bias before, as a shift would
/// else pass for scatter. A simulation that scatters too much raises this floor; judge thresholds by samplingFloor.
/// Throws InputError as Exchange does, and without a run.
/// Source: Good 2005, Permutation, Parametric and Bootstrap Tests of Hypotheses.
[[nodiscard]] Floor permutationFloor(const UnitComparison& samples, const FloorOptions& options,
                                     core::Progress& progress);

/// From the measurement alone: what a perfect model would reach. Both sides are drawn from it with replacement, the
/// measurement with as many units as it has, run k with run_units[k]. Needs no simulation, so it serves when a
/// threshold is specified. Throws InputError if the measurement is empty, or without a run or with one of size 0.
[[nodiscard]] Floor samplingFloor(const UnitSample& measured, std::span<const std::size_t> run_units,
                                  const FloorOptions& options, core::Progress& progress);

/// Would a perfect model meet the threshold with at least this chance? If not, take more data or a higher threshold:
/// a better model does not help.
[[nodiscard]] bool attainable(double threshold, const NullDistribution& floor, double chance = 0.5);

}  // namespace metrics
