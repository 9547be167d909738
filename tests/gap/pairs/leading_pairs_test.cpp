#include "gap/pairs/leading_pairs.h"

#include <algorithm>
#include <gtest/gtest.h>

#include "gap/pairs/partners.h"
#include "tests/gap/measured_wall.h"

namespace {

/// An offset of all ranges, and dirt in front of three columns of beams.
class LeadingPairs : public test_support::MeasuredWall {
 protected:
  LeadingPairs()
      : MeasuredWall(
            {{"range-offset", {{"offset_m", 0.1}}},
             {"cover-contamination", {{"attenuation", 0.4}, {"azimuth_from_deg", 5.5}, {"azimuth_to_deg", 8.5}}}}) {}

  [[nodiscard]] gap::Candidate judged(gap::Candidate candidate) const {
    judge_.hear(candidate);
    return candidate;
  }

  gap::Judge judge_ = judge();
  gap::Candidate offset_ = with("range-offset", {0.1}), drift_ = with("clock-drift", {100.0}),
                 dirt_ = with("cover-contamination", {0.4, 5.5, 8.5});
};

// Few beams had chosen the drift as the offset's partner: none of them was behind the dirt.
TEST_F(LeadingPairs, TwoCausesThatLeadAreJudgedTogetherThoughNoneWasTheOthersPartner) {
  std::vector<gap::Candidate> pairs{judged(gap::pairOf(offset_, drift_))};
  gap::joinLeaders(judge_, {offset_, drift_, dirt_}, pairs, core::SilentProgress());
  ASSERT_EQ(pairs.size(), 3U);  // the drift beside the dirt as well
  EXPECT_EQ(pairs.front().hypothesis.name, gap::pairOf(offset_, dirt_).hypothesis.name);
  EXPECT_NEAR(pairs.front().explained, 1.0, 0.05);
  EXPECT_TRUE(std::is_sorted(pairs.begin(), pairs.end(), gap::better));
}

TEST_F(LeadingPairs, APairThatWasFittedTogetherKeepsItsBetterValues) {
  const gap::Candidate fitted = judged(gap::pairOf(dirt_, offset_));  // the other way round
  std::vector<gap::Candidate> pairs{fitted};
  gap::joinLeaders(judge_, {with("range-offset", {0.08}), dirt_}, pairs, core::SilentProgress());
  ASSERT_EQ(pairs.size(), 1U);
  EXPECT_EQ(pairs.front().values, fitted.values);
}

TEST_F(LeadingPairs, APairTakesTheBetterValuesThatItsMembersHaveAlone) {
  std::vector<gap::Candidate> pairs{judged(gap::pairOf(dirt_, with("range-offset", {0.08})))};
  gap::joinLeaders(judge_, {offset_, dirt_}, pairs, core::SilentProgress());
  ASSERT_EQ(pairs.size(), 1U);
  EXPECT_EQ(pairs.front().values, gap::pairOf(offset_, dirt_).values);
}

// A gate that few beams led astray had a merit of theirs that the right one, judged by all, did not reach.
TEST_F(LeadingPairs, WhatFewBeamsSayOfAPairKeepsNoBetterValuesOut) {
  gap::Candidate led_astray = judged(gap::pairOf(dirt_, with("range-offset", {0.08})));
  led_astray.merit = 5.0;
  std::vector<gap::Candidate> pairs{led_astray, judged(gap::pairOf(offset_, drift_))};
  gap::joinLeaders(judge_, {offset_, dirt_}, pairs, core::SilentProgress());
  ASSERT_EQ(pairs.size(), 2U);
  EXPECT_EQ(pairs.front().values, gap::pairOf(offset_, dirt_).values);
  EXPECT_EQ(pairs.front().merit, 5.0) << "its place in the list is as it was";
}

TEST_F(LeadingPairs, ThePairThatIsNearestToTheFittedSamplesNeedNotLead) {
  const gap::Candidate wrong = gap::pairOf(offset_, drift_), right = gap::pairOf(offset_, dirt_);
  for (const auto& pairs : {std::vector{wrong, right}, std::vector{right, wrong}})
    EXPECT_EQ(gap::nearestToFitted(judge_, pairs).hypothesis.name, right.hypothesis.name);
}

TEST_F(LeadingPairs, FormsOfOneCauseAreNoPair) {
  std::vector<gap::Candidate> pairs;
  gap::joinLeaders(judge_, {offset_, with("range-offset", {0.05})}, pairs, core::SilentProgress());
  EXPECT_TRUE(pairs.empty());
}

}  // namespace
