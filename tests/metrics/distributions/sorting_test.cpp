#include "metrics/distributions/sorting.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <vector>

#include "tests/metrics/random_cases.h"

namespace {

// The standard library sorts independently. Sizes on both sides of every change of method; samples with ties, too.
TEST(SortAscending, GivesTheOrderOfTheStandardLibrary) {
  metrics_test::RandomCases cases(8);
  for (const std::size_t n : {0, 1, 2, 3, 16, 17, 63, 64, 65, 128, 257, 1000, 4097, 100'000}) {
    for (const double ties_per_unit : {0.0, 4.0, 100.0}) {
      std::vector<double> values(n);
      for (double& x : values) {
        x = cases.uniform(-3.0, 3.0);
        if (ties_per_unit > 0.0) x = std::round(x * ties_per_unit) / ties_per_unit + 0.0;
      }
      std::vector<double> expected = values;
      std::sort(expected.begin(), expected.end());
      metrics::sortAscending(values);
      EXPECT_EQ(values, expected) << n;
      std::reverse(values.begin(), values.end());
      metrics::sortAscending(values);
      EXPECT_EQ(values, expected) << n << " descending";
    }
  }
}

TEST(SortAscending, KnowsTheWholeRangeOfFiniteNumbers) {
  using Limits = std::numeric_limits<double>;
  std::vector<double> values{1.0,           Limits::max(),  -Limits::denorm_min(), 0.0, -Limits::min(),
                             Limits::min(), -Limits::max(), Limits::denorm_min(),  -1.0};
  metrics::sortAscending(values);
  EXPECT_EQ(values, (std::vector<double>{-Limits::max(), -1.0, -Limits::min(), -Limits::denorm_min(), 0.0,
                                         Limits::denorm_min(), Limits::min(), 1.0, Limits::max()}));
}

}  // namespace
