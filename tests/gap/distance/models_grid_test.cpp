#include "gap/distance/models_grid.h"

#include <cmath>
#include <gtest/gtest.h>

#include "core/physics.h"
#include "tests/gap/small_world.h"

namespace {

using test_support::SmallWorld;

/// A model with so many sub-rays in a row.
model::LidarModel withRays(int in_a_row) {
  nlohmann::json json = SmallWorld::modelWith({}).json;
  json["rays_per_beam"] = {in_a_row, in_a_row};
  return model::parseModel(json, "small-model.json");
}

/// Whether what a model with so many sub-rays measured seems to be made on the grid of 7 by 7 of the model under test.
/// 8 m away the wall ends in a beam, a tenth of a milliradian beside its axis.
bool seemsMadeOnTheModelsGrid(int in_a_row) {
  SmallWorld world;
  world.withAWallOf(2.0 * 8.0 * std::tan(5.0 * core::kRadPerDeg + 0.1e-3));
  const model::Experiment experiment = world.measuredBy(withRays(in_a_row), 0.4);
  const gap::Replay dense(experiment, withRays(7), {.edge_rays = 33});
  const gap::Replay as_run(experiment, withRays(7), {.edge_rays = 0});
  return gap::madeOnTheModelsGrid(dense, as_run);
}

TEST(ModelsGrid, IsSeenInWhatTheModelItselfMeasured) { EXPECT_TRUE(seemsMadeOnTheModelsGrid(7)); }

TEST(ModelsGrid, IsNotSeenInWhatAFinerGridMeasured) { EXPECT_FALSE(seemsMadeOnTheModelsGrid(51)); }

}  // namespace
