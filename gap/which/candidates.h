#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/progress.h"
#include "gap/causes/split.h"
#include "gap/where/where.h"

namespace gap {

class HeldOutGaps;

inline constexpr std::size_t kLeaders = 6;  ///< best candidates, which all beams judge
inline constexpr double kMayLead = 0.15;    ///< behind the best one in merit; who is farther behind is no rival

/// A hypothesis with its fit and what the held-out data say of it.
struct Candidate {
  Hypothesis hypothesis;
  std::vector<double> values;
  /// (baseline - this) / (baseline - this if it were right), discrepancies on held-out data; above 1 by luck, or where
  /// little is to be explained.
  double explained = 0.0;
  double discrepancy = 0.0;  ///< on held-out data
  double total_left = 1.0;   ///< of the total gap on held-out data (HeldOutGaps::leftIn); 1 until it was looked at
  double merit = 0.0;        ///< what counts in comparisons (Judge::meritOf)
};

/// The members of a pair, each with its own values; a single cause as it is.
[[nodiscard]] std::vector<Candidate> membersOf(const Candidate& candidate);

/// Discrepancies that candidates are measured against.
struct Yardstick {
  static constexpr double kClear_z = 5.0;  ///< standard deviations of noise: a gap beyond doubt

  double baseline = 0.0;  ///< of the model as it was brought, held-out
  double perfect = 0.0;   ///< of a model that is right but for noise
  double perfect_spread = 0.0;

  /// What there is to explain; no less than its noise, so that shares of next to nothing stay numbers.
  [[nodiscard]] double whole() const;

  /// Share of what there is to explain; `self` is the discrepancy that a world has to itself under other noise: one
  /// that loses detections at random cannot come closer than that.
  [[nodiscard]] double explained(double discrepancy, double self) const;
  /// Noise of that share.
  [[nodiscard]] double noiseOfShare() const;
  /// How far the baseline stands above noise, in standard deviations of noise.
  [[nodiscard]] double z() const;
  /// Of so large a distance by chance.
  [[nodiscard]] double p_value() const;
};

[[nodiscard]] Yardstick yardstickOf(const Replay& replay, const Evidence& held_out);

/// Data on which candidates are fitted and judged.
struct Judge {
  const Replay& replay;
  Split split;
  Yardstick yardstick;
  double weight_of_total = 0.0;  ///< of what is left of the total gap, in a merit

  /// Says of a candidate, with the values that it has, what the held-out data say of it; but for its `total_left`.
  void hear(Candidate& candidate) const;
  /// Explained share (half of it as it is, half excused for the world's own noise), less what is left of the total gap,
  /// less a price for every free number: it must earn its place.
  [[nodiscard]] double meritOf(const Candidate& candidate) const;
  /// What a cause with these values leaves of the discrepancy of all that is fitted.
  [[nodiscard]] double leftOfFitted(const Hypothesis& hypothesis, const std::vector<double>& values) const;
  /// Share of the gap that a candidate accounts for, cell by cell and pooled, the pooled gap as far as it stands above
  /// noise. In [0, 1], but below 0 if it makes the cells worse.
  [[nodiscard]] double accountedFor(const Candidate& candidate) const;
  /// How much less likely a number that explains nothing makes a cause, in nats (Schwarz 1978: half the logarithm of
  /// the number of data, some thousand cells).
  static constexpr double kNatsPerNumber = 4.0;
};

/// Fits every hypothesis. What is `known` is at work in all of them, and only what they bring beyond it decides which
/// are fitted to the end.
[[nodiscard]] std::vector<Candidate> fitted(const Judge& judge, const std::vector<Hypothesis>& hypotheses,
                                            const WhereResult& where, core::Progress& progress,
                                            const World* known = nullptr);
/// Fits every hypothesis and judges it on held-out data; best merit first.
[[nodiscard]] std::vector<Candidate> rank(const Judge& judge, const std::vector<Hypothesis>& hypotheses,
                                          const WhereResult& where, core::Progress& progress);

/// The values that all beams suggest, where few beams led astray (the rate of rare echoes is counted); best merit
/// first.
void takeWhatIsCounted(const Judge& exact, const WhereResult& where, std::vector<Candidate>& candidates,
                       const core::Progress& progress);

/// Fits the leaders again with more frames and beams, from where they are and from what the residual map suggests, and
/// judges them again, by what they leave of the total gap as well; the leaders come first, by merit, and so do the
/// rest.
void polish(const Judge& judge, const HeldOutGaps& gaps, std::vector<Candidate>& candidates, const WhereResult& where,
            const core::Progress& progress);

[[nodiscard]] inline bool better(const Candidate& a, const Candidate& b) { return a.merit > b.merit; }
/// Best merit first.
void sortByMerit(std::vector<Candidate>& candidates);

/// Of some candidates the one that brings the samples nearest that are fitted: where a cause acts there may be hardly
/// any that is held out. There is one at least.
[[nodiscard]] const Candidate& nearestToFitted(const Judge& judge, std::span<const Candidate> candidates);

/// Where the candidate of the same form as another one stands, with whatever values; behind the last if there is none.
[[nodiscard]] std::size_t placeOfForm(const std::vector<Candidate>& candidates, const Candidate& other);

/// Puts those that are better than the candidate of their form, which there must be, in its place; best merit first.
void takeBetter(std::vector<Candidate> improved, std::vector<Candidate>& candidates);

}  // namespace gap
