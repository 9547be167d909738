#include "gap/next_experiment.h"

#include <gtest/gtest.h>
#include <string>
#include <utility>
#include <vector>

#include "gap/pairs/partners.h"
#include "tests/gap/measured_wall.h"

namespace {

using Names = std::vector<std::string>;

/// Ranges that are all off, seen through dirt in half of the view.
class NextExperiment : public test_support::MeasuredWall {
 protected:
  NextExperiment()
      : MeasuredWall(
            {{"range-offset", {{"offset_m", 0.4}}},
             {"cover-contamination", {{"attenuation", 0.3}, {"azimuth_from_deg", 0.0}, {"azimuth_to_deg", 60.0}}}}) {}

  [[nodiscard]] Names separatedBy(const gap::Decision& decision) const {
    const auto next = gap::nextExperiment(judge_, decision);
    return next ? next->separates : Names{};
  }

  gap::Judge judge_ = judge();
  gap::Candidate offset_ = with("range-offset", {0.4}), dirt_ = with("cover-contamination", {0.3, 0.0, 60.0}),
                 drift_ = with("clock-drift", {5000.0}), loss_ = with("detection-loss", {0.1});
};

TEST_F(NextExperiment, SeparatesWhatIsNamedFromTheBestOfTheOthers) {
  gap::Decision decision;
  decision.singles = {drift_, offset_, dirt_};
  decision.name(offset_);
  EXPECT_EQ(separatedBy(decision), (Names{"range-offset", "clock-drift"}));
}

TEST_F(NextExperiment, SeparatesWhatIsNamedFromWhatTheDataCannotTellFromIt) {
  gap::Decision decision;
  decision.singles = {offset_, drift_, loss_, dirt_};
  decision.name(offset_);
  decision.rivals = {{.name = "clock-drift", .separation = 2.0}, {.name = "detection-loss", .separation = 0.1}};
  EXPECT_EQ(separatedBy(decision), (Names{"range-offset", "detection-loss"}));
}

TEST_F(NextExperiment, IsNoneWhereNoneIsNamed) {
  gap::Decision decision;
  decision.singles = {drift_, dirt_, offset_};
  EXPECT_TRUE(separatedBy(decision).empty());
}

// The clock is the rival of the offset, though a loss of echoes comes nearer than either of the causes alone.
TEST_F(NextExperiment, OfTwoCausesSeparatesOneFromWhatMayStandInItsPlace) {
  gap::Decision decision;
  decision.singles = {loss_, drift_, offset_, dirt_};
  decision.pairs = {gap::pairOf(offset_, dirt_), gap::pairOf(drift_, loss_), gap::pairOf(dirt_, drift_)};
  decision.name(decision.pairs.front());
  EXPECT_EQ(separatedBy(decision), (Names{"range-offset", "clock-drift"}));
}

// Nearest to the pair is what stands in the dirt's place, though another pair is better by merit.
TEST_F(NextExperiment, OfTwoCausesAsksForTheNearestRival) {
  gap::Decision decision;
  decision.singles = {offset_, dirt_, drift_, loss_};
  decision.pairs = {gap::pairOf(offset_, dirt_), gap::pairOf(dirt_, drift_), gap::pairOf(offset_, loss_)};
  decision.name(decision.pairs.front());
  decision.rivals = {{.name = "clock-drift", .separation = 3.0, .instead_of = "range-offset"},
                     {.name = "detection-loss", .separation = 0.1, .instead_of = "cover-contamination"}};
  EXPECT_EQ(separatedBy(decision), (Names{"cover-contamination", "detection-loss"}));
}

TEST_F(NextExperiment, OfTwoCausesWithoutRivalsKeepsTheOtherOne) {
  gap::Decision decision;
  decision.singles = {offset_, dirt_, loss_};
  decision.pairs = {gap::pairOf(offset_, dirt_)};
  decision.name(decision.pairs.front());
  EXPECT_EQ(separatedBy(decision), (Names{"range-offset", "detection-loss"}));
}

// An offset of 0.4 m; a clock that is 0.5 % fast makes 0.04 m of it at the nearest wall, and 0.33 m at the farthest.
TEST_F(NextExperiment, IsTheSampleInWhichTheTwoDifferMost) {
  gap::Decision decision;
  decision.singles = {offset_, drift_};
  decision.name(offset_);
  const auto next = gap::nextExperiment(judge_, decision);
  ASSERT_TRUE(next);
  EXPECT_EQ(next->sample, "r8");
}

TEST_F(NextExperiment, IsNoneWithoutASecondCause) {
  gap::Decision decision;
  decision.singles = {offset_};
  decision.name(offset_);
  EXPECT_FALSE(gap::nextExperiment(judge_, decision));
}

}  // namespace
