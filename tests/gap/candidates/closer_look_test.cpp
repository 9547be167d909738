#include "gap/candidates/closer_look.h"

#include <algorithm>
#include <gtest/gtest.h>

#include "core/physics.h"
#include "gap/candidates/ranking.h"
#include "gap/candidates/significance.h"
#include "gap/far/how_far.h"
#include "gap/pairs/pairs.h"
#include "tests/gap/hypothesis_named.h"
#include "tests/gap/small_world.h"

namespace {

using test_support::SmallWorld;

constexpr double kFrom_deg = 5.5, kTo_deg = 8.5;

const SmallWorld::Effects kDirt = {
    {"cover-contamination", {{"attenuation", 0.4}, {"azimuth_from_deg", kFrom_deg}, {"azimuth_to_deg", kTo_deg}}}};

/// Dirt in front of three columns of beams, and causes that were chosen on beams beside them.
class ChosenBesideTheDirt : public testing::Test {
 protected:
  explicit ChosenBesideTheDirt(const SmallWorld::Effects& truth = kDirt)
      : measured_(world_.measuredBy(SmallWorld::modelWith(truth), 0.4)) {}

  [[nodiscard]] gap::Replay withoutTheDirtyBeams() const {
    std::vector<std::vector<std::uint32_t>> clean;
    for (const gap::ReplaySample& sample : replay_.samples()) {
      clean.emplace_back();
      for (std::uint32_t b = 0; b < sample.beams.size(); ++b) {
        const double azimuth_deg = sample.beams[b].azimuth_rad * core::kDegPerRad;
        if (azimuth_deg < kFrom_deg || azimuth_deg > kTo_deg) clean.back().push_back(b);
      }
    }
    return replay_.only(std::move(clean), replay_.detail());
  }
  [[nodiscard]] std::vector<gap::Candidate> rankedOn(const gap::Judge& quick) {
    const auto hypotheses =
        gap::hypothesesFor(replay_, {"cover-contamination", "range-walk", "atmospheric-attenuation"});
    std::vector<gap::Candidate> singles = gap::rank(quick, hypotheses, where_, progress_);
    for (gap::Candidate& single : singles) exact_.hear(single);
    gap::sortByMerit(singles);
    return singles;
  }

  SmallWorld world_;
  model::Experiment measured_;
  gap::Replay replay_{measured_, SmallWorld::modelWith({})};
  gap::Split split_ = gap::splitOf(replay_, 1);
  gap::Judge exact_{replay_, split_, gap::yardstickOf(replay_, split_.held_out)};
  gap::HeldOutGaps gaps_{replay_, split_.held_out.samples, 1};
  gap::WhereResult where_ = gap::whereIn(replay_, replay_.baseline(), 1);
  core::SilentProgress progress_;
};

TEST_F(ChosenBesideTheDirt, ACauseIsFoundInTheBeamsThatDeviate) {
  const gap::Replay clean = withoutTheDirtyBeams();
  const gap::Judge quick{clean, split_, gap::yardstickOf(clean, split_.held_out)};
  std::vector<gap::Candidate> singles = rankedOn(quick);
  ASSERT_LT(singles.front().explained, 0.5);
  gap::lookCloser(quick, exact_, gaps_, where_, singles, progress_);
  EXPECT_EQ(singles.front().hypothesis.name, "cover-contamination");
  EXPECT_GT(singles.front().explained, 0.9);
  EXPECT_NEAR(singles.front().values.at(0), 0.4, 0.02);
}

TEST_F(ChosenBesideTheDirt, NothingIsLookedAtAgainWhereAllBeamsTookPart) {
  std::vector<gap::Candidate> singles = rankedOn(exact_);
  for (gap::Candidate& single : singles) {
    single.values = {};
    single.explained = 0.0;
  }
  gap::lookCloser(exact_, exact_, gaps_, where_, singles, progress_);
  for (const gap::Candidate& single : singles) EXPECT_TRUE(single.values.empty());
}

/// The same dirt in a world in which all ranges are wrong, too.
class DirtBesideAnOffset : public ChosenBesideTheDirt {
 protected:
  DirtBesideAnOffset() : ChosenBesideTheDirt(both()) {}
  [[nodiscard]] static SmallWorld::Effects both() {
    SmallWorld::Effects effects = kDirt;
    effects["range-offset"] = {{"offset_m", 0.1}};
    return effects;
  }
  /// The offset, as the clean beams tell it.
  [[nodiscard]] gap::Candidate offset(double offset_m = 0.1) const {
    gap::Candidate candidate{
        test_support::hypothesisNamed(gap::hypothesesFor(replay_, {"range-offset"}), "range-offset"), {offset_m}};
    exact_.hear(candidate);
    return candidate;
  }
};

// By all beams much is left beside the offset, by the clean ones nothing.
TEST_F(DirtBesideAnOffset, IsSoughtInTheBeamsThatTheOffsetLeavesWrong) {
  const gap::Replay clean = withoutTheDirtyBeams();
  const gap::Judge quick{clean, split_, gap::yardstickOf(clean, split_.held_out)};
  const auto closely = gap::closeJudgeBeside(quick, exact_, offset(), gap::deviationsLeft(exact_, offset()));
  ASSERT_NE(closely, nullptr);
  const auto hypotheses = gap::hypothesesFor(replay_, {"range-offset", "cover-contamination"});
  const auto singles = gap::rank(closely->judge, hypotheses, where_, progress_);
  const auto pairs = gap::rankPairs(closely->judge, singles, progress_);
  ASSERT_FALSE(pairs.empty());
  const auto members = gap::membersOf(pairs.front());
  const auto dirt = std::find_if(members.begin(), members.end(),
                                 [](const gap::Candidate& m) { return m.hypothesis.name == "cover-contamination"; });
  ASSERT_NE(dirt, members.end());
  EXPECT_NEAR(dirt->values.at(0), 0.4, 0.02);
}

// What is wrong in every beam shows in any few of them.
TEST_F(DirtBesideAnOffset, IsSoughtInTheUsualBeamsWhereTheseAreWrongToo) {
  const gap::Replay clean = withoutTheDirtyBeams();
  const gap::Judge quick{clean, split_, gap::yardstickOf(clean, split_.held_out)};
  EXPECT_EQ(gap::closeJudgeBeside(quick, exact_, offset(0.05), gap::deviationsLeft(exact_, offset(0.05))), nullptr);
  EXPECT_EQ(gap::closeJudgeBeside(exact_, exact_, offset(), gap::deviationsLeft(exact_, offset())), nullptr);
}

}  // namespace
