#include "gap/candidates/valleys.h"

#include <gtest/gtest.h>

#include "gap/causes/fit.h"
#include "tests/gap/hypothesis_named.h"
#include "tests/gap/small_world.h"

// A receiver that bends softly where it saturates. A hard one that saturates a little lower does nearly the same to the
// nearest wall, and nothing between the two comes near: each cell knows its mean to a thousandth.
namespace {

using test_support::SmallWorld;

class Valleys : public testing::Test {
 protected:
  [[nodiscard]] gap::Candidate with(const std::string& form, std::vector<double> values) const {
    return {test_support::hypothesisNamed(gap::hypothesesFor(replay_, {"saturation"}), "saturation", form),
            std::move(values)};
  }

  /// Of a receiver with next to no noise.
  [[nodiscard]] static model::LidarModel modelWith(const SmallWorld::Effects& effects) {
    return SmallWorld::modelWith(effects, {{"/sensor/receiver/noise_w", 1e-10}});
  }

  SmallWorld world_;
  model::Experiment measured_ =
      world_.measuredBy(modelWith({{"saturation", {{"saturation_w", 5e-6}, {"knee_sharpness", 4.0}}}}), 0.4);
  gap::Replay replay_{measured_, modelWith({})};
  gap::Judge judge_{replay_, gap::splitOf(replay_, 1), gap::yardstickOf(replay_, gap::splitOf(replay_, 1).held_out)};
  gap::Valleys valleys_{judge_};
};

TEST_F(Valleys, TwoNumbersThatMakeUpForEachOtherAreBothFound) {
  const gap::Candidate hard = with("soft knee", {4.96e-6, 22.0});
  const auto refinedFrom = [&](const std::vector<double>& start) {
    return gap::refine(replay_, hard.hypothesis, judge_.split.refined, start, core::SilentProgress());
  };
  EXPECT_GT(refinedFrom(hard.values)[1], 15.0);  // no way leads from there
  const std::vector<double> found = refinedFrom(valleys_.lowestFrom(hard, core::SilentProgress()));
  EXPECT_NEAR(found[0], 5e-6, 0.05e-6);
  EXPECT_NEAR(found[1], 4.0, 0.3);
}

TEST_F(Valleys, ACauseOfOneNumberHasNone) {
  const gap::Candidate clipped = with("", {4.96e-6});
  EXPECT_FALSE(gap::Valleys::mayHelp(clipped));
  EXPECT_EQ(valleys_.lowestFrom(clipped, core::SilentProgress()), clipped.values);
}

TEST_F(Valleys, ValuesThatAreRightStay) {
  const gap::Candidate right = with("soft knee", {5e-6, 4.0});
  const std::vector<double> lowest = valleys_.lowestFrom(right, core::SilentProgress());
  EXPECT_NEAR(lowest[0], 5e-6, 0.02e-6);
  EXPECT_NEAR(lowest[1], 4.0, 0.1);
}

}  // namespace
