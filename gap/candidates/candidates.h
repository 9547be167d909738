#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "gap/candidates/yardstick.h"
#include "gap/causes/split.h"

namespace gap {

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

/// Data on which candidates are fitted and judged.
struct Judge {
  const Replay& replay;
  Split split;
  Yardstick yardstick;
  double weight_of_total = 0.0;  ///< of what is left of the total gap, in a merit

  /// On which beams and samples a hypothesis is fitted. Offsets of set-ups cannot be carried over to other set-ups:
  /// half of every set-up's beams fit, also of those that are held out; all of these judge, and the price of every
  /// number makes up for what it gains on beams that it was fitted to.
  [[nodiscard]] Split splitFor(const Hypothesis& hypothesis) const;
  /// Says of a candidate, with the values that it has, what the held-out data say of it; but for its `total_left`.
  void hear(Candidate& candidate) const;
  /// Explained share (half of it as it is, half excused for the world's own noise), less what is left of the total gap,
  /// less a price for every free number: it must earn its place.
  [[nodiscard]] double meritOf(const Candidate& candidate) const;
  /// What a cause with these values leaves of the discrepancy of some evidence, in one simulation.
  [[nodiscard]] double leftOn(const Evidence& evidence, const Hypothesis& hypothesis,
                              const std::vector<double>& values) const;
  /// The same of all that is fitted.
  [[nodiscard]] double leftOfFitted(const Hypothesis& hypothesis, const std::vector<double>& values) const;
  /// Share of the gap that a candidate accounts for, cell by cell and pooled, the pooled gap as far as it stands above
  /// noise. In [0, 1], but below 0 if it makes the cells worse.
  [[nodiscard]] double accountedFor(const Candidate& candidate) const;
  /// How much less likely a number that explains nothing makes a cause, in nats (Schwarz 1978: half the logarithm of
  /// the number of data, some thousand cells).
  static constexpr double kNatsPerNumber = 4.0;
};

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
