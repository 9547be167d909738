#pragma once

#include <Eigen/Dense>
#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

#include "gap/candidates/candidates.h"
#include "gap/candidates/signatures.h"
#include "gap/where/where.h"

namespace gap {

/// A pair of causes to begin a joint fit with, and how far it is from the data on the few beams that are scouted.
struct Guess {
  std::size_t first = 0, second = 0;  ///< singles
  std::vector<double> values;         ///< of both
  double distance = 0.0;
};

/// Moves all of `more` behind the others.
template <typename T>
void append(std::vector<T>& to, std::vector<T> more) {
  std::move(more.begin(), more.end(), std::back_inserter(to));
}

/// So many guesses with the smallest distance, nearest first.
[[nodiscard]] std::vector<Guess> nearestOf(std::vector<Guess> guesses, std::size_t count);

/// Of shifts, as much as counts in a distance; what it is given outlives what it returns.
template <typename Shifts>
[[nodiscard]] auto counted(const Eigen::MatrixBase<Shifts>& shifts) {
  constexpr auto kFar = static_cast<float>(SignatureSpace::kFar);
  return shifts.derived().cwiseMax(-kFar).cwiseMin(kFar);
}

[[nodiscard]] Eigen::VectorXf columnOf(const Signature& signature);

/// What every single cause does to a few beams and frames, at many places of its numbers: many worlds are looked at
/// before few are fitted.
class Looks {
 public:
  /// A cause at certain values.
  struct Atom {
    std::size_t single = 0;
    std::vector<double> values;
  };

  /// `singles`: best first, each at the values that fit best alone. All three live longer than this.
  Looks(const Judge& judge, const std::vector<Candidate>& singles, const core::Progress& progress);
  Looks(const Looks&) = delete;
  Looks& operator=(const Looks&) = delete;

  [[nodiscard]] const Judge& judge() const { return judge_; }
  [[nodiscard]] const std::vector<Candidate>& singles() const { return singles_; }
  [[nodiscard]] const core::Progress& progress() const { return progress_; }
  [[nodiscard]] const Replay& scout() const { return scout_; }
  [[nodiscard]] const Evidence& scouted() const { return scouted_; }
  [[nodiscard]] const SignatureSpace& space() const { return space_; }
  /// Every cause at its fitted values, at others all over its range, and where the residuals suggest.
  [[nodiscard]] const std::vector<Atom>& atoms() const { return atoms_; }
  /// How each of them shifts the data, a column each.
  [[nodiscard]] const Eigen::MatrixXf& shifts() const { return shifts_; }

  /// Places that residuals suggest for a cause.
  [[nodiscard]] std::vector<Atom> suggestedFor(std::size_t single, const WhereResult& where) const;
  [[nodiscard]] std::size_t numbersOf(std::size_t single) const;
  [[nodiscard]] Hypothesis hypothesisOf(const Guess& guess) const;
  /// Of a world from the few data, as a guess's.
  [[nodiscard]] double distanceOf(const Hypothesis& hypothesis, const std::vector<double>& values) const;
  /// Guesses that came from signatures, with their distances from the data.
  [[nodiscard]] std::vector<Guess> lookedAt(std::vector<Guess> guesses) const;

 private:
  void lookAtAtoms();

  const Judge& judge_;
  const std::vector<Candidate>& singles_;
  const core::Progress& progress_;
  const Replay scout_;  ///< fewer beams still
  const Evidence scouted_;
  const SignatureSpace space_;
  std::vector<Atom> atoms_;
  Eigen::MatrixXf shifts_;
};

}  // namespace gap
