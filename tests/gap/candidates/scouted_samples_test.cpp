#include "gap/candidates/scouted_samples.h"

#include <gtest/gtest.h>

#include "gap/causes/split.h"
#include "tests/gap/small_world.h"

namespace {

using test_support::SmallWorld;

/// Of six samples, once one of them was measured beside its recorded place.
std::vector<std::size_t> scouted(const std::string& sample, double displaced_m) {
  const SmallWorld world;
  const model::LidarModel model = SmallWorld::modelWith({});
  const model::Experiment experiment = world.measuredBy(model, 0.4, {{sample, displaced_m}});
  const gap::Replay replay(experiment, model);
  gap::Evidence all = gap::splitOf(replay, 1).fitted;
  all.samples = {0, 1, 2, 3, 4, 5};
  return gap::scoutedSamples(all, gap::whereIn(replay, replay.baseline(), 1)).samples;
}

TEST(ScoutedSamples, AreFewAllOverTheList) { EXPECT_EQ(scouted("r19", 0.0), (std::vector<std::size_t>{0, 1, 3, 5})); }

TEST(ScoutedSamples, HoldTheOneInWhichAloneSomethingIsMissing) {
  EXPECT_EQ(scouted("r19", 0.2), (std::vector<std::size_t>{0, 1, 2, 3, 5}));
  EXPECT_EQ(scouted("r8", 0.2), (std::vector<std::size_t>{0, 1, 3, 5})) << "it is one of the few";
}

TEST(ScoutedSamples, AreFewWhereNoResidualsAreKnown) {
  gap::Evidence all;
  all.samples = {0, 1, 2, 3, 4, 5};
  EXPECT_EQ(gap::scoutedSamples(all, {}).samples, (std::vector<std::size_t>{0, 1, 3, 5}));
}

}  // namespace
