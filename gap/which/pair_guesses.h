#pragma once

#include <Eigen/Dense>
#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

#include "gap/which/candidates.h"
#include "gap/which/signatures.h"

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

/// Which two of many causes may be at work together, and with which numbers: many worlds are looked at, on few beams
/// and frames, before few are fitted.
class PairGuesses {
 public:
  /// `singles`: best first, each at the values that fit best alone. All three live longer than this.
  PairGuesses(const Judge& judge, const std::vector<Candidate>& singles, const core::Progress& progress);

  /// Pairs of causes by the distance of their summed signatures from the measurement.
  [[nodiscard]] std::vector<Guess> nearestSums() const;
  /// Two effects that are much nearer together than either is alone may be far from every other guess.
  [[nodiscard]] std::vector<Guess> nearestOfEveryTwo() const;
  /// What goes best with a cause at these values.
  [[nodiscard]] std::vector<Guess> partnersOf(std::size_t first, const std::vector<double>& values) const;
  /// What goes best with another value of a parameter: whoever calibrated the model to its means has hidden the cause
  /// in it, and no single hypothesis may look better than none. What is left of the cause shows only where the
  /// parameter is right within a per cent or two, so signatures are summed at many values of it.
  [[nodiscard]] std::vector<Guess> besideRecalibration() const;
  /// The guesses with both causes' numbers where their signatures fit best, nearest first.
  [[nodiscard]] std::vector<Guess> improved(std::vector<Guess> guesses) const;

  [[nodiscard]] Hypothesis hypothesisOf(const Guess& guess) const;
  /// As a guess's.
  [[nodiscard]] double distanceOf(const Hypothesis& hypothesis, const std::vector<double>& values) const;
  [[nodiscard]] std::size_t numbersOf(std::size_t single) const;

 private:
  /// A cause at certain values.
  struct Atom {
    std::size_t single = 0;
    std::vector<double> values;
  };

  /// Another value of a parameter, and what it does.
  struct Step {
    double value = 0.0;
    Eigen::VectorXf shifts;
  };

  [[nodiscard]] bool mayPair(std::size_t a, std::size_t b) const;
  void lookAtAtoms();
  [[nodiscard]] std::vector<Atom> suggestedFor(std::size_t single, const WhereResult& where) const;
  [[nodiscard]] std::vector<Guess> nearestByAll(std::size_t first, const std::vector<double>& values,
                                                std::vector<Guess> guesses) const;
  [[nodiscard]] std::vector<Guess> nearestPartners(std::size_t first, const std::vector<double>& values,
                                                   const std::vector<Atom>& atoms) const;
  [[nodiscard]] Guess fitted(const Guess& guess) const;
  [[nodiscard]] std::vector<Guess> withFittedPartners(std::vector<Guess> guesses) const;
  [[nodiscard]] std::vector<Guess> hiddenBy(std::size_t parameter, const std::vector<Step>& steps,
                                            double (*farness)(const Eigen::VectorXf&)) const;
  [[nodiscard]] std::vector<Step> stepsOf(std::size_t parameter) const;
  [[nodiscard]] std::vector<Guess> lookedAt(std::vector<Guess> guesses) const;

  const Judge& judge_;
  const std::vector<Candidate>& singles_;
  const core::Progress& progress_;
  const Replay scout_;  ///< fewer beams still
  const Evidence scouted_;
  const SignatureSpace space_;
  std::vector<Atom> atoms_;
  Eigen::MatrixXf whole_, signatures_;  ///< of the atoms, a column each: as they are, and as far as they count
};

}  // namespace gap
