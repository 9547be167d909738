#include <gtest/gtest.h>
#include <vector>

#include "gap/distance/discrepancy.h"
#include "tests/gap/small_world.h"

// A beam passes the end of a wall with a little of itself and meets another wall a metre behind it. A beam that is
// wholly on a wall receives 926 times the threshold, so 0.1 % of it make an echo; how much of a beam meets what is
// known to 0.4 %.
namespace {

using test_support::SmallWorld;

struct Cut {
  double share = 0.0, may_be_longer_m = 0.0, width_error_m = 0.0;
};

/// The cells on a wall so wide of beams that pass its end.
std::vector<Cut> cutBy(double width_m) {
  const SmallWorld world;
  const model::LidarModel model = SmallWorld::modelWith({});
  model::Experiment experiment = world.measuredBy(model, 0.4);
  nlohmann::json& scene = experiment.json["scene"];
  scene.push_back(scene[0]);
  scene[0]["shape"]["width_m"] = width_m;
  scene[1]["id"] = "behind";
  scene[1]["pose"]["position_m"][0] = 9.0;
  const gap::Replay replay(experiment, model, {.most_beams = 1000});
  const gap::ReplaySample& sample = replay.samples().front();
  std::vector<Cut> cut;
  for (std::size_t c = 0; c < sample.layout->surfaces(); ++c) {
    const gap::Cell& cell = sample.layout->cells()[c];
    if (cell.object != 0 || cell.share >= gap::kWholeBeam) continue;
    const gap::CellStatistics& both = sample.baseline[c];
    cut.push_back({cell.share, cell.may_be_longer_m, meanError(replay, sample, c, gap::kEpw, both, both)});
  }
  return cut;
}

TEST(LongerEchoes, AreNoErrorWhereHardlyAnythingOfTheBeamMakesThem) {
  const std::vector<Cut> by_a_little = cutBy(1.41585);
  ASSERT_FALSE(by_a_little.empty());
  for (const Cut& cell : by_a_little) {
    EXPECT_LT(1.0 - cell.share, 0.005);
    EXPECT_NEAR(cell.may_be_longer_m, 1.0, 0.02);
    EXPECT_GE(cell.width_error_m, cell.may_be_longer_m);
  }
}

TEST(LongerEchoes, AreErrorsWhereEveryProgramSeesWhatMakesThem) {
  const std::vector<Cut> by_much = cutBy(1.41);
  ASSERT_FALSE(by_much.empty());
  for (const Cut& cell : by_much) {
    EXPECT_GT(1.0 - cell.share, 0.1);
    EXPECT_EQ(cell.may_be_longer_m, 0.0);
    EXPECT_LT(cell.width_error_m, 0.5);
  }
}

}  // namespace
