#include "gap/replay/cells.h"

#include <gtest/gtest.h>

#include "gap/replay/replay.h"
#include "tests/gap/small_world.h"

namespace {

using test_support::SmallWorld;

/// Cells of the nearest sample, once the wall has been changed.
template <typename Change>
std::vector<gap::Cell> surfacesOnce(const Change& change) {
  const SmallWorld world;
  const model::LidarModel model = SmallWorld::modelWith({});
  model::Experiment experiment = world.measuredBy(model, 0.4);
  change(experiment.json["scene"][0]);
  const gap::Replay replay(experiment, model, {.most_beams = 1000});
  const gap::CellLayout& layout = *replay.samples().front().layout;
  return {layout.cells().begin(), layout.cells().begin() + static_cast<std::ptrdiff_t>(layout.surfaces())};
}

TEST(Cells, OfASurfaceThatEndsAreAtAnEdgeWhereTheBeamIsNotWhollyOnIt) {
  std::size_t at_edge = 0, cells = 0;
  for (const gap::Cell& cell : surfacesOnce([](auto& wall) { wall["shape"]["width_m"] = 1.4; })) {
    EXPECT_EQ(cell.at_edge, cell.share < gap::kWholeBeam) << "share " << cell.share;
    at_edge += cell.at_edge ? 1 : 0;
    ++cells;
  }
  EXPECT_GT(at_edge, 0U);
  EXPECT_LT(at_edge, cells);
}

// Beams of 2 mrad on a wall that is turned by 88 degrees, 8 m away: what one meets is 0.016 m · tan 88° = 0.46 m long,
// and more to the side where the wall recedes. The pulse is 0.67 m long.
TEST(Cells, ThatABeamGrazesAreAtAnEdgeWhereTheyAreLongerThanThePulse) {
  const auto cells = surfacesOnce([](auto& wall) { wall["pose"]["yaw_pitch_roll_deg"][0] = 88.0; });
  ASSERT_FALSE(cells.empty());
  std::size_t at_edge = 0;
  for (const gap::Cell& cell : cells) at_edge += cell.share >= gap::kWholeBeam && cell.at_edge ? 1 : 0;
  EXPECT_GT(at_edge, 0U);
  for (const gap::Cell& cell : surfacesOnce([](auto& wall) { wall["pose"]["yaw_pitch_roll_deg"][0] = 60.0; }))
    EXPECT_EQ(cell.at_edge, cell.share < gap::kWholeBeam) << "0.03 m long";
}

}  // namespace
