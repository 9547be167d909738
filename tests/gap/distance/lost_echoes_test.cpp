#include "gap/distance/lost_echoes.h"

#include <gtest/gtest.h>

#include "gap/causes/split.h"
#include "gap/distance/discrepancy.h"
#include "tests/gap/small_world.h"

// Losses that are rare in every cell and in every sample.
namespace {

using test_support::SmallWorld;

model::LidarModel losing(double probability) {
  if (probability == 0.0) return SmallWorld::modelWith({});
  return SmallWorld::modelWith({{"detection-loss", {{"probability", probability}}}});
}

/// Discrepancy on held-out samples of the model without losses, less that of one that loses so many shots, both to a
/// measurement that lost so many.
double nearerWith(double probability, double measured) {
  const SmallWorld world;
  const model::Experiment experiment = world.measuredBy(losing(measured), 0.4);
  const gap::Replay replay(experiment, SmallWorld::modelWith({}));
  const gap::Evidence held_out = gap::splitOf(replay, 1).held_out;
  gap::World loses = replay.baseline();
  loses.model = losing(probability);
  return gap::discrepancyOf(replay, replay.baseline(), held_out) - gap::discrepancyOf(replay, loses, held_out);
}

// Of two samples of 164 cells and 20 frames they are 33 shots, where the model loses none.
TEST(LostEchoes, OfOneShotInTwoHundredStandOutOverAllSamples) {
  EXPECT_GT(nearerWith(0.005, 0.005), 10.0);
  EXPECT_GT(nearerWith(0.005, 0.005), nearerWith(0.02, 0.005));
}

TEST(LostEchoes, OfOneShotInTwoHundredAreMissedWhereNoneWereLost) { EXPECT_LT(nearerWith(0.005, 0.0), -10.0); }

/// Statistics of one sample of a model without losses, whose cells have lost so many of 20 shots, by turns.
std::vector<gap::CellStatistics> keeping(const gap::Replay& replay, double even_lost, double odd_lost) {
  std::vector<gap::CellStatistics> statistics(replay.samples()[0].layout->cells().size());
  for (std::size_t c = 0; c < replay.samples()[0].layout->surfaces(); ++c)
    statistics[c].count = 20.0 - (c % 2 == 0 ? even_lost : odd_lost);
  return statistics;
}

/// Discrepancy in losses, of one sample whose beams all lose this many of 20 shots on both sides.
double ofLosses(double measured, double simulated) {
  const SmallWorld world;
  const model::Experiment experiment = world.measuredBy(losing(0.0), 0.4);
  const gap::Replay replay(experiment, SmallWorld::modelWith({}));
  const auto m = keeping(replay, measured, measured);
  const std::vector<gap::Comparison> comparisons{{0, m, 20, keeping(replay, simulated, simulated), 20}};
  return gap::lostDiscrepancy(replay, comparisons, {});
}

// Two programs may differ by a tenth of what is lost; by a hundredth of the shots only where half of them are lost.
TEST(LostEchoes, AreKnownToATenthOfThemselves) {
  EXPECT_EQ(ofLosses(0.0, 0.0), 0.0);
  EXPECT_EQ(ofLosses(10.0, 10.2), 0.0);
  EXPECT_GT(ofLosses(0.0, 0.2), 10.0);
}

// A world that loses as many shots as were lost, elsewhere, must not pay for each of them: its rate would come out low.
TEST(LostEchoes, CostNothingWhereAsManyAreLostInOtherCells) {
  const SmallWorld world;
  const model::Experiment experiment = world.measuredBy(losing(0.0), 0.4);
  const gap::Replay replay(experiment, SmallWorld::modelWith({}));
  const auto m = keeping(replay, 1.0, 0.0);
  const auto discrepancyTo = [&](double even_lost, double odd_lost) {
    const std::vector<gap::Comparison> comparisons{{0, m, 20, keeping(replay, even_lost, odd_lost), 20}};
    return gap::discrepancy(replay, comparisons, {});
  };
  EXPECT_DOUBLE_EQ(discrepancyTo(0.0, 1.0), discrepancyTo(1.0, 0.0));
  EXPECT_GT(discrepancyTo(0.0, 20.0), discrepancyTo(1.0, 0.0) + 100.0);
}

}  // namespace
