#include "gap/where/sectors.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "gap/where/where.h"
#include "tests/gap/measured_wall.h"

namespace {

using test_support::SmallWorld;

class Sectors : public test_support::MeasuredWall {};

TEST_F(Sectors, SeesToABeamWhereASectorEnds) {
  measure({{"cover-contamination", {{"attenuation", 0.05}, {"azimuth_from_deg", -8.4}, {"azimuth_to_deg", 4.4}}}});
  const auto sectors = gap::whereIn(*replay_, replay_->baseline(), 1).sectors;
  ASSERT_FALSE(sectors.empty());
  EXPECT_NEAR(sectors[0].from_deg, -8.4, 0.6);
  EXPECT_NEAR(sectors[0].to_deg, 4.4, 0.6);
}

// Someone raised the power until the mean agreed: inside the sector less is wrong now than outside.
TEST_F(Sectors, SeesASectorThatDiffersLessThanItsSurroundings) {
  const SmallWorld::Effects dirt = {
      {"cover-contamination", {{"attenuation", 0.05}, {"azimuth_from_deg", -8.4}, {"azimuth_to_deg", 4.4}}}};
  const auto truth = SmallWorld::modelWith(dirt, {{"/sensor/emitter/peak_power_w", 53}});
  const auto measured = world_.measuredBy(truth, 0.4);
  const gap::Replay replay(measured, SmallWorld::modelWith({}));
  const auto sectors = gap::whereIn(replay, replay.baseline(), 1).sectors;
  EXPECT_TRUE(std::any_of(sectors.begin(), sectors.end(), [](const gap::Sector& sector) {
    return std::abs(sector.from_deg + 8.4) < 0.6 && std::abs(sector.to_deg - 4.4) < 0.6;
  }));
}

TEST_F(Sectors, SeesNoSectorWhereNothingDiffers) {
  measure({});
  EXPECT_TRUE(gap::whereIn(*replay_, replay_->baseline(), 1).sectors.empty());
}

}  // namespace
