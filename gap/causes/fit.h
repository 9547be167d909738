#pragma once

#include <cstddef>
#include <vector>

#include "core/progress.h"
#include "gap/causes/evidence.h"

namespace gap {

inline constexpr std::size_t kScoutedSamples = 4;  ///< enough to find the neighbourhood

/// Where a coarse search ended.
struct Scouted {
  std::vector<double> values;
  double gain = 0.0;  ///< share of the discrepancy that is gone, on the samples and frames looked at
};

/// A coarse search over the plausible range (and the starts given) on few frames of the evidence, of which few samples
/// are enough. Parameters per set-up are searched one by one. Deterministic. The random numbers are the same for all
/// values and hypotheses. Gains are those beyond what is `known`; beyond the baseline if that is null.
[[nodiscard]] Scouted scout(const Replay& replay, const Hypothesis& hypothesis, const Evidence& evidence,
                            const std::vector<std::vector<double>>& starts, const core::Progress& progress,
                            const World* known = nullptr);

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

/// Searches the neighbourhood of values that are nearly right, on all frames that the evidence allows; of parameters
/// per set-up one by one.
[[nodiscard]] std::vector<double> refine(const Replay& replay, const Hypothesis& hypothesis, const Evidence& evidence,
                                         const std::vector<double>& values, const core::Progress& progress);

/// `refine` in two parts: the neighbourhood, and from there the valley that several numbers make. What is far behind
/// after the first needs no second, which takes as long and brings little more.
[[nodiscard]] std::vector<double> refineBriefly(const Replay& replay, const Hypothesis& hypothesis,
                                                const Evidence& evidence, const std::vector<double>& values,
                                                const core::Progress& progress);
[[nodiscard]] std::vector<double> refineAlongValley(const Replay& replay, const Hypothesis& hypothesis,
                                                    const Evidence& evidence, const std::vector<double>& values,
                                                    const core::Progress& progress);

}  // namespace gap
