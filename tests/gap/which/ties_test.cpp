#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "gap/candidates/separation.h"
#include "gap/which/belief.h"
#include "gap/which/decision.h"
#include "tests/gap/measured_wall.h"

// Which causes the data cannot tell from the one that is named.
namespace {

using test_support::SmallWorld;

class Ties : public test_support::MeasuredWall {};

// A car that is reported 4 ms late at 25 m/s stands 10 cm elsewhere; a delay might be a second, an offset half a metre.
TEST_F(Ties, CannotTellTwoCausesOfOneNumberThatDoTheSameHoweverSmallTheNumber) {
  moveBy(0.1);
  const gap::Judge judge = this->judge();
  const gap::Candidate delay{.hypothesis = movedBy("delay", 1.0, 25.0), .values = {0.004}};
  const gap::Candidate offset{.hypothesis = movedBy("offset"), .values = {0.1}};
  EXPECT_TRUE(gap::rivalsOf(judge, judge, {delay, offset}).front().tied());
  EXPECT_TRUE(gap::rivalsOf(judge, judge, {offset, delay}).front().tied());
}

TEST_F(Ties, TellsACauseThatHardlyEverLooksLikeThisFromOneThatAlwaysDoes) {
  moveBy(0.1);
  const gap::Judge judge = this->judge();
  const gap::Candidate delay{.hypothesis = movedBy("delay"), .values = {0.1}};
  gap::Candidate offset{.hypothesis = movedBy("offset"), .values = {0.1}};
  offset.hypothesis.improbable_nats = 4.0;  // one in fifty-five
  EXPECT_FALSE(gap::rivalsOf(judge, judge, {delay, offset}).front().tied());
  std::vector<gap::Candidate> candidates{offset, delay};
  gap::leadByPlainest(judge, judge, candidates);
  EXPECT_EQ(candidates.front().hypothesis.name, "delay");
}

TEST_F(Ties, SaysWhoMayStandInThePlaceOfOneOfAPair) {
  moveBy(0.1);
  const gap::Judge judge = this->judge();
  const gap::Hypothesis loss = effect("detection-loss");
  const auto besideLoss = [&](const char* name, double offset_m) {
    return gap::Candidate{.hypothesis = gap::together(loss, movedBy(name)), .values = {0.01, offset_m}};
  };
  const auto rivals = gap::rivalsInPairs(
      judge, judge, {besideLoss("delay", 0.1), besideLoss("offset", 0.1), besideLoss("drift", 0.08)}, 0.5);
  ASSERT_EQ(rivals.size(), 2U);
  EXPECT_EQ(rivals[0].name, "offset");
  EXPECT_EQ(rivals[0].instead_of, "delay");
  EXPECT_TRUE(rivals[0].tied());
  EXPECT_EQ(rivals[1].name, "drift");
  EXPECT_FALSE(rivals[1].tied());

  gap::Decision decision;
  decision.name(besideLoss("delay", 0.1));
  decision.rivals = rivals;
  EXPECT_EQ(decision.ties(), std::vector<std::string>{"offset"});
  EXPECT_EQ(gap::shareOf(decision, "detection-loss"), 1.0);
  EXPECT_NEAR(gap::shareOf(decision, "delay"), 2.5 / 3.5, 0.01);  // what leads is 2.5 times as likely
  EXPECT_NEAR(gap::shareOf(decision, "offset"), 1.0 / 3.5, 0.01);
  decision.pairs = {besideLoss("delay", 0.1), besideLoss("drift", 0.08), besideLoss("offset", 0.1)};
  const auto tied = gap::tiedPairs(decision);
  ASSERT_EQ(tied.size(), 1U);
  EXPECT_EQ(tied[0].first, "offset");
  EXPECT_EQ(tied[0].second.hypothesis.name, decision.pairs[2].hypothesis.name);
}

// At the one range that is held out, an offset and a scale do the same; those that were fitted tell them apart.
TEST_F(Ties, TellsCausesByTheFittedSamplesThatTheHeldOutOnesCannotTell) {
  measure({{"range-offset", {{"offset_m", 0.02}}}});
  for (model::Sample& sample : measured_.samples)
    sample.role = sample.id == "r19" ? model::Role::kPrediction : model::Role::kCalibration;
  replay_.emplace(measured_, SmallWorld::modelWith({}));
  split_ = gap::splitOf(*replay_, 1);
  const gap::Judge judge = this->judge();
  const double range_m = gap::situationIn(replay_->baseline(), measured_, *replay_->samples()[2].sample)
                             .scene.objects.front()
                             .pose.position_m[0];
  const gap::Candidate offset{.hypothesis = effect("range-offset"), .values = {0.02}};
  const gap::Candidate drift{.hypothesis = effect("clock-drift"), .values = {1e6 * 0.02 / range_m}};
  EXPECT_LT(std::abs(gap::separation(judge, offset, drift)), 1.5);
  EXPECT_GT(gap::separationOnAll(judge, judge, offset, drift, 0.03), 4.0);
  EXPECT_LE(gap::separationOnAll(judge, judge, drift, offset, 0.03), 0.0);
  EXPECT_EQ(gap::separationOnAll(judge, judge, offset, offset, 0.03), 0.0);
}

// Of two causes that say the same with one number neither can be preferred; one that needs a second number for it can
// be left aside.
TEST_F(Ties, IsNotToldFromATwinButFromACauseWithAnIdleNumber) {
  moveBy(0.1);
  gap::Hypothesis idle = movedBy("with an idle number");
  idle.parameters.push_back({"idle", "", 1.0, 2.0, false, 1.5});
  const gap::HeldOutGaps gaps(*replay_, split_.held_out.samples, 1);
  core::SilentProgress progress;
  const gap::Decision decision =
      gap::decide(judge(), judge(), gaps, true, {}, {movedBy("elsewhere"), movedBy("twin"), idle}, progress);
  ASSERT_TRUE(decision.winner.has_value());
  std::vector<std::string> alike = decision.ties();
  alike.push_back(decision.winner->hypothesis.name);
  EXPECT_THAT(alike, testing::UnorderedElementsAre("elsewhere", "twin"));
}

}  // namespace
