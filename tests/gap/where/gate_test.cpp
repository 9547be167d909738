#include "gap/where/gate.h"

#include <gtest/gtest.h>

#include "gap/where/where.h"
#include "tests/gap/small_world.h"

namespace {

using test_support::SmallWorld;

/// The gate that a sensor seems to have, whose model has none. Walls stand at 8 to 46 m, ranges scatter by 15 mm.
gap::Gate gateOf(const SmallWorld::Effects& truth) {
  const SmallWorld world;
  const auto measured = world.measuredBy(SmallWorld::modelWith(truth), 0.4);
  const gap::Replay replay(measured, SmallWorld::modelWith({}));
  return gap::whereIn(replay, replay.baseline(), 1).gate;
}

TEST(Gate, IsNowhereWhereNothingIsCutOff) {
  const gap::Gate gate = gateOf({});
  EXPECT_FALSE(gate.opens_m);
  EXPECT_FALSE(gate.closes_m);
  EXPECT_FALSE(gate.nearest_m) << *gate.nearest_m;
  EXPECT_FALSE(gate.farthest_m) << *gate.farthest_m;
}

// The wall of r36 spans 36 to 38.3 m: no sixteenth of the data ends where the gate does.
TEST(Gate, PartsWhatIsLostFromWhatIsThere) {
  const gap::Gate gate = gateOf({{"range-gating", {{"from_m", 0.0}, {"to_m", 37.0}}}});
  ASSERT_TRUE(gate.closes_m);
  EXPECT_NEAR(*gate.closes_m, 37.0, 0.1);  // two beams lie as far apart
  EXPECT_FALSE(gate.opens_m);
}

// It takes a third of the echoes of one wall: more are there than are lost.
TEST(Gate, WithinTheNoiseOfAWallIsTheNearestEcho) {
  const gap::Gate gate = gateOf({{"range-gating", {{"from_m", 7.995}}}});
  EXPECT_FALSE(gate.farthest_m);
  ASSERT_TRUE(gate.nearest_m);
  EXPECT_NEAR(*gate.nearest_m, 8.0, 0.011);  // a step of the resolution
}

TEST(Gate, WithinTheNoiseOfTheLastWallIsTheFarthestEcho) {
  const gap::Gate gate = gateOf({{"range-gating", {{"to_m", 46.02}}}});
  EXPECT_FALSE(gate.nearest_m);
  ASSERT_TRUE(gate.farthest_m);
  EXPECT_NEAR(*gate.farthest_m, 46.02, 0.011);
}

}  // namespace
