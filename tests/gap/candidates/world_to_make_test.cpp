#include "gap/candidates/world_to_make.h"

#include <gtest/gtest.h>

#include "gap/causes/hypotheses.h"
#include "tests/gap/hypothesis_named.h"
#include "tests/gap/small_world.h"

namespace gap {
namespace {

using test_support::SmallWorld;

/// A wall whose plaster reflects 0.4, seen by a laser of 50 W: what matters is their product.
class WorldOfLessPower : public testing::Test {
 protected:
  [[nodiscard]] World with(const std::string& name, double value) const {
    return worldOf(replay_, test_support::hypothesisNamed(hypotheses_, name), {value});
  }

  SmallWorld small_;
  model::Experiment measured_ = small_.measuredBy(SmallWorld::modelWith({}), 0.4);
  Replay replay_{measured_, SmallWorld::modelWith({})};
  std::vector<Hypothesis> hypotheses_ = hypothesesFor(replay_, {"range-offset"});
  Judge judge_{replay_, splitOf(replay_, 1), yardstickOf(replay_, splitOf(replay_, 1).held_out)};
  WorldToMake world_{judge_, with("/sensor/emitter/peak_power_w", 40.0)};
};

TEST_F(WorldOfLessPower, IsAsFarFromItselfAsNoOther) {
  EXPECT_DOUBLE_EQ(world_.distanceOf(with("/sensor/emitter/peak_power_w", 40.0)), 0.0);
  EXPECT_GT(world_.distanceOf(with("/sensor/emitter/peak_power_w", 41.0)), 0.0);
}

TEST_F(WorldOfLessPower, IsMadeByAWallThatIsAsMuchDarker) {
  const std::string plaster = "/materials/plaster/reflectivity";
  const WorldToMake::Nearest nearest =
      world_.nearestOf(test_support::hypothesisNamed(hypotheses_, plaster).parameters.front(), 0.4,
                       [&](double value) { return with(plaster, value); });
  EXPECT_NEAR(nearest.value, 0.32, 1e-3);
  EXPECT_LT(nearest.distance, 0.01 * world_.distanceOf(replay_.baseline()));
}

TEST_F(WorldOfLessPower, IsMadeByNoOffsetOfAllRanges) {
  const WorldToMake::Nearest nearest =
      world_.nearestOf(test_support::hypothesisNamed(hypotheses_, "range-offset").parameters.front(), 0.0,
                       [&](double value) { return with("range-offset", value); });
  EXPECT_NEAR(nearest.value, 0.0, 0.01);
  EXPECT_GT(nearest.distance, 0.5 * world_.distanceOf(replay_.baseline()));
}

}  // namespace
}  // namespace gap
