#pragma once

#include <cstdint>
#include <span>
#include <vector>

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

}  // namespace gap
