#include "metrics/samples/classifier_two_sample.h"

#include <algorithm>
#include <boost/math/distributions/hypergeometric.hpp>
#include <cmath>
#include <fmt/format.h>
#include <numeric>
#include <string_view>
#include <utility>
#include <vector>

#include "core/error.h"
#include "core/parallel.h"
#include "core/random.h"
#include "metrics/distributions/summation.h"
#include "metrics/samples/label_tree.h"

namespace metrics {

namespace {

/// All points, simulated ones first.
struct Data {
  std::vector<double> coordinates;  // in pooled standard deviations
  std::size_t dimension;
  std::size_t simulated;
  std::size_t measured;

  [[nodiscard]] std::size_t size() const { return simulated + measured; }
  [[nodiscard]] std::span<const double> at(std::size_t row) const {
    return std::span(coordinates).subspan(row * dimension, dimension);
  }
};

/// Labels told right and wrong.
struct Confusion {
  std::size_t simulated = 0;        // tested
  std::size_t measured = 0;         // tested
  std::size_t simulated_right = 0;  // simulated, told so
  std::size_t measured_right = 0;
  std::size_t neighbours = 0;

  [[nodiscard]] double accuracy() const {
    return (static_cast<double>(simulated_right) / static_cast<double>(simulated) +
            static_cast<double>(measured_right) / static_cast<double>(measured)) /
           2.0;
  }
};

std::size_t rowsOf(std::span<const double> numbers, std::size_t dimension, std::size_t least, std::string_view side) {
  const auto bad = std::find_if(numbers.begin(), numbers.end(), [](double x) { return !std::isfinite(x); });
  if (bad != numbers.end()) {
    const auto i = static_cast<std::size_t>(bad - numbers.begin());
    throw core::InputError({.item = fmt::format("{} row {}, column {}", side, i / dimension + 1, i % dimension + 1)},
                           fmt::format("is {}; points need finite numbers.", *bad),
                           "Remove or correct it; nothing is dropped silently.");
  }
  if (numbers.size() % dimension != 0 || numbers.size() / dimension < least) {
    throw core::InputError({.item = fmt::format("{} points", side)},
                           fmt::format("are {} numbers, {} to a point; {} whole points or more are needed.",
                                       numbers.size(), dimension, least),
                           "Check the file, the columns and the gate.");
  }
  return numbers.size() / dimension;
}

/// Each feature in its pooled standard deviation; one that never changes tells nothing and becomes 0.
void standardise(Data& data) {
  for (std::size_t d = 0; d < data.dimension; ++d) {
    const double first = data.coordinates[d];  // relative to it, so that a small spread far from zero keeps its digits
    Summation sum;
    Summation squares;
    for (std::size_t row = 0; row < data.size(); ++row) sum.add(data.at(row)[d] - first);
    const double mean = sum.value() / static_cast<double>(data.size());
    for (std::size_t row = 0; row < data.size(); ++row) squares.add(std::pow(data.at(row)[d] - first - mean, 2));
    const double deviation = std::sqrt(squares.value() / static_cast<double>(data.size()));
    for (std::size_t row = 0; row < data.size(); ++row) {
      double& x = data.coordinates[row * data.dimension + d];
      x = deviation > 0.0 ? (x - first - mean) / deviation : 0.0;
    }
  }
}

Data dataOf(const LabelledPoints& points, std::size_t least) {
  if (points.dimension == 0) {
    throw core::InputError({.item = "dimension"}, "is 0; a point has at least one number.", "Name a column.");
  }
  Data data{.coordinates = {points.simulated.begin(), points.simulated.end()},
            .dimension = points.dimension,
            .simulated = rowsOf(points.simulated, points.dimension, least, "simulated"),
            .measured = rowsOf(points.measured, points.dimension, least, "measured")};
  data.coordinates.insert(data.coordinates.end(), points.measured.begin(), points.measured.end());
  standardise(data);
  return data;
}

template <typename Value>
void shuffle(std::vector<Value>& values, core::Random& random) {
  for (std::size_t i = values.size(); i > 1; --i) {
    std::swap(values[i - 1], values[random.below(static_cast<std::uint32_t>(i))]);
  }
}

/// Which fold a point belongs to; each has the same share of both labels, to one point.
std::vector<std::size_t> foldsOf(const std::vector<char>& is_simulated, std::size_t folds, core::Random& random) {
  std::vector<std::size_t> fold_of(is_simulated.size());
  for (const bool label : {true, false}) {
    std::vector<std::size_t> rows;
    for (std::size_t row = 0; row < is_simulated.size(); ++row) {
      if (static_cast<bool>(is_simulated[row]) == label) rows.push_back(row);
    }
    shuffle(rows, random);
    for (std::size_t i = 0; i < rows.size(); ++i) fold_of[rows[i]] = i % folds;
  }
  return fold_of;
}

/// Trains on all folds but one and is asked about that one.
void testFold(const Data& data, const std::vector<char>& is_simulated, const std::vector<std::size_t>& fold_of,
              std::size_t tested_fold, std::size_t neighbours, Confusion& confusion) {
  std::vector<std::uint32_t> training;
  std::vector<std::uint32_t> tested;
  for (std::size_t row = 0; row < data.size(); ++row) {
    (fold_of[row] == tested_fold ? tested : training).push_back(static_cast<std::uint32_t>(row));
  }
  const auto of_simulated = static_cast<std::size_t>(
      std::count_if(training.begin(), training.end(), [&](std::uint32_t row) { return is_simulated[row] != 0; }));
  const std::size_t of_measured = training.size() - of_simulated;
  const auto root = static_cast<std::size_t>(std::sqrt(static_cast<double>(training.size())));
  confusion.neighbours = std::min(neighbours == 0 ? root : neighbours, training.size());

  const LabelTree tree(data.coordinates, data.dimension, training, is_simulated);
  std::vector<char> told_simulated(tested.size());
  core::parallelFor(tested.size(), 256, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Votes votes = tree.ballOf(data.at(tested[i]), confusion.neighbours);
      told_simulated[i] = votes.simulated * of_measured > votes.measured * of_simulated ? 1 : 0;
    }
  });
  for (std::size_t i = 0; i < tested.size(); ++i) {
    const bool right = told_simulated[i] == is_simulated[tested[i]];
    if (is_simulated[tested[i]]) {
      ++confusion.simulated;
      confusion.simulated_right += right ? 1 : 0;
    } else {
      ++confusion.measured;
      confusion.measured_right += right ? 1 : 0;
    }
  }
}

