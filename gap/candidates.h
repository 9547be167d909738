#pragma once

#include <vector>

#include "core/progress.h"
#include "gap/fit.h"
#include "gap/where.h"

namespace gap {

/// Which data are fitted and which judge.
struct Split {
  Evidence fitted;
  Evidence held_out;
  Evidence refined;   ///< as fitted, with more frames: for candidates that are nearly right
  bool weak = false;  ///< no whole sample is held out: beams of the same samples judge
};

/// Samples of role `prediction` judge, the others are fitted. Without them every third sample judges; with fewer than
/// three samples the beams are split.
[[nodiscard]] Split splitOf(const Replay& replay, std::uint64_t seed);

/// Every second beam column of all samples judges: the weaker way, where no whole sample can.
[[nodiscard]] Split splitByBeams(const Replay& replay, std::uint64_t seed);

/// A hypothesis with its fit and what the held-out data say of it.
struct Candidate {
  Hypothesis hypothesis;
  std::vector<double> values;
  /// (baseline - this) / (baseline - this if it were right), discrepancies on held-out data; above 1 by luck, or where
  /// little is to be explained.
  double explained = 0.0;
  double discrepancy = 0.0;  ///< on held-out data

  /// What counts in comparisons: every free number must earn its place.
  [[nodiscard]] double merit() const;
};

/// The members of a pair, each with its own values; a single cause as it is.
[[nodiscard]] std::vector<Candidate> membersOf(const Candidate& candidate);

/// Discrepancies that candidates are measured against.
struct Yardstick {
  double baseline = 0.0;  ///< of the model as it was brought, held-out
  double perfect = 0.0;   ///< of a model that is right but for noise
  double perfect_spread = 0.0;

  /// Share of what there is to explain; `self` is the discrepancy that a world has to itself under other noise: one
  /// that loses detections at random cannot come closer than that.
  [[nodiscard]] double explained(double discrepancy, double self) const;
  /// How far the baseline stands above noise, in standard deviations of noise.
  [[nodiscard]] double z() const;
};

[[nodiscard]] Yardstick yardstickOf(const Replay& replay, const Evidence& held_out);

/// Data on which candidates are fitted and judged.
struct Judge {
  const Replay& replay;
  Split split;
  Yardstick yardstick;

  /// Says of a candidate, with the values that it has, what the held-out data say of it.
  void hear(Candidate& candidate) const;
};

/// Fits every hypothesis and judges it on held-out data; best merit first.
[[nodiscard]] std::vector<Candidate> rank(const Judge& judge, const std::vector<Hypothesis>& hypotheses,
                                          const std::vector<WhereRow>& where, core::Progress& progress);

/// Fits the leaders again with more frames and beams, from where they are and from what the residual map suggests, and
/// judges them again; best merit first. Among those of almost the best merit the smallest discrepancy decides: a world
/// is excused for its own noise, but not preferred for it.
void polish(const Judge& judge, std::vector<Candidate>& candidates, const std::vector<WhereRow>& where,
            const core::Progress& progress);

/// Best merit first.
void sortByMerit(std::vector<Candidate>& candidates);

}  // namespace gap
