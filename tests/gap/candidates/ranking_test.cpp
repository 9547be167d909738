#include "gap/candidates/ranking.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "gap/candidates/polish.h"
#include "tests/gap/measured_wall.h"

namespace {

class Ranking : public test_support::MeasuredWall {
 protected:
  /// An effect as it is ranked, with what the residual map suggests.
  [[nodiscard]] gap::Candidate rankedAlone(const char* name) const {
    core::SilentProgress progress;
    return gap::rank(judge(), {effect(name)}, gap::whereIn(*replay_, replay_->baseline(), 1), progress).front();
  }
  /// The variants that are tried of a cause, one of which takes long to fit.
  [[nodiscard]] std::vector<std::string> tried() const {
    gap::Hypothesis costly = movedBy("elsewhere");
    costly.variant = "costly";
    costly.costly = true;
    core::SilentProgress progress;
    std::vector<std::string> variants;
    for (const gap::Candidate& candidate : gap::rank(judge(), {costly, movedBy("elsewhere")}, {}, progress))
      variants.push_back(candidate.hypothesis.variant);
    return variants;
  }
};

// Three frames of four samples do not tell a sector of 34° from the whole view of 40°.
TEST_F(Ranking, FitsTheEndsOfASectorThatIsNearlyTheWholeView) {
  measure({{"cover-contamination", {{"attenuation", 0.02}, {"azimuth_from_deg", -17.4}, {"azimuth_to_deg", 16.4}}}});
  const gap::Candidate found = rankedAlone("cover-contamination");
  ASSERT_EQ(found.hypothesis.parameters[1].name, "azimuth_from_deg");
  EXPECT_NEAR(found.values[0], 0.02, 0.005);
  EXPECT_NEAR(found.values[1], -17.4, 0.6);
  EXPECT_NEAR(found.values[2], 16.4, 0.6);
}

// Fitted walls end at 13.9 m and begin at 27; the one that the gate cuts is held out.
TEST_F(Ranking, TakesWhatTheFittedSamplesLeaveOpenFromWhereEchoesAreLost) {
  measure({{"range-gating", {{"from_m", 19.6}, {"to_m", 1000.0}}}});
  const gap::Candidate found = rankedAlone("range-gating");
  ASSERT_EQ(found.hypothesis.parameters[0].name, "from_m");
  EXPECT_NEAR(found.values[0], 19.6, 0.1);
  EXPECT_GT(found.explained, 0.9);
}

// By the few beams with which causes are chosen a blooming led by 0.5; by all beams it is nothing.
TEST_F(Ranking, LooksAtFurtherCausesWhereAllBeamsSayLessOfTheFirst) {
  measure({{"range-offset", {{"offset_m", 0.1}}}});
  const gap::HeldOutGaps gaps(*replay_, split_.held_out.samples, 1);
  std::vector<gap::Candidate> candidates{
      {.hypothesis = effect("blooming"), .values = {0.001}, .explained = 1.0, .merit = 0.9},
      {.hypothesis = effect("range-offset"), .values = {0.1}, .explained = 0.6, .merit = 0.4}};
  gap::polish(judge(), gaps, candidates, gap::whereIn(*replay_, replay_->baseline(), 1), core::SilentProgress());
  EXPECT_EQ(candidates.front().hypothesis.name, "range-offset");
  EXPECT_GT(candidates.front().merit, 0.9);
}

TEST_F(Ranking, TriesACostlyFormWhereTheUsualOneExplainsSomething) {
  moveBy(0.1);
  EXPECT_THAT(tried(), testing::UnorderedElementsAre("", "costly"));
}

TEST_F(Ranking, TriesNoCostlyFormWhereTheUsualOneExplainsNothing) {
  moveBy(0.0);
  EXPECT_THAT(tried(), testing::ElementsAre(""));
}

}  // namespace
