#include "gap/distance/models_grid.h"

#include <cmath>
#include <gtest/gtest.h>

#include "core/physics.h"
#include "tests/gap/small_world.h"

namespace {

using test_support::SmallWorld;

/// Whether what a model with so many sub-rays measured seems to be made on the grid of 7 by 7 of the model under test.
/// 8 m away the wall ends in a beam, a tenth of a milliradian beside its axis.
bool seemsMadeOnTheModelsGrid(int in_a_row) {
  SmallWorld world;
  world.withAWallOf(2.0 * 8.0 * std::tan(5.0 * core::kRadPerDeg + 0.1e-3));
  const model::Experiment experiment = world.measuredBy(SmallWorld::withRays(in_a_row), 0.4);
  const gap::Replay dense(experiment, SmallWorld::withRays(7), {.edge_rays = 33});
  const gap::Replay as_run(experiment, SmallWorld::withRays(7), {.edge_rays = 0});
  return gap::madeOnTheModelsGrid(dense, as_run);
}

/// The same of a grid of 3 by 3, tall beams and a wall that leans by 80 degrees. No beam meets its edges.
bool seemsMadeOnTheGridThatTearsEchoes(int in_a_row) {
  const auto withRays = [](int rays) { return SmallWorld::withRays(rays, {}, SmallWorld::tallBeams()); };
  SmallWorld world;
  model::Experiment experiment = world.leaning(80.0).measuredBy(withRays(in_a_row), 0.4);
  std::erase_if(experiment.samples, [](const model::Sample& s) { return s.id != "r19"; });
  const gap::Replay dense(experiment, withRays(3), {.edge_rays = 33});
  const gap::Replay as_run(experiment, withRays(3), {.edge_rays = 0});
  for (const gap::ReplaySample& sample : dense.samples())
    for (const gap::Cell& cell : sample.layout->cells()) EXPECT_GE(cell.share, gap::kWholeBeam);
  return gap::madeOnTheModelsGrid(dense, as_run);
}

TEST(ModelsGrid, IsSeenWhereItTearsTheEchoesOfAnObliqueSurfaceApart) {
  EXPECT_TRUE(seemsMadeOnTheGridThatTearsEchoes(3));
  EXPECT_FALSE(seemsMadeOnTheGridThatTearsEchoes(51));
}

TEST(ModelsGrid, IsSeenInWhatTheModelItselfMeasured) { EXPECT_TRUE(seemsMadeOnTheModelsGrid(7)); }

TEST(ModelsGrid, IsNotSeenInWhatAFinerGridMeasured) { EXPECT_FALSE(seemsMadeOnTheModelsGrid(51)); }

}  // namespace