/// Chance of at least as many simulated points told right, given how many were told simulated at all.
double fisherPValue(const Confusion& confusion) {
  if (confusion.simulated_right == 0) return 1.0;
  const std::size_t told_simulated = confusion.simulated_right + confusion.measured - confusion.measured_right;
  const boost::math::hypergeometric_distribution<> right(
      static_cast<unsigned>(confusion.simulated), static_cast<unsigned>(told_simulated),
      static_cast<unsigned>(confusion.simulated + confusion.measured));
  const auto least = boost::math::range(right).first;
  const auto fewer = static_cast<unsigned>(confusion.simulated_right - 1);
  return fewer < least ? 1.0 : boost::math::cdf(boost::math::complement(right, fewer));
}

Confusion crossValidate(const Data& data, const std::vector<char>& is_simulated, const ClassifierOptions& options,
                        core::Random& random) {
  const std::vector<std::size_t> fold_of = foldsOf(is_simulated, options.folds, random);
  Confusion confusion;
  for (std::size_t fold = 0; fold < options.folds; ++fold) {
    testFold(data, is_simulated, fold_of, fold, options.neighbours, confusion);
  }
  return confusion;
}

void mustBeFeasible(const Data& data, const ClassifierOptions& options) {
  const double total = static_cast<double>(data.size()) * (static_cast<double>(options.permutations) + 1.0);
  if (total <= kLargestClassification) return;
  throw core::InputError({},
                         fmt::format("{} points and {} permutations are {:.3g} points to classify.", data.size(),
                                     options.permutations, total),
                         fmt::format("The limit is {:.3g}: ask for fewer permutations, or thin the points and say so.",
                                     kLargestClassification));
}

core::Random randomOf(const ClassifierOptions& options, std::uint32_t shuffle) {
  return core::Random({.seed = options.seed, .sample = shuffle, .purpose = core::purposeOf("classifier_two_sample")});
}

}  // namespace

ClassifierTwoSample classifierTwoSampleTest(const LabelledPoints& points, const ClassifierOptions& options) {
  const bool halves = options.permutations == 0;
  if (!halves && options.folds < 2) {
    throw core::InputError({.item = "folds"},
                           fmt::format("is {}; what is tested must not be trained on.", options.folds),
                           "Usual are 5 or 10.");
  }
  const Data data = dataOf(points, halves ? 2 : options.folds);
  mustBeFeasible(data, options);
  std::vector<char> is_simulated(data.size(), 0);
  std::fill_n(is_simulated.begin(), data.simulated, 1);

  core::Random random = randomOf(options, 0);
  Confusion confusion;
  double p_value = 0.0;
  if (halves) {
    testFold(data, is_simulated, foldsOf(is_simulated, 2, random), 1, options.neighbours, confusion);
    p_value = fisherPValue(confusion);
  } else {
    confusion = crossValidate(data, is_simulated, options, random);
    std::size_t as_accurate = 0;
    for (std::size_t k = 1; k <= options.permutations; ++k) {
      core::Random shuffler = randomOf(options, static_cast<std::uint32_t>(k));
      shuffle(is_simulated, shuffler);
      const double accuracy = crossValidate(data, is_simulated, options, shuffler).accuracy();
      as_accurate += accuracy >= confusion.accuracy() - 1e-12 ? 1 : 0;
    }
    p_value = (1.0 + static_cast<double>(as_accurate)) / (1.0 + static_cast<double>(options.permutations));
  }
  return {.accuracy = confusion.accuracy(),
          .p_value = p_value,
          .simulated = confusion.simulated,
          .measured = confusion.measured,
          .neighbours = confusion.neighbours};
}

}  // namespace metrics
