#pragma once

#include <Eigen/Dense>
#include <vector>

#include "gap/pairs/looks.h"

namespace gap {

/// Which two of many causes may be at work together, and with which numbers, by what they do to few data (looks.h).
/// What a parameter's recalibration hides: recalibrations.h.
class PairGuesses {
 public:
  /// The looks live longer than this.
  explicit PairGuesses(const Looks& looks);

  /// Pairs of causes by the distance of their summed signatures from the measurement.
  [[nodiscard]] std::vector<Guess> nearestSums() const;
  /// Two effects that are much nearer together than either is alone may be far from every other guess.
  [[nodiscard]] std::vector<Guess> nearestOfEveryTwo() const;
  /// What goes best with a cause at these values.
  [[nodiscard]] std::vector<Guess> partnersOf(std::size_t first, const std::vector<double>& values) const;
  /// The guesses with both causes' numbers where their signatures fit best, nearest first.
  [[nodiscard]] std::vector<Guess> improved(std::vector<Guess> guesses) const;

 private:
  [[nodiscard]] bool mayPair(std::size_t a, std::size_t b) const;
  [[nodiscard]] std::vector<Guess> nearestByAll(std::size_t first, const std::vector<double>& values,
                                                std::vector<Guess> guesses) const;
  [[nodiscard]] std::vector<Guess> nearestPartners(std::size_t first, const std::vector<double>& values,
                                                   const std::vector<Looks::Atom>& atoms) const;
  [[nodiscard]] Guess fitted(const Guess& guess) const;
  [[nodiscard]] std::vector<Guess> withFittedPartners(std::vector<Guess> guesses) const;

  const Looks& looks_;
  Eigen::MatrixXf counted_;  ///< shifts of the places, as far as they count
};

}  // namespace gap
