#include "gap/replay/cells.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <utility>
#include <vector>

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

// Wholly on the pane, but the wall behind it ends within some beams.
TEST(Cells, WhereAWallEndsBehindAPaneAreAtAnEdge) {
  SmallWorld world;
  world.withAWallOf(1.4).behindAPane(2.0);
  const model::LidarModel model = SmallWorld::modelWith({{"transmission", nlohmann::json::object()}});
  const model::Experiment experiment = world.measuredBy(model, 0.4);
  const gap::Replay replay(experiment, model, {.most_beams = 1000});
  const gap::CellLayout& layout = *replay.samples().front().layout;
  std::size_t partly = 0, inside = 0;
  for (std::size_t c = layout.surfaces(); c < layout.cells().size(); ++c) {
    const gap::Cell& cell = layout.cells()[c];
    if (cell.share >= gap::kWholeBeam) {
      inside += cell.at_edge ? 0 : 1;
    } else if (cell.share > 0.0) {
      EXPECT_TRUE(cell.at_edge) << "share " << cell.share;
      ++partly;
    }
  }
  EXPECT_GT(partly, 0U);
  EXPECT_GT(inside, 0U);
}

/// Of echoes at these ranges in the beam of the first surface, and of others, how many the surface's cell keeps.
std::pair<int, int> keptOf(const gap::CellLayout& layout, const std::vector<double>& own_m,
                           const std::vector<double>& others_m) {
  std::vector<model::Shot> shots;
  for (const std::vector<double>& ranges_m : {own_m, others_m}) {
    for (const double range_m : ranges_m) {
      shots.emplace_back();
      shots.back().beam = layout.cells().front().beam;
      shots.back().range_m = range_m;
    }
  }
  const std::vector<std::size_t> cells = layout.cellsOf(shots);
  const auto others = cells.begin() + static_cast<std::ptrdiff_t>(own_m.size());
  return {std::count(cells.begin(), others, std::size_t{0}), std::count(others, cells.end(), std::size_t{0})};
}

/// Of a wall 8 m away, 6 m behind a pane, a beam has 12 echoes, and 4 of the pane: how many of either the pane's cell
/// keeps. Of two echoes that are nearer to each other than this the sensor reports one.
std::pair<int, int> ofThePaneAndTheWall(double echo_separation_m) {
  SmallWorld world;
  world.behindAPane(2.0);
  const model::LidarModel model = SmallWorld::modelWith({{"transmission", nlohmann::json::object()}},
                                                        {{"/sensor/detection/echo_separation_m", echo_separation_m}});
  const model::Experiment experiment = world.measuredBy(model, 0.4);
  const gap::Replay replay(experiment, model);
  const gap::CellLayout& layout = *replay.samples().front().layout;
  const double pane_m = layout.cells().front().anchor_m;
  return keptOf(layout, std::vector<double>(4, pane_m), std::vector<double>(12, 4.0 * pane_m));
}

// A sensor that reports the strongest echo alone shows the wall where it loses the pane's: far behind the pane, but
// within two separations.
TEST(Cells, OfAPaneDoNotTakeWhatTheBeamMeetsBehindIt) {
  EXPECT_EQ(ofThePaneAndTheWall(0.3), std::pair(4, 0));
  EXPECT_EQ(ofThePaneAndTheWall(4.0), std::pair(4, 0));
}

/// Of two echoes in every shot, the surface's own and one so far behind it, some of which are lost: how many of either
/// the surface's cell keeps.
std::pair<int, int> keptBesideAFalseTarget(double behind_m, int own, int others) {
  const SmallWorld world;
  const model::LidarModel model = SmallWorld::modelWith({});
  const model::Experiment experiment = world.measuredBy(model, 0.4);
  const gap::Replay replay(experiment, model);
  const gap::CellLayout& layout = *replay.samples().front().layout;
  const double surface_m = layout.cells().front().anchor_m;
  std::vector<double> own_m, others_m;
  for (int i = 0; i < own + others; ++i)
    (i < own ? own_m : others_m).push_back(surface_m + 0.001 * i + (i < own ? 0.0 : behind_m));
  return keptOf(layout, own_m, others_m);
}

