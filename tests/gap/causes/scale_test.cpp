#include "gap/causes/scale.h"

#include <gtest/gtest.h>

// Where a number came out at the upper end of what was searched, the data may ask for more.
namespace gap {
namespace {

TEST(AtUpperEnd, IsAValueBeyondWhichTheRangeMightGoOn) {
  const FreeParameter size{.name = "size_m", .unit = "m", .low = 0.1, .high = 10.0};
  EXPECT_TRUE(atUpperEnd(size, 9.989));
  EXPECT_TRUE(atUpperEnd(size, 10.0));
  EXPECT_FALSE(atUpperEnd(size, 8.97));
  EXPECT_FALSE(atUpperEnd(size, 0.1));
}

TEST(AtUpperEnd, IsNoShareAndNoPlaceWhereTheCauseDoesNothing) {
  EXPECT_FALSE(atUpperEnd({.name = "attenuation", .high = 1.0}, 1.0)) << "no dirt takes more than all";
  EXPECT_TRUE(atUpperEnd({.name = "duration_stddev_ns", .unit = "ns", .high = 1.0}, 1.0));
  EXPECT_FALSE(atUpperEnd({.name = "to_m", .unit = "m", .high = 1000.0, .absent_at = 1000.0}, 1000.0));
  EXPECT_FALSE(atUpperEnd({.name = "azimuth_to_deg", .unit = "deg", .high = 180.0, .azimuth = true}, 180.0));
}

}  // namespace
}  // namespace gap
