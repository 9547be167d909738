#include "gap/pairs/partners.h"

#include <gtest/gtest.h>
#include <string>

// Which causes are looked at beside each other.
namespace {

gap::Hypothesis withNumbers(const std::string& name, std::size_t numbers) {
  gap::Hypothesis hypothesis;
  hypothesis.name = name;
  hypothesis.parameters.resize(numbers);
  return hypothesis;
}

TEST(Partners, HaveDifferentNames) {
  EXPECT_TRUE(gap::pairable(withNumbers("speckle", 1), withNumbers("blooming", 1)));
  EXPECT_FALSE(gap::pairable(withNumbers("speckle", 1), withNumbers("speckle", 1)));
}

// A cloud has four numbers, one of another albedo five.
TEST(Partners, OfFiveNumbersAreNotAddedButMayBeKnown) {
  const gap::Hypothesis cloud = withNumbers("exhaust-cloud", 4), dark = withNumbers("exhaust-cloud", 5);
  const gap::Hypothesis speckle = withNumbers("speckle", 1);
  EXPECT_TRUE(gap::pairable(speckle, cloud));
  EXPECT_FALSE(gap::pairable(speckle, dark));
  EXPECT_TRUE(gap::pairable(dark, speckle));
}

}  // namespace
