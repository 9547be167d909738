#include "gap/report/quantities.h"

#include <gtest/gtest.h>

namespace gap {
namespace {

TEST(Quantities, AreReadWithoutExponent) {
  EXPECT_EQ(withUnit(0.27, "m"), "0.27 m");
  EXPECT_EQ(withUnit(-4.914e-5, "m"), "-0.0491 mm");
  EXPECT_EQ(withUnit(2.7e-8, "W"), "27 nW");
  EXPECT_EQ(withUnit(0.0, "m"), "0 m");
  EXPECT_EQ(withUnit(0.12345, "m", 2), "0.12 m");
  EXPECT_EQ(withUnit(12.0, "°"), "12°");
  EXPECT_EQ(withUnit(21500.0, "nW"), "21500 nW");
  EXPECT_EQ(withUnit(-1.32e7, "nW"), "-13.2 mW");
}

TEST(Quantities, WhatIsNothingBesideItsNeighboursIsZero) {
  EXPECT_EQ(withUnitOf(0.1, -4.2e-5, "m", 2), "0 m");
  EXPECT_EQ(withUnitOf(0.1, 0.0066, "m", 2), "0.0066 m");
  EXPECT_EQ(withUnitOf(2.5e6, 3000.0, "nW"), "0.003 mW");
}

TEST(Quantities, BothEndsOfAnIntervalHaveOneUnit) {
  EXPECT_EQ(intervalText({0.42, 0.47}, "m"), "0.42 to 0.47 m");
  EXPECT_EQ(intervalText({-0.0002, 0.0007}, "m"), "-0.2 to 0.7 mm");
  EXPECT_EQ(intervalText({-0.0002, 0.0017}, "m"), "-0.0002 to 0.0017 m");
  EXPECT_EQ(intervalText({-0.00598, 0.000509}, "m"), "-0.00598 to 0.000509 m") << "the larger end says which";
  EXPECT_EQ(intervalText({2e-8, 3e-8}, "W"), "20 to 30 nW");
}

// The step of a counter is known to a ten-thousandth of it.
TEST(Quantities, EndsOfANarrowIntervalDiffer) {
  EXPECT_EQ(intervalText({0.041897, 0.041906}, "m"), "0.0419 to 0.04191 m");
  EXPECT_EQ(intervalText({0.0419002, 0.0419031}, "m"), "0.0419 to 0.041903 m");
  EXPECT_EQ(intervalText({20.0, 20.0}, "m"), "20 to 20 m");
}

TEST(Quantities, OneEchoIsNotSeveral) {
  EXPECT_EQ(withUnit(-1.0, "1/shot"), "-1 echo per shot");
  EXPECT_EQ(withUnit(0.5, "1/shot"), "0.5 echoes per shot");
}

TEST(Quantities, AGapThatGrowsManyTimesIsSaidToGrow) {
  EXPECT_EQ(shrinkOf(0.62), "62 %");
  EXPECT_EQ(shrinkOf(-0.3), "-30 %");
  EXPECT_EQ(shrinkOf(-0.003), "0 %");
  EXPECT_EQ(percentInterval({-0.003, 0.05}), "0 to 5 %");
  EXPECT_EQ(shrinkOf(-3.0), "grows 4×");
  EXPECT_EQ(shrinkOf(-124.17), "grows 125×");
  EXPECT_EQ(shrinkInterval(0.62, {0.554, 0.70}), "[55, 70]");
  EXPECT_EQ(shrinkInterval(-124.17, {-139.0, -109.0}), "[110×, 140×]") << "the lesser growth first";
}

}  // namespace
}  // namespace gap
