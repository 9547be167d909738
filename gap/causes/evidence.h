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

/// What the sensors measured, or would measure, of some samples: one list of cells each.
using Measured = std::vector<std::vector<CellStatistics>>;

/// Of an evidence's samples if a world were the truth: under the noise of a seed, the reference somewhere within its
/// tolerance.
[[nodiscard]] Measured measuredIn(const Replay& replay, const World& truth, const Evidence& evidence,
                                  std::uint64_t seed);

/// A world simulated on some evidence, and how far it is from any measurement of these samples: on the mean of several
/// simulations, where of causes that make a few echoes one simulation would tell its own noise. Replay and world
/// outlive it.
class SimulatedWorld {
 public:
  SimulatedWorld(const Replay& replay, const World& world, const Evidence& evidence, std::size_t simulations = 1);
  /// From what was measured.
  [[nodiscard]] double discrepancy() const;
  /// From another measurement of the evidence's samples.
  [[nodiscard]] double discrepancyTo(const Measured& measured) const;
  /// The same in one of the simulations.
  [[nodiscard]] double discrepancyTo(const Measured& measured, std::size_t simulation) const;
  [[nodiscard]] std::size_t simulations() const noexcept { return simulations_.size(); }

 private:
  const Replay& replay_;
  const World& world_;
  Part part_;
  std::vector<std::vector<Comparison>> simulations_;
};

/// An evidence's samples as they were measured, beside a world under the evidence's seed.
[[nodiscard]] std::vector<Comparison> comparisonsOf(const Replay& replay, const World& world, const Evidence& evidence);

/// The same beside what another world gave in place of what was measured: `other`, its comparisonsOf on the same
/// evidence, to which they refer. Under the same random numbers one world is at no distance from itself.
[[nodiscard]] std::vector<Comparison> comparisonsTo(const std::vector<Comparison>& other, const Replay& replay,
                                                    const World& world, const Evidence& evidence);

/// Discrepancy of a world on some evidence.
[[nodiscard]] double discrepancyOf(const Replay& replay, const World& world, const Evidence& evidence);

/// The world in which a hypothesis holds with these values.
[[nodiscard]] World worldOf(const Replay& replay, const Hypothesis& hypothesis, const std::vector<double>& values);

}  // namespace gap
