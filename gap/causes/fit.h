#pragma once

#include <span>
#include <vector>

#include "core/progress.h"
#include "gap/causes/hypotheses.h"
#include "gap/distance/discrepancy.h"

namespace gap {

/// Which samples (and which part of their cells) a fit sees, and how many frames it simulates of each.
struct Evidence {
  std::vector<std::size_t> samples;
  Part part;
  int most_frames = 6;
  std::size_t most_shots = 16000;  ///< beams times frames of a sample; but three frames at least
  std::uint64_t seed = 1;
};

/// The same evidence on at most so many samples, spread over the list, and so many frames.
[[nodiscard]] Evidence spreadOver(const Evidence& evidence, std::size_t most_samples, int most_frames);

/// Discrepancy of a world on some evidence.
[[nodiscard]] double discrepancyOf(const Replay& replay, const World& world, const Evidence& evidence);

/// The same to other measurements of these samples, one each.
[[nodiscard]] double discrepancyTo(const Replay& replay, const World& world, const Evidence& evidence,
                                   std::span<const std::vector<CellStatistics>> measured);

/// Discrepancy of a world if another one were the truth: to a measurement simulated in `truth` under the noise of
/// another seed, the reference somewhere within its tolerance.
[[nodiscard]] double discrepancyIn(const Replay& replay, const World& truth, const World& world,
                                   const Evidence& evidence, std::uint64_t seed);

/// The world in which a hypothesis holds with these values.
[[nodiscard]] World worldOf(const Replay& replay, const Hypothesis& hypothesis, const std::vector<double>& values);

/// Where a coarse search ended.
struct Scouted {
  std::vector<double> values;
  double gain = 0.0;  ///< share of the baseline's discrepancy that is gone, on the few samples and frames looked at
};

/// A coarse search over the plausible range (and the starts given) on a few samples. Parameters per set-up are searched
/// one by one. Deterministic. The random numbers are the same for all values and hypotheses.
[[nodiscard]] Scouted scout(const Replay& replay, const Hypothesis& hypothesis, const Evidence& evidence,
                            const std::vector<std::vector<double>>& starts, const core::Progress& progress);

/// The values with the smallest discrepancy near these: a bounded derivative-free search (NLopt: Subplex; one
/// parameter: Brent). Fits few frames; `refine` makes the result exact.
[[nodiscard]] std::vector<double> fitFrom(const Replay& replay, const Hypothesis& hypothesis, const Evidence& evidence,
                                          const std::vector<double>& start, const core::Progress& progress);

/// The same on a few samples and with few trials: enough to see whether `fitFrom` is worth it.
[[nodiscard]] std::vector<double> roughFitFrom(const Replay& replay, const Hypothesis& hypothesis,
                                               const Evidence& evidence, const std::vector<double>& start,
                                               const core::Progress& progress);

/// Half of the least distance of two values that the search tells apart here.
[[nodiscard]] double resolvedAt(const FreeParameter& parameter, double value);

/// Some values spread evenly over the plausible range of a hypothesis; none if it has no free number.
[[nodiscard]] std::vector<std::vector<double>> valuesAllOver(const Hypothesis& hypothesis);

/// Searches the neighbourhood of values that are nearly right, on all frames that the evidence allows.
[[nodiscard]] std::vector<double> refine(const Replay& replay, const Hypothesis& hypothesis, const Evidence& evidence,
                                         const std::vector<double>& values, const core::Progress& progress);

}  // namespace gap
