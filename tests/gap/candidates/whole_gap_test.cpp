#include "gap/candidates/whole_gap.h"

#include <gtest/gtest.h>

#include "tests/gap/hypothesis_named.h"
#include "tests/gap/small_world.h"

namespace {

using test_support::SmallWorld;

TEST(TotalGap, MayStayAsLargeWhereAllCellsAgreeOrTheCausesOwnNoiseIsLeft) {
  const auto left = [](double explained, double total_left) {
    return gap::Candidate{.explained = explained, .total_left = total_left};
  };
  EXPECT_TRUE(gap::holdsOnTotal(left(0.8, 0.9), 0.1));
  EXPECT_FALSE(gap::holdsOnTotal(left(0.8, 0.9), -0.1)) << "fitted single cells only";
  EXPECT_TRUE(gap::holdsOnTotal(left(0.96, 0.9), -0.1));
  EXPECT_TRUE(gap::holdsOnTotal(left(0.8, 0.4), -0.1)) << "rare false alarms";
}

/// An offset of 30 mm is all that is missing.
class WholeGap : public testing::Test {
 protected:
  /// A cause with values, as if it explained so much of single cells.
  [[nodiscard]] gap::Candidate candidate(const std::string& name, double value, double explained) const {
    return {.hypothesis = test_support::hypothesisNamed(hypotheses_, name), .values = {value}, .explained = explained};
  }
  /// The name of the best after those that do not hold on the total gap have made way.
  [[nodiscard]] std::string leaderOf(std::vector<gap::Candidate> singles) const {
    gap::leadOnTotal(judge_, gaps_, 0.7, singles, core::SilentProgress());
    return singles.front().hypothesis.name;
  }

  SmallWorld world_;
  model::Experiment measured_ = world_.measuredBy(SmallWorld::modelWith({{"range-offset", {{"offset_m", 0.03}}}}), 0.4);
  gap::Replay replay_{measured_, SmallWorld::modelWith({})};
  gap::Split split_ = gap::splitOf(replay_, 1);
  gap::Judge judge_{replay_, split_, gap::yardstickOf(replay_, split_.held_out)};
  gap::HeldOutGaps gaps_{replay_, split_.held_out.samples, 1};
  std::vector<gap::Hypothesis> hypotheses_ = gap::hypothesesFor(replay_, {});
};

TEST_F(WholeGap, IsLedByTheFirstCauseThatShrinksIt) {
  const gap::Candidate noise = candidate("/sensor/detection/range_noise_m", 0.1, 0.9);
  const gap::Candidate offset = candidate("range-offset", 0.03, 0.8);
  EXPECT_EQ(leaderOf({noise, offset}), "range-offset");
  EXPECT_EQ(leaderOf({offset, noise}), "range-offset");
}

TEST_F(WholeGap, IsNotLedByACauseThatAccountsForTooLittle) {
  const std::string noise = "/sensor/detection/range_noise_m";
  EXPECT_EQ(leaderOf({candidate(noise, 0.1, 0.9), candidate("range-offset", 0.03, 0.6)}), noise);
}

TEST_F(WholeGap, IsNotLedByAnotherCauseThatLeavesItAsLarge) {
  const std::string noise = "/sensor/detection/range_noise_m";
  EXPECT_EQ(leaderOf({candidate(noise, 0.1, 0.9), candidate("range-offset", -0.03, 0.8)}), noise);
}

// Pooled data hide what evens out.
TEST_F(WholeGap, IsLedByACauseThatMakesAllCellsAgree) {
  const std::string noise = "/sensor/detection/range_noise_m";
  EXPECT_EQ(leaderOf({candidate(noise, 0.1, 0.96), candidate("range-offset", 0.03, 0.8)}), noise);
}

TEST_F(WholeGap, OfWhichACauseLeavesLittleIsMostlyNoise) {
  gap::Candidate half = candidate("range-offset", 0.015, 0.5);
  half.total_left = 0.7;
  ASSERT_GT(gaps_.aboveNoise(), 0.75);
  EXPECT_GT(gap::restOfWholeGap(gaps_, half), gap::kMostRestOfPair);
  // Of an offset of 2 mm, a fifth of the resolution, most of the gap is noise.
  const auto measured = world_.measuredBy(SmallWorld::modelWith({{"range-offset", {{"offset_m", 0.002}}}}), 0.4);
  const gap::Replay replay(measured, SmallWorld::modelWith({}));
  const gap::HeldOutGaps mostly_noise(replay, split_.held_out.samples, 1);
  EXPECT_LT(gap::restOfWholeGap(mostly_noise, half), gap::kMostRestOfPair);
}

}  // namespace
