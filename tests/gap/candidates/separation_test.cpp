#include "gap/candidates/separation.h"

#include <cmath>
#include <gtest/gtest.h>

#include "tests/gap/hypothesis_named.h"
#include "tests/gap/small_world.h"

namespace {

using test_support::SmallWorld;

/// An offset of 50 mm is missing.
class Separation : public testing::Test {
 protected:
  [[nodiscard]] gap::Candidate offset(double value_m) const {
    return {.hypothesis = test_support::hypothesisNamed(hypotheses_, "range-offset"), .values = {value_m}};
  }

  SmallWorld world_;
  model::Experiment measured_ = world_.measuredBy(SmallWorld::modelWith({{"range-offset", {{"offset_m", 0.05}}}}), 0.4);
  gap::Replay replay_{measured_, SmallWorld::modelWith({})};
  gap::Split split_ = gap::splitOf(replay_, 1);
  gap::Judge judge_{replay_, split_, gap::yardstickOf(replay_, split_.held_out)};
  std::vector<gap::Hypothesis> hypotheses_ = gap::hypothesesFor(replay_, {"range-offset"});
};

// Both are 4 mm short, and one is so by 10 µm less: nearer by three standard deviations of a difference of less than
// a nat, for under shared noise two that are nearly one differ by little at random, too.
TEST_F(Separation, TellsTwoThatAreNearlyOneApartNoMoreThanTheirLikelihoodsDo) {
  const gap::Candidate nearer = offset(0.046), farther = offset(0.04599);
  ASSERT_GT(gap::separation(judge_, nearer, farther), 3.0);
  const double told = gap::toldFromOnAll(judge_, judge_, nearer, farther, 0.0);
  EXPECT_GT(told, 0.0);
  EXPECT_LT(told, 1.5);
  EXPECT_GT(gap::separationOnAll(judge_, judge_, nearer, farther, 0.0), told);
}

TEST_F(Separation, OfTwoThatDifferIsWhatTheDataSay) {
  EXPECT_GT(gap::toldFromOnAll(judge_, judge_, offset(0.05), offset(0.055), 0.0), 4.0);
}

// The price of a number is a matter of odds: what is nearer by more than that pays it back.
TEST_F(Separation, OfARivalThatCostsMoreIsItsPriceUnlessItIsNearerByAsMuch) {
  constexpr double kPrice = 4.0;
  EXPECT_NEAR(gap::toldFromOnAll(judge_, judge_, offset(0.05), offset(0.05), 0.0, kPrice), std::sqrt(2.0 * kPrice),
              1e-6);
  EXPECT_EQ(gap::toldFromOnAll(judge_, judge_, offset(0.055), offset(0.05), 0.0, kPrice), 0.0);
  const double alike = 0.5;  // of what is explained: then it is nearer by nothing
  EXPECT_NEAR(gap::toldFromOnAll(judge_, judge_, offset(0.055), offset(0.05), alike, kPrice), std::sqrt(2.0 * kPrice),
              1e-6);
}

}  // namespace
