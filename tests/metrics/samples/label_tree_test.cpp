#include "metrics/samples/label_tree.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <numeric>

#include "core/random.h"

namespace {

using metrics::LabelTree;
using metrics::Votes;

/// Every point is looked at.
Votes slowBall(const std::vector<double>& coordinates, std::size_t dimension, const std::vector<std::uint32_t>& rows,
               const std::vector<char>& labels, const std::vector<double>& place, std::size_t k) {
  std::vector<double> distances;
  const auto distance = [&](std::uint32_t row) {
    double sum = 0.0;
    for (std::size_t d = 0; d < dimension; ++d) {
      const double away = coordinates[row * dimension + d] - place[d];
      sum += away * away;
    }
    return sum;
  };
  for (const std::uint32_t row : rows) distances.push_back(distance(row));
  std::sort(distances.begin(), distances.end());
  Votes votes{.simulated = 0, .measured = 0};
  for (const std::uint32_t row : rows) {
    if (distance(row) <= distances[std::min(k, distances.size()) - 1])
      ++(labels[row] ? votes.simulated : votes.measured);
  }
  return votes;
}

TEST(LabelTree, BallHoldsWhatALookAtEveryPointFinds) {
  core::Random random({.seed = 60});
  for (int k = 0; k < 300; ++k) {
    const std::size_t dimension = 1 + random.below(4);
    const std::size_t n = 1 + random.below(200);
    const bool counters = random.below(2) == 0;  // many ties, also at the edge of the ball
    const auto number = [&] { return counters ? static_cast<double>(random.below(5)) : random.normal(); };
    std::vector<double> coordinates(n * dimension);
    for (double& x : coordinates) x = number();
    std::vector<char> labels(n);
    std::vector<std::uint32_t> rows;
    for (std::uint32_t row = 0; row < n; ++row) {
      labels[row] = static_cast<char>(random.below(2));
      if (row == 0 || random.below(4) > 0) rows.push_back(row);
    }
    const LabelTree tree(coordinates, dimension, rows, labels);
    for (int q = 0; q < 20; ++q) {
      std::vector<double> place(dimension);
      for (double& x : place) x = number();
      const std::size_t neighbours = 1 + random.below(30);
      const Votes fast = tree.ballOf(place, neighbours);
      const Votes slow = slowBall(coordinates, dimension, rows, labels, place, neighbours);
      ASSERT_EQ(fast.simulated, slow.simulated);
      ASSERT_EQ(fast.measured, slow.measured);
    }
  }
}

TEST(LabelTree, EqualPointsVoteTogether) {
  const std::vector<double> coordinates(1000, 3.0);
  std::vector<char> labels(1000, 0);
  std::fill_n(labels.begin(), 400, 1);
  std::vector<std::uint32_t> rows(1000);
  std::iota(rows.begin(), rows.end(), 0u);
  const Votes votes = LabelTree(coordinates, 1, rows, labels).ballOf(std::vector{7.0}, 1);
  EXPECT_EQ(votes.simulated, 400u);
  EXPECT_EQ(votes.measured, 600u);
}

TEST(LabelTree, WithoutPointsNobodyVotes) {
  const Votes votes = LabelTree({}, 2, {}, {}).ballOf(std::vector{0.0, 0.0}, 3);
  EXPECT_EQ(votes.simulated + votes.measured, 0u);
}

}  // namespace
