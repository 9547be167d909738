#include "report/axis.h"

#include <cmath>
#include <gmock/gmock.h>
#include <limits>

namespace report {
namespace {

using testing::ElementsAre;

TEST(NiceTicks, AreMultiplesOfOneTwoOrFiveWithEqualDecimals) {
  EXPECT_THAT(niceTicks({9.93, 10.11}, 4).labels, ElementsAre("9.95", "10.00", "10.05", "10.10"));
  EXPECT_THAT(niceTicks({0.0, 1.0}, 5).labels, ElementsAre("0.0", "0.2", "0.4", "0.6", "0.8", "1.0"));
  EXPECT_THAT(niceTicks({-120.0, 130.0}, 5).labels, ElementsAre("-100", "-50", "0", "50", "100"));
}

TEST(NiceTicks, LieInsideTheRangeForAnyMagnitude) {
  for (const double magnitude : {1e-9, 1e-3, 1.0, 1e4, 1e9}) {
    const Range range = {-0.37 * magnitude, 2.11 * magnitude};
    const Ticks ticks = niceTicks(range, 6);
    EXPECT_GE(ticks.at.size(), 3u);
    EXPECT_LE(ticks.at.size(), 13u);
    EXPECT_EQ(ticks.at.size(), ticks.labels.size());
    for (const double at : ticks.at) {
      EXPECT_GE(at, range.low - 1e-6 * magnitude);
      EXPECT_LE(at, range.high + 1e-6 * magnitude);
    }
  }
}

TEST(NiceTicks, OfNoRangeAreNone) {
  EXPECT_TRUE(niceTicks({1.0, 1.0}, 5).at.empty());
  EXPECT_TRUE(niceTicks({2.0, 1.0}, 5).at.empty());
  EXPECT_TRUE(niceTicks({0.0, std::numeric_limits<double>::infinity()}, 5).at.empty());
  EXPECT_TRUE(niceTicks({std::nan(""), 1.0}, 5).at.empty());
}

TEST(Widened, GivesASingleValueANeighbourhood) {
  for (const double value : {0.0, 10.0, -3e5}) {
    const Range range = widened({value, value}, 0.05);
    EXPECT_LT(range.low, value);
    EXPECT_GT(range.high, value);
    EXPECT_GE(niceTicks(range, 5).at.size(), 2u);
  }
}

TEST(Scale, MapsBackAndForthAndClipsAtTheBorder) {
  const Scale scale({10.0, 20.0}, 300.0, 100.0);  // upside down, as a vertical axis
  EXPECT_DOUBLE_EQ(scale.pixel(10.0), 300.0);
  EXPECT_DOUBLE_EQ(scale.pixel(15.0), 200.0);
  EXPECT_DOUBLE_EQ(scale.value(scale.pixel(12.3)), 12.3);
  EXPECT_DOUBLE_EQ(scale.pixelWithin(99.0), 100.0);
}

}  // namespace
}  // namespace report