// The median of both would be between them, or with the one of which fewer are lost.
TEST(Cells, OfASurfaceKeepTheEchoesNearestToItWhereEveryShotSeesAFalseTargetToo) {
  for (const double behind_m : {1.3, -1.3}) {
    for (const auto& [own, others] : {std::pair(8, 8), std::pair(8, 7), std::pair(7, 8)})
      EXPECT_EQ(keptBesideAFalseTarget(behind_m, own, others), std::pair(own, 0)) << behind_m << " " << own;
  }
}

// Where hardly any echo comes from where the surface is recorded, it stands elsewhere.
TEST(Cells, OfASurfaceKeepTheEchoesThatComeOftenWhereverTheyComeFrom) {
  EXPECT_EQ(keptBesideAFalseTarget(0.6, 2, 14), std::pair(0, 14));
}

/// Echoes near the threshold, two thirds of them 0.3 m before the surface and a third 0.15 m: how many its cell keeps.
int keptNearTheThreshold(const char* range_mode) {
  const SmallWorld world;
  model::LidarModel model = SmallWorld::modelWith({});
  model.json["sensor"]["detection"]["range_mode"] = range_mode;
  model = model::parseModel(model.json, model.file);
  const model::Experiment experiment = world.measuredBy(model, 0.4);
  const double over_threshold =
      gap::Replay(experiment, model).samples().front().layout->cells().front().power_over_threshold;
  nlohmann::json& threshold_w = model.json["sensor"]["receiver"]["threshold_w"];
  threshold_w = threshold_w.get<double>() * over_threshold / 2.0;
  model = model::parseModel(model.json, model.file);
  const gap::Replay replay(experiment, model);
  const gap::CellLayout& layout = *replay.samples().front().layout;
  std::vector<double> ranges_m;
  for (int i = 0; i < 9; ++i) ranges_m.push_back(layout.cells().front().anchor_m - (i < 6 ? 0.3 : 0.15) + 0.001 * i);
  return keptOf(layout, ranges_m, {}).first;
}

// A pulse of 0.67 m whose peak is twice the threshold passes it 0.33 m before the peak, one of 1.2 times 0.17 m.
TEST(Cells, OfASurfaceKeepWeakEchoesWhoseLeadingEdgeWalks) {
  EXPECT_EQ(keptNearTheThreshold("leading-edge"), 9);
  EXPECT_EQ(keptNearTheThreshold("peak"), 3) << "a peak does not walk: those nearest to the surface are its own";
}

/// The mean echo pulse width of a surface of which sixteen echoes are seen, one of them as wide as this.
double meanWithOneOfWidth(double width_m) {
  const SmallWorld world;
  const model::LidarModel model = SmallWorld::modelWith({});
  const gap::Replay replay(world.measuredBy(model, 0.4), model);
  const gap::CellLayout& layout = *replay.samples().front().layout;
  std::vector<model::Shot> shots(16);
  for (std::size_t i = 0; i < shots.size(); ++i) {
    shots[i].beam = layout.cells().front().beam;
    shots[i].range_m = layout.cells().front().anchor_m + 0.001 * static_cast<double>(i);
    shots[i].epw_m = i == 5 ? width_m : 2.0 + 0.04 * static_cast<double>(i % 2);
  }
  const gap::CellStatistics surface = layout.statisticsOf(shots).front();
  EXPECT_EQ(surface.count, 16.0) << "it is an echo of the surface nevertheless";
  return surface.mean(gap::kEpw);
}

// Its width says how far behind the surface the false echo lies, and would move the mean by ten times its error.
TEST(Cells, OfASurfaceDoNotAskTheWidthOfAnEchoThatAFalseOneHasMergedWith) {
  const double without = (2.0 * 8 + 2.04 * 7) / 15.0;
  EXPECT_NEAR(meanWithOneOfWidth(6.0), without, 0.04 / 16.0);
  EXPECT_NEAR(meanWithOneOfWidth(2.2), (15.0 * without + 2.2) / 16.0, 1e-9) << "three times the noise of the profile";
  EXPECT_NEAR(meanWithOneOfWidth(0.5), (15.0 * without + 0.5) / 16.0, 1e-9) << "nothing that merges makes it narrower";
}

}  // namespace
