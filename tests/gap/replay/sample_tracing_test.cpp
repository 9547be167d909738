#include "gap/replay/sample_tracing.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <vector>

#include "core/physics.h"
#include "gap/replay/replay.h"
#include "tests/gap/small_world.h"

namespace {

using test_support::SmallWorld;

/// What the beams of one layer meet of a ground so far below the sensor: how far its sub-rays' echoes are apart at
/// most, and how many there are.
struct OnGround {
  double farthest_apart_m = 0.0;
  std::size_t most_hits = 0;
};

OnGround onGround(double below_m, double elevation_deg, const gap::Detail& detail) {
  const SmallWorld world;
  const model::LidarModel model = SmallWorld::modelWith({});
  model::Experiment experiment = world.measuredBy(model, 0.4);
  nlohmann::json& ground = experiment.json["scene"][0];
  ground["shape"] = {{"type", "plane"}};
  ground["pose"]["position_m"][2] = -below_m;
  const gap::Replay replay(experiment, model);
  const auto traced =
      gap::traceSample(experiment, replay.samples().front(), replay.baseline(), replay.baseline(), detail);
  OnGround found;
  for (std::uint32_t b = 0; b < traced->hits.beams.size(); ++b) {
    if (std::abs(traced->hits.beams[b].elevation_rad * core::kDegPerRad - elevation_deg) > 0.01) continue;
    std::vector<double> ranges_m;
    for (const model::Hit& hit : traced->hits.of(b)) ranges_m.push_back(hit.range_m);
    std::sort(ranges_m.begin(), ranges_m.end());
    found.most_hits = std::max(found.most_hits, ranges_m.size());
    for (std::size_t i = 1; i < ranges_m.size(); ++i)
      found.farthest_apart_m = std::max(found.farthest_apart_m, ranges_m[i] - ranges_m[i - 1]);
  }
  return found;
}

// Beams of 4 mrad at -0.4 degrees meet a ground 0.3 m below from 33 to 60 m away; 9 rays in a column meet it up to
// r² / h * 4/9 mrad apart, that is several metres, and a pulse of 4.5 ns is 0.67 m long.
TEST(SampleTracing, OfAGroundThatABeamGrazesNoTwoEchoesAreFartherApartThanAPulseIsLong) {
  EXPECT_GT(onGround(0.3, -0.4, {.edge_rays = 0}).farthest_apart_m, 2.0) << "the model's own grid tears it apart";
  EXPECT_LT(onGround(0.3, -0.4, {}).farthest_apart_m, 0.67);
}

// At -1.2 degrees the same ground is 14 m away, and neighbours meet it 0.3 m apart: nothing is torn.
TEST(SampleTracing, AGroundThatTheModelsOwnGridResolvesIsTracedNoFiner) {
  const OnGround own = onGround(0.3, -1.2, {.edge_rays = 9});
  EXPECT_LT(own.farthest_apart_m, 0.5);
  EXPECT_EQ(onGround(0.3, -1.2, {}).most_hits, own.most_hits);
}

}  // namespace
