#include "gap/where/residual_tables.h"

#include <cmath>
#include <gtest/gtest.h>

#include "core/random.h"
#include "tests/gap/small_world.h"

namespace {

gap::ResidualTable tableOf(const std::vector<double>& values, double error) {
  gap::ResidualTable table{"epw", "bias", "m", 0.04, {}};
  for (std::size_t i = 0; i < values.size(); ++i) table.rows.push_back({0, i, values[i], error, 10.0});
  return table;
}

TEST(ResidualTable, ExcessIsZeroWhereResidualsAreNoLargerThanTheirErrors) {
  EXPECT_EQ(tableOf({0.01, -0.012, 0.008}, 0.01).excess(), 0.0);
}

// sqrt(0.05² - (2·0.015)²) = 0.04: one step of 0.04 m in half of the rows.
TEST(ResidualTable, ExcessCountsWhatTheErrorLeavesInStepsOfTheResolution) {
  EXPECT_NEAR(tableOf({0.05, 0.0}, 0.015).excess(), 0.5, 1e-12);
}

// What lies two errors above zero counts as an extra echo, not as a missing one, so noise alone has a mean below zero.
TEST(ResidualTable, MissingEchoesThatNoiseAloneMakesAreNoCommonShift) {
  constexpr double kError = 0.03;
  gap::ResidualTable missing{"existence", "missing", "1/shot", 0.01, {}};
  core::Random random({.seed = 5});
  for (std::uint32_t beam = 0; beam < 40000; ++beam) {
    const double value = kError * random.normal();
    missing.rows.push_back({0, beam, value < 2.0 * kError ? value : 0.0, kError, 20.0, beam});
  }
  EXPECT_EQ(missing.commonShift(), 0.0);
  for (gap::ResidualTable::Row& row : missing.rows) row.value -= 0.1 * kError;
  EXPECT_NEAR(missing.commonShift(), 0.154 * kError / 0.01, 0.05);  // with φ(2) of the error, which stays in the value
}

// A beam's echoes are looked for in several places: on each surface that it meets, and where nothing is.
TEST(ResidualTable, ShotsOfABeamCountOnce) {
  constexpr std::uint32_t kBeam = 7;
  gap::ResidualTable table{"existence", "extra", "1/shot", 0.01, {}};
  table.rows = {{0, 0, 0.1, 0.01, 20.0, kBeam}, {0, 1, 0.2, 0.01, 20.0, kBeam}, {1, 0, 0.0, 0.01, 30.0, kBeam}};
  EXPECT_EQ(table.weight(), 50.0);
  EXPECT_EQ(table.weightOf(std::vector{&table.rows[0], &table.rows[1]}), 20.0);
  table.component = "bias";
  EXPECT_EQ(table.weight(), 70.0) << "detections are not shots";
}

/// Of normal values about a mean, as a sensor reports them in steps.
void fill(gap::CellStatistics& cell, int count, double mean, double stddev, double step, core::Random& random) {
  cell.count = count;
  cell.sum[gap::kIntensity] = cell.sum_of_squares[gap::kIntensity] = 0.0;
  for (int i = 0; i < count; ++i) {
    const double value = step * std::round((mean + stddev * random.normal()) / step);
    cell.sum[gap::kIntensity] += value;
    cell.sum_of_squares[gap::kIntensity] += value * value;
  }
}

// Noise of a fifth of a step: where the mean lies in the middle of a step all values are the same, at its end they are
// half of them one step larger. Two programs whose means are a few steps apart scatter by different amounts, and
// neither is wrong; half a step of noise and more leaves nothing of that.
TEST(ResidualTable, ScatterOfNoiseThatIsSmallAgainstAStepTellsLittle) {
  constexpr int kMeasured = 8, kSimulated = 24;
  const test_support::SmallWorld world;
  const auto model = test_support::SmallWorld::modelWith({});
  const auto experiment = world.measuredBy(model, 0.4);
  const gap::Replay replay(experiment, model);
  const double step = replay.resolution(gap::kIntensity);
  core::Random random({.seed = 11});
  for (const double stddev : {0.05, 0.1, 0.2, 0.3, 0.5, 1.0}) {
    gap::CellsOfSamples measured, simulated;
    for (const gap::ReplaySample& sample : replay.samples()) {
      for (gap::CellsOfSamples* side : {&measured, &simulated}) {
        side->push_back(sample.statistics);
        for (gap::CellStatistics& cell : side->back())
          fill(cell, side == &measured ? kMeasured : kSimulated, step * (100.0 + 10.0 * random.uniform()),
               stddev * step, step, random);
      }
    }
    const std::vector<int> frames(measured.size(), kSimulated);
    double squares = 0.0, rows = 0.0;
    for (const gap::ResidualTable& table : gap::residualTables(replay, {measured, frames, simulated, frames})) {
      if (!table.isOf("intensity", "scatter")) continue;
      rows = static_cast<double>(table.rows.size());
      for (const auto& row : table.rows) squares += std::pow(row.value / row.error, 2.0);
    }
    ASSERT_GT(rows, 500.0);
    EXPECT_LT(squares / rows, 1.25) << "of a noise of " << stddev << " steps";
    EXPECT_GT(squares / rows, 0.4) << "of a noise of " << stddev << " steps";
  }
}

}  // namespace
