#include "gap/pairs/pair_by_means.h"

#include <gtest/gtest.h>
#include <utility>

#include "gap/pairs/partners.h"
#include "tests/gap/measured_wall.h"

namespace {

/// Ranges that are all off by so much, and dirt in front of half of the scan.
class MeansOfTwoCauses : public test_support::MeasuredWall {
 protected:
  explicit MeansOfTwoCauses(double offset_m = 0.4, double attenuation = 0.3)
      : MeasuredWall({{"range-offset", {{"offset_m", offset_m}}},
                      {"cover-contamination",
                       {{"attenuation", attenuation}, {"azimuth_from_deg", 0.0}, {"azimuth_to_deg", 60.0}}}}),
        offset_m_(offset_m),
        attenuation_(attenuation) {}

  /// Of these pairs, where the offset and the dirt are the best single causes, and a pair would be named.
  [[nodiscard]] std::optional<gap::Candidate> chosenOf(const std::vector<gap::Candidate>& pairs,
                                                       std::vector<gap::Candidate> leaders = {}) const {
    leaders.insert(leaders.end(), {offset_, dirt_});
    return gap::pairByMeans(judge_, leaders, pairs, core::SilentProgress());
  }

  double offset_m_, attenuation_;
  gap::Judge judge_ = judge();
  gap::Candidate offset_ = with("range-offset", {offset_m_}),
                 dirt_ = with("cover-contamination", {attenuation_, 0.0, 60.0}), drift_ = with("clock-drift", {100.0}),
                 loss_ = with("detection-loss", {0.01});
};

class MeansOfOneCause : public MeansOfTwoCauses {
 protected:
  MeansOfOneCause() : MeansOfTwoCauses(0.0) {}
};

class MeansOfAnOffsetAndALittleDirt : public MeansOfTwoCauses {
 protected:
  MeansOfAnOffsetAndALittleDirt() : MeansOfTwoCauses(0.4, 0.05) {}
};

TEST_F(MeansOfTwoCauses, ChooseThePairThatTakesWhatEachCauseLeaves) {
  const auto chosen = chosenOf({gap::pairOf(offset_, drift_), gap::pairOf(offset_, dirt_), gap::pairOf(dirt_, loss_)});
  ASSERT_TRUE(chosen);
  EXPECT_EQ(chosen->hypothesis.name, gap::pairOf(offset_, dirt_).hypothesis.name);
}

TEST_F(MeansOfTwoCauses, ChooseNoPairThatTakesAPartOfIt) {
  EXPECT_FALSE(
      chosenOf({gap::pairOf(offset_, drift_), gap::pairOf(offset_, with("cover-contamination", {0.3, 30.0, 60.0}))}));
}

// Of a gap that is mostly an offset the dirt is less than a twentieth; but with both there is only noise.
TEST_F(MeansOfAnOffsetAndALittleDirt, ChooseThePairThatLeavesNothing) {
  const gap::Candidate both = gap::pairOf(offset_, dirt_);
  const auto chosen = chosenOf({gap::pairOf(offset_, drift_), both});
  ASSERT_TRUE(chosen);
  EXPECT_EQ(chosen->hypothesis.name, both.hypothesis.name);
}

TEST_F(MeansOfTwoCauses, ChooseNoOtherPairThanTheOneThatIsNamed) {
  const gap::Candidate both = gap::pairOf(offset_, dirt_);
  EXPECT_FALSE(chosenOf({both, gap::pairOf(offset_, drift_)}, {both}));
  const auto chosen = chosenOf({both, gap::pairOf(offset_, drift_)}, {gap::pairOf(offset_, drift_)});
  ASSERT_TRUE(chosen);
  EXPECT_EQ(chosen->hypothesis.name, both.hypothesis.name);
}

// Whatever takes the rest then takes noise.
TEST_F(MeansOfOneCause, ChooseNoPairWhereASingleCauseLeavesNothing) {
  EXPECT_FALSE(chosenOf({gap::pairOf(dirt_, drift_), gap::pairOf(dirt_, loss_)}));
}

}  // namespace
