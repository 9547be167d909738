#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "core/progress.h"
#include "metrics/resampling/null_distribution.h"
#include "metrics/resampling/unit_sample.h"

namespace metrics {

struct BoxWidthOptions {
  std::size_t replicates = 1000;
  std::uint64_t seed = 1;
};

/// The mean width (PBox::area) that the envelope of these runs has from sampling noise alone: their units are thrown
/// together and dealt out anew, so that no run differs from another. [unit of the measurand]
///
///   runs K   n = 100    n = 1000      of identical N(0, s)
///      3     0.26 s     0.086 s
///     17     0.57 s     0.18 s
///
/// A box excuses what it covers: more runs, or smaller ones, make a model "more valid". Width that is not clear of this
/// floor says nothing of epistemic uncertainty. Common random numbers for all runs avoid it at the source.
/// Throws InputError for fewer than two runs, and as Exchange does.
[[nodiscard]] NullDistribution boxWidthFloor(std::span<const UnitSample> runs, const BoxWidthOptions& options,
                                             core::Progress& progress);

}  // namespace metrics
