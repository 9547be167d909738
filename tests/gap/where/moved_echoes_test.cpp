#include "gap/where/moved_echoes.h"

#include <cmath>
#include <gtest/gtest.h>

#include "core/json_object.h"
#include "gap/where/where.h"
#include "model/simulate.h"
#include "tests/gap/small_world.h"

namespace {

using test_support::SmallWorld;

/// A van's front, 1.5 m wide and as high as the view, 5 m before the sensor; the wall stands at 8 m and farther.
nlohmann::json withAVan(nlohmann::json experiment, double y_m) {
  experiment["scene"].push_back({{"id", "van"},
                                 {"shape", {{"type", "rectangle"}, {"width_m", 1.5}, {"height_m", 3.0}}},
                                 {"pose", {{"position_m", {5.0, y_m, 0.0}}, {"yaw_pitch_roll_deg", {0, 0, 0}}}},
                                 {"material", "plaster"}});
  return experiment;
}

/// Echoes per shot that all cells of a sample lack, or have too many.
double sumOf(const std::vector<gap::ResidualTable>& tables, const std::string& component) {
  double sum = 0.0;
  for (const gap::ResidualTable& table : tables) {
    if (table.measurand != "existence" || table.component != component) continue;
    for (const auto& row : table.rows) sum += std::abs(row.value) > 0.5 ? row.value : 0.0;
  }
  return sum;
}

class AVanBesideItsPlace : public testing::Test {
 protected:
  AVanBesideItsPlace() {
    core::SilentProgress progress;
    const auto real = model::parseExperiment(withAVan(world_.recorded(), 0.35), world_.folder() / "experiment.json");
    model::simulatePackage(real, model_, world_.folder() / "van", 4711, progress);
    core::writeJson(world_.folder() / "van" / "experiment.json", withAVan(world_.recorded(), 0.0));
    experiment_ = model::readExperiment(world_.folder() / "van");
    replay_.emplace(experiment_, model_);
    where_ = gap::whereIn(*replay_, replay_->baseline(), 1);
  }

  SmallWorld world_;
  model::LidarModel model_ = SmallWorld::modelWith({});
  model::Experiment experiment_;
  std::optional<gap::Replay> replay_;
  gap::WhereResult where_;
};

// The van's sides move from 8.5 degrees to 12.4 and from -8.5 to -4.6: four beams of one degree on either side, in four
// layers and six samples, see the van in place of the wall, or the wall in place of the van; no beam meets an edge.
TEST_F(AVanBesideItsPlace, HasItsEchoesElsewhereRatherThanMissingHereAndExtraThere) {
  EXPECT_LT(sumOf(where_.tables, "missing"), -2 * 4 * 4 * 6 + 1);
  EXPECT_GT(sumOf(where_.tables, "extra"), 2 * 4 * 4 * 6 - 1);
  EXPECT_GT(sumOf(where_.by_beam, "missing"), -1e-9);
  EXPECT_LT(sumOf(where_.by_beam, "extra"), 1e-9);
}

// The wall of r8 is 3 m behind the van, that of r46 41 m.
TEST_F(AVanBesideItsPlace, MovesTheRangeByTheDistanceToTheWallBehindIt) {
  double farthest = 0.0, nearest = 1e9;
  const gap::ResidualTable& range = where_.by_beam.front();
  ASSERT_EQ(range.measurand + range.component, "rangebias");
  for (const auto& row : range.rows) {
    if (std::abs(row.value) < 1.0) continue;
    farthest = std::max(farthest, std::abs(row.value));
    nearest = std::min(nearest, std::abs(row.value));
  }
  EXPECT_NEAR(nearest, 3.0, 0.1);
  EXPECT_NEAR(farthest, 41.0, 1.0);  // oblique beams have a longer way behind it
}

// Where the simulation expects nothing else, lost echoes are missing and nothing moved.
TEST(MovedEchoes, AreNoneWhereEchoesAreOnlyLost) {
  const SmallWorld world;
  const auto truth = SmallWorld::modelWith({{"detection-loss", {{"probability", 0.5}}}});
  const auto measured = world.measuredBy(truth, 0.4);
  const gap::Replay replay(measured, SmallWorld::modelWith({}));
  const gap::WhereResult where = gap::whereIn(replay, replay.baseline(), 1);
  ASSERT_EQ(where.tables.size(), where.by_beam.size());
  for (std::size_t t = 0; t < where.tables.size(); ++t) {
    ASSERT_EQ(where.tables[t].rows.size(), where.by_beam[t].rows.size());
    for (std::size_t r = 0; r < where.tables[t].rows.size(); ++r)
      ASSERT_EQ(where.tables[t].rows[r].value, where.by_beam[t].rows[r].value);
  }
}

}  // namespace
