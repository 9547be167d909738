#include "gap/causes/split.h"

#include <gtest/gtest.h>
#include <set>

#include "gap/distance/discrepancy.h"
#include "tests/gap/small_world.h"

namespace {

using test_support::SmallWorld;

// Two echoes of an upright edge merge in one column of beams. If that column judged, nothing of it was fitted, and if
// it was fitted, nothing judged: a gap of 26 standard deviations was none.
TEST(SplitByBeams, LeavesBeamsOfEveryColumnAndLayerOnBothSides) {
  const SmallWorld world;
  const auto model = SmallWorld::modelWith({});
  const auto measured = world.measuredBy(model, 0.4);
  const gap::Replay replay(measured, model);
  const gap::Split split = gap::splitByBeams(replay, 1);
  std::set<int> columns[2], layers[2];
  const gap::ReplaySample& sample = replay.samples().front();
  for (const gap::Cell& cell : sample.layout->cells()) {
    const bool fitted = gap::takesPart(sample, cell, split.fitted.part);
    ASSERT_NE(fitted, gap::takesPart(sample, cell, split.held_out.part));
    columns[fitted].insert(sample.beams[cell.beam].column);
    layers[fitted].insert(sample.beams[cell.beam].layer);
  }
  EXPECT_GT(columns[0].size(), 10U);
  EXPECT_EQ(columns[0], columns[1]);
  EXPECT_EQ(layers[0], layers[1]);
}

}  // namespace
