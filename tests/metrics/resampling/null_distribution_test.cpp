#include "metrics/resampling/null_distribution.h"

#include <gtest/gtest.h>
#include <limits>

#include "core/error.h"

namespace {

using metrics::NullDistribution;
using metrics::permutationPValue;

TEST(NullDistribution, CountsWhatIsUpToAThreshold) {
  const NullDistribution null({3.0, 1.0, 2.0, 4.0});
  EXPECT_EQ(null.shareUpTo(0.5), 0.0);
  EXPECT_EQ(null.shareUpTo(2.0), 0.5);
  EXPECT_EQ(null.shareUpTo(9.0), 1.0);
  EXPECT_EQ(null.median(), 2.5);
  EXPECT_EQ(null.mean(), 2.5);
}

TEST(NullDistribution, OfNothingOrNothingDefinedIsRefused) {
  EXPECT_THROW(NullDistribution({}), core::InputError);
  EXPECT_THROW(NullDistribution({1.0, std::numeric_limits<double>::quiet_NaN()}), core::InputError);
}

// Phipson & Smyth 2010: (b + 1) / (m + 1); a p-value of 0 would claim more than m permutations can know.
TEST(PermutationPValue, IsNeverZeroAndCountsTies) {
  const NullDistribution null({1.0, 2.0, 3.0, 4.0});
  EXPECT_DOUBLE_EQ(permutationPValue(9.0, null), 0.2);
  EXPECT_DOUBLE_EQ(permutationPValue(4.0, null), 0.4);
  EXPECT_DOUBLE_EQ(permutationPValue(0.0, null), 1.0);
}

}  // namespace
