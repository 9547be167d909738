#include "gap/which/ruling.h"

#include <gtest/gtest.h>
#include <string>

#include "gap/diagnosis.h"
#include "tests/gap/measured_wall.h"

// Who judges, and whether there is anything to judge.
namespace {

class FirstLook : public test_support::MeasuredWall {
 protected:
  /// The wall of one sample stands elsewhere than recorded.
  gap::FirstLook where(const std::string& sample, double offset_m) {
    measure({}, {{sample, offset_m}});
    return gap::judgeOf(*replay_, 1, {});
  }
};

// 5 mm in one of the samples that are fitted: beyond doubt in these, hardly seen once every second beam of all samples
// is held out.
TEST_F(FirstLook, OfAGapInOnePartOfTheSamplesIsBeyondDoubtThoughTheirBeamsTogetherHideIt) {
  const gap::FirstLook look = where("r8", 0.005);
  ASSERT_TRUE(look.judge.split.weak);
  ASSERT_GT(look.judge.yardstick.p_value(), gap::kSignificance);
  EXPECT_LT(look.p_value, gap::kSignificance);
}

TEST_F(FirstLook, LeavesTheJudgementToTheSamplesWhereNeitherPartDeviates) {
  const gap::FirstLook look = where("r8", 0.0);
  EXPECT_FALSE(look.judge.split.weak);
  EXPECT_EQ(look.p_value, look.judge.yardstick.p_value());
  EXPECT_GT(look.p_value, gap::kSignificance);
}

}  // namespace
