#pragma once

#include <cstdint>
#include <vector>

#include "gap/candidates/candidates.h"
#include "gap/replay/statistics.h"

namespace gap {

/// Standard deviations: no more is left than a cause leaves under its own noise.
inline constexpr double kNoRest = 3.0;

/// Whether a candidate brings the simulation nearer to held-out data than chance would, and whether anything is left.
/// Both worlds are simulated with the same random numbers, so what the candidate does not change cancels: small effects
/// show that the sum over all cells would hide in its noise.
struct Significance {
  double gain = 0.0;           ///< of discrepancy, in nats; what fits worse may still stand out from chance
  double by_chance = 0.0;      ///< mean gain on measurements drawn from the null
  double improvement_z = 0.0;  ///< of the gain, against measurements drawn from the null
  double p_value = 1.0;        ///< of such a gain by chance, of one candidate
  double rest_z = 0.0;         ///< of what is left, against measurements drawn from the candidate's own world
  /// As improvement_z, without the sample that gains most: a cause is in the sensor or in the reference of all, and
  /// what one sample alone shows may have happened there only. Where it does nothing in any other, as improvement_z.
  double without_best_z = 0.0;
};

/// Whether a gain is one that noise makes for none of so many causes, and nothing is left that the cause itself would
/// not leave.
[[nodiscard]] bool nothingElse(const Significance& significance, std::size_t causes);
/// Whether besides the data come nearer as they are, and do so without the sample that gains most.
[[nodiscard]] bool provesItself(const Significance& significance, std::size_t causes);

/// Of the run-th measurement that is drawn to say what chance or a cause itself does.
[[nodiscard]] std::uint64_t seedOfRun(const Evidence& evidence, std::size_t run);

/// Measurements drawn from a world in which a cause is not at work (the baseline, or a first cause's): what the cause
/// gains on them, it gains by chance. They are the same for every cause, so they are drawn once, and the null is
/// compared with each of them once.
class NullRuns {
 public:
  /// `parts`: evidence whose gains are wanted each by itself; not empty, all of one seed.
  NullRuns(const Replay& replay, World null, std::vector<Evidence> parts, std::size_t runs);

  /// In nats, of each part.
  struct Gains {
    std::vector<double> observed;
    std::vector<std::vector<double>> by_chance;  ///< of each run
  };
  [[nodiscard]] Gains gainsOf(const World& world) const;
  [[nodiscard]] std::size_t runs() const noexcept { return without_.size(); }

 private:
  const Replay* replay_;
  World null_;
  std::vector<Evidence> parts_;
  std::vector<std::vector<Measured>> drawn_;  ///< in every run, of each part
  std::vector<std::vector<double>> without_;  ///< discrepancy of the null in every run, of each part
  std::vector<double> observed_;              ///< discrepancy of the null from what was measured, of each part
};

/// Evidence of single samples.
[[nodiscard]] std::vector<Evidence> bySample(const Evidence& evidence);
/// Gains of more parts in the same runs.
[[nodiscard]] NullRuns::Gains joined(NullRuns::Gains gains, const NullRuns::Gains& more);

/// As many runs as a verdict takes, on the held-out samples: of the baseline, or of another world.
[[nodiscard]] NullRuns nullRunsOf(const Judge& judge);
[[nodiscard]] NullRuns nullRunsOf(const Judge& judge, const World& null);
/// How far from itself a world is under other noise, on held-out data.
[[nodiscard]] Distribution ownNoiseOf(const Judge& judge, const World& world, std::size_t runs);
/// What is left by a world on held-out data, in standard deviations of as many measurements drawn from itself.
[[nodiscard]] double deviationsLeft(const Judge& judge, const World& world, std::size_t runs);
[[nodiscard]] double deviationsLeft(const Judge& judge, const Candidate& candidate);
[[nodiscard]] Significance significanceOf(const NullRuns::Gains& gains, double rest_z);
[[nodiscard]] Significance significanceOf(const Judge& judge, const Candidate& candidate, const NullRuns& nulls);

/// The improvement_z of many candidates, from fewer measurements drawn: enough to see which to look at closely.
[[nodiscard]] std::vector<double> roughImprovements(const Judge& judge, const std::vector<Candidate>& candidates);

}  // namespace gap
