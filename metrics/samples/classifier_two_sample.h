#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace metrics {

/// Points of two samples, row by row: dimension numbers each (range; or range, azimuth, intensity; ...), any units.
struct LabelledPoints {
  std::span<const double> simulated;
  std::span<const double> measured;
  std::size_t dimension = 1;
};

struct ClassifierOptions {
  std::size_t neighbours = 0;    ///< that vote; 0: the root of the number of training points
  std::size_t permutations = 0;  ///< 0: one half trains, the other tests; else cross-validation and this many shuffles
  std::size_t folds = 5;         ///< of the cross-validation; >= 2
  std::uint64_t seed = 1;        ///< equal seeds give equal results
};

/// More points to classify than this are refused, not subsampled. 2 x 1e5 values take a second or two, 3-D
/// points some times that.
inline constexpr double kLargestClassification = 1e7;

struct ClassifierTwoSample {
  double accuracy;         ///< mean of both samples' shares told right: 0.5 indistinguishable, 1 always told apart
  double p_value;          ///< chance of at least this accuracy if both samples come from one distribution
  std::size_t simulated;   ///< tested points
  std::size_t measured;    ///< tested points
  std::size_t neighbours;  ///< that voted
};

/// Classifier two-sample test: can a program tell simulated from real points? A k-nearest-neighbour vote (balanced for
/// samples of different size) is trained on some points and asked about others. Features are first divided by their
/// pooled standard deviation, so units do not matter.
///
///   train  o x o o x x        test  ?  ->  nearest 3: o o x  ->  "o"
///   accuracy = (share of o told right + share of x told right) / 2
///
/// Half split (default): the trained classifier cannot know the labels of the other half, so under equality any
/// arrangement of these is equally likely, and the number of simulated points told right is hypergeometric: the p-value
/// is exact (Fisher's). Cross-validation tests every point and sees more, but its folds share training points and are
/// not independent: its p-value is that of shuffled labels, (1 + as accurate)/(1 + permutations).
///
/// Stands in for the Deep Evaluation Metric (number 34 in Rosenberger 2022, Tab. 4-3; Ngo, Bauer & Resch 2021,
/// arXiv:2104.06772), openly: that is the confidence of a neural network trained to tell real from simulated radar
/// clouds. Neither its weights nor the clouds to train them are at hand, and a network trained anew would measure its
/// training as much as the simulation. This test asks the same question of single points, without weights, and says how
/// sure the answer is; it sees no shape of a whole cloud.
///
/// Time O(N sqrt N), dimension small (neighbours lose their meaning beyond some ten). Throws InputError if rows are not
/// whole or not finite, a sample has fewer than two points (or fewer than folds), or N (permutations + 1) exceeds
/// kLargestClassification. Source: Lopez-Paz & Oquab 2017, arXiv:1610.06545; k = sqrt(n) as there.
[[nodiscard]] ClassifierTwoSample classifierTwoSampleTest(const LabelledPoints& points,
                                                          const ClassifierOptions& options = {});

}  // namespace metrics
