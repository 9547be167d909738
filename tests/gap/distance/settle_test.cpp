#include "gap/distance/settle.h"

#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <string>

#include "gap/causes/split.h"
#include "tests/gap/small_world.h"

namespace {

using test_support::SmallWorld;

/// How far the wall of each of these samples stands from its recorded place in a world that is drawn at random.
std::vector<double> drawnPlaces_m(const gap::Replay& replay, const std::vector<std::size_t>& samples) {
  constexpr std::uint64_t kSeed = 17;
  gap::Evidence evidence;
  evidence.samples = samples;
  const gap::Measured drawn = gap::measuredIn(replay, replay.baseline(), evidence, kSeed);
  std::vector<double> places_m;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const int frames = replay.samples()[samples[i]].frames;
    const auto recorded = replay.simulate(replay.baseline(), samples[i], frames, kSeed);
    places_m.push_back(drawn[i][0].mean(gap::kRange) - recorded[0].mean(gap::kRange));
  }
  return places_m;
}

// A common cause moves all set-ups alike; were they drawn alike, chance would do the same.
TEST(Settle, DrawsAPlaceOfItsOwnForEverySetUp) {
  SmallWorld world;
  world.knownToWithin(0.05);
  const auto measured = world.measuredBy(SmallWorld::modelWith({}), 0.4);
  const gap::Replay replay(measured, SmallWorld::modelWith({}));
  const std::vector<double> together_m = drawnPlaces_m(replay, {0, 1, 2});
  for (std::size_t s = 0; s < together_m.size(); ++s) {
    EXPECT_LE(std::abs(together_m[s]), 0.05 + 1e-4);
    EXPECT_NEAR(drawnPlaces_m(replay, {s}).front(), together_m[s], 1e-9);
  }
  EXPECT_GT(std::abs(together_m[0] - together_m[1]), 1e-3);
  EXPECT_GT(std::abs(together_m[1] - together_m[2]), 1e-3);
}

// 30 mm everywhere, and 10 mm more or less by set-up: who measured the place wrongly did not set it up better.
TEST(Settle, LetsAReferenceThatIsOffEverywhereScatterAroundThat) {
  SmallWorld world;
  world.knownToWithin(0.012);
  const auto measured =
      world.measuredBy(SmallWorld::modelWith({}), 0.4,
                       {{"r8", 0.04}, {"r13", 0.02}, {"r19", 0.04}, {"r27", 0.02}, {"r36", 0.02}, {"r46", 0.04}});
  const gap::Replay replay(measured, SmallWorld::modelWith({}));
  const gap::Evidence fitted = gap::splitOf(replay, 1).fitted;
  const auto movedBy = [&](const std::map<std::string, double>& more_m) {
    gap::World moved = replay.baseline();
    moved.references.push_back({"/scene/0/pose/position_m/0", 0.03, more_m});
    return gap::discrepancyOf(replay, moved, fitted);
  };
  const double everywhere = movedBy({});
  const double by_setup = movedBy({{"r8", 0.01}, {"r13", -0.01}, {"r27", -0.01}, {"r46", 0.01}});
  const double price = 4 * 0.01 * 0.01 / (2.0 * 0.024 * 0.024 / 12.0);  // of an interval of 24 mm
  const double first_order = 0.02 * gap::discrepancyOf(replay, replay.baseline(), fitted);
  EXPECT_NEAR(everywhere, by_setup + price, first_order);
}

/// A false target as wide as the scan, so far away.
model::LidarModel targetAt(double range_m) {
  return SmallWorld::modelWith(
      {{"spoofing", {{"azimuth_deg", 0.0}, {"width_deg", 180.0}, {"range_m", range_m}, {"power_w", 1e-6}}}});
}

/// How many nats of the discrepancy a target makes that the world has farther away than it was measured.
double ofTargetMovedBy(const gap::Replay& replay, double by_m) {
  const gap::Evidence evidence = gap::splitOf(replay, 1).held_out;
  gap::World right = replay.baseline(), moved = replay.baseline();
  right.model = targetAt(2.0);
  moved.model = targetAt(2.0 + by_m);
  return gap::discrepancyOf(replay, moved, evidence) - gap::discrepancyOf(replay, right, evidence);
}

// Where an echo begins that no surface makes is known to a fiftieth of the pulse, 15 mm of 0.75 m; what all of them
// have in common costs little within that, and is beyond doubt outside. The wall stands where it is recorded in all of
// this.
TEST(Settle, EchoesOfNoSurfaceMayLieMillimetresOff) {
  const SmallWorld world;
  const auto measured = world.measuredBy(targetAt(2.0), 0.4);
  const gap::Replay replay(measured, SmallWorld::modelWith({}));
  EXPECT_LT(ofTargetMovedBy(replay, 0.004), 2.0);
  EXPECT_GT(ofTargetMovedBy(replay, 0.05), 100.0);
}

}  // namespace
