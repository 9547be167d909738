#include "metrics/samples/moment_differences.h"

#include <cmath>
#include <gtest/gtest.h>

namespace {

using metrics::Edf;

TEST(MomentDifferences, ArePositiveWhereTheSimulationIsHigherOrWider) {
  const Edf simulated({10.0, 14.0, 18.0});  // mean 14, median 14, s 4
  const Edf measured({1.0, 2.0, 6.0});      // mean 3, median 2, s sqrt(7)
  EXPECT_DOUBLE_EQ(metrics::meanDifference({.simulated = simulated, .measured = measured}), 11.0);
  EXPECT_DOUBLE_EQ(metrics::medianDifference({.simulated = simulated, .measured = measured}), 12.0);
  EXPECT_DOUBLE_EQ(metrics::standardDeviationDifference({.simulated = simulated, .measured = measured}),
                   4.0 - std::sqrt(7.0));
}

TEST(MomentDifferences, OfASingleValueHaveNoSpread) {
  EXPECT_TRUE(std::isnan(metrics::standardDeviationDifference({.simulated = Edf({1.0}), .measured = Edf({1.0, 2.0})})));
}

}  // namespace
