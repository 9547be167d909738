#include "metrics/points/transport.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <limits>
#include <numeric>

#include "tests/metrics/points/random_clouds.h"

namespace {

using metrics::cheapestTransport;
using metrics::CostTable;
using metrics::optimalAssignment;
using metrics::Shipment;
using metrics_test::RandomClouds;

double costOf(const CostTable& costs, const std::vector<std::optional<std::size_t>>& assignment) {
  double sum = 0.0;
  for (std::size_t i = 0; i < assignment.size(); ++i) sum += assignment[i] ? costs(i, *assignment[i]) : 0.0;
  return sum;
}

/// Least cost over all ways to give each row its own column; rows <= columns.
double leastByPermutation(const CostTable& costs) {
  std::vector<std::size_t> column(costs.columns());
  std::iota(column.begin(), column.end(), std::size_t{0});
  double least = std::numeric_limits<double>::infinity();
  do {
    double sum = 0.0;
    for (std::size_t i = 0; i < costs.rows(); ++i) sum += costs(i, column[i]);
    least = std::min(least, sum);
  } while (std::next_permutation(column.begin(), column.end()));
  return least;
}

TEST(OptimalAssignment, CostsAsLittleAsTheBestOfAllPermutations) {
  RandomClouds cases(1);
  for (int k = 0; k < 300; ++k) {
    const std::size_t rows = 1 + cases.below(6);
    const std::size_t columns = rows + cases.below(3);
    const bool whole = k % 2 == 0;  // many ties, and negative costs
    const CostTable costs(rows, columns, [&](std::size_t, std::size_t) {
      return whole ? static_cast<double>(cases.below(4)) - 1.0 : cases.uniform(-5.0, 5.0);
    });
    const double least = leastByPermutation(costs);
    EXPECT_NEAR(costOf(costs, optimalAssignment(costs)), least, 1e-12);
    const CostTable turned(columns, rows, [&](std::size_t i, std::size_t j) { return costs(j, i); });
    EXPECT_NEAR(costOf(turned, optimalAssignment(turned)), least, 1e-12);
  }
}

TEST(OptimalAssignment, GivesNoColumnTwiceAndAsManyAsPossible) {
  RandomClouds cases(2);
  for (int k = 0; k < 100; ++k) {
    const std::size_t rows = 1 + cases.below(8);
    const std::size_t columns = 1 + cases.below(8);
    const CostTable costs(rows, columns, [&](std::size_t, std::size_t) { return cases.uniform(0.0, 1.0); });
    std::vector<int> taken(columns, 0);
    std::size_t assigned = 0;
    for (const auto& column : optimalAssignment(costs)) {
      if (!column) continue;
      ++taken[*column];
      ++assigned;
    }
    EXPECT_EQ(assigned, std::min(rows, columns));
    EXPECT_LE(*std::max_element(taken.begin(), taken.end()), 1);
  }
}

// The nearest column first would cost 1 + 100; giving it up costs 2 + 3.
TEST(OptimalAssignment, GivesUpTheNearestIfTheWholeIsCheaper) {
  const double table[2][2] = {{1.0, 2.0}, {3.0, 100.0}};
  const CostTable costs(2, 2, [&](std::size_t i, std::size_t j) { return table[i][j]; });
  const auto assignment = optimalAssignment(costs);
  EXPECT_EQ(assignment[0], 1U);
  EXPECT_EQ(assignment[1], 0U);
}

TEST(OptimalAssignment, OfNothingIsNothing) {
  const auto never = [](std::size_t, std::size_t) { return 0.0; };
  EXPECT_TRUE(optimalAssignment(CostTable(0, 3, never)).empty());
  EXPECT_EQ(optimalAssignment(CostTable(2, 0, never)), (std::vector<std::optional<std::size_t>>(2)));
}

// A node of k units is k nodes of one unit.
TEST(CheapestTransport, OfUnitsIsTheAssignmentOfRepeatedNodes) {
  RandomClouds cases(3);
  for (int k = 0; k < 200; ++k) {
    const CostTable costs(1 + cases.below(4), 1 + cases.below(4),
                          [&](std::size_t, std::size_t) { return cases.uniform(0.0, 9.0); });
    std::vector<std::int64_t> supply(costs.rows());
    std::vector<std::int64_t> capacity(costs.columns());
    for (auto& units : supply) units = cases.below(4);
    for (auto& units : capacity) units = cases.below(4);
    std::vector<std::size_t> rows;
    std::vector<std::size_t> columns;
    for (std::size_t i = 0; i < supply.size(); ++i) rows.insert(rows.end(), supply[i], i);
    capacity[0] += std::max<std::int64_t>(
        0, static_cast<std::int64_t>(rows.size()) - std::reduce(capacity.begin(), capacity.end()));
    for (std::size_t j = 0; j < capacity.size(); ++j) columns.insert(columns.end(), capacity[j], j);

    std::vector<std::int64_t> sent(supply.size(), 0);
    std::vector<std::int64_t> taken(capacity.size(), 0);
    double cost = 0.0;
    for (const Shipment& part : cheapestTransport(costs, supply, capacity)) {
      EXPECT_GT(part.units, 0);
      sent[part.row] += part.units;
      taken[part.column] += part.units;
      cost += static_cast<double>(part.units) * costs(part.row, part.column);
    }
    EXPECT_EQ(sent, supply);
    for (std::size_t j = 0; j < capacity.size(); ++j) EXPECT_LE(taken[j], capacity[j]);
    const CostTable single(rows.size(), columns.size(),
                           [&](std::size_t i, std::size_t j) { return costs(rows[i], columns[j]); });
    EXPECT_NEAR(cost, costOf(single, optimalAssignment(single)), 1e-11);
  }
}

}  // namespace
