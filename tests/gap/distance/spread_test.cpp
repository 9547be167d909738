#include "gap/distance/spread.h"

#include <gtest/gtest.h>
#include <numeric>

#include "gap/causes/split.h"
#include "tests/gap/small_world.h"

namespace {

using test_support::SmallWorld;

/// Detections at ± `deviation_m`, as many above as below.
gap::CellStatistics scattering(double deviation_m, int pairs) {
  gap::CellStatistics cell;
  for (int i = 0; i < pairs; ++i) {
    for (const double value : {-deviation_m, deviation_m}) {
      cell.count += 1.0;
      cell.sum[gap::kRange] += value;
      cell.sum_of_squares[gap::kRange] += value * value;
    }
  }
  return cell;
}

struct Cells {
  std::vector<gap::CellStatistics> measured, simulated;

  [[nodiscard]] std::vector<gap::GroupSpread> spreads(double prior_m2) const {
    std::vector<std::size_t> cells(measured.size());
    std::iota(cells.begin(), cells.end(), std::size_t{0});
    return gap::spreadsOf(cells, {.measured = measured, .simulated = simulated}, gap::kRange, prior_m2);
  }
};

TEST(Spread, OneForeignPulseMergedWithAnEchoDoesNotDrownTheScatterOfAllOthers) {
  const double deviation_m = 0.01, usual_m2 = deviation_m * deviation_m;
  Cells cells{std::vector(60, scattering(deviation_m, 8)), std::vector(60, scattering(deviation_m, 8))};
  EXPECT_DOUBLE_EQ(gap::spreadDiscrepancy(cells.spreads(usual_m2), usual_m2), 0.0);
  cells.measured[5] = scattering(10.0, 8);
  const auto groups = cells.spreads(usual_m2);
  ASSERT_EQ(groups.size(), 6U);
  EXPECT_LT(groups[0].measured.variance, 2.5 * usual_m2);  // nine with the usual one, one with ten times as much
  EXPECT_NEAR(groups[1].measured.variance, usual_m2, 0.1 * usual_m2);
  // All of them with three times the variance are a difference.
  cells.measured = std::vector(60, scattering(std::sqrt(3.0) * deviation_m, 8));
  EXPECT_GT(gap::spreadDiscrepancy(cells.spreads(usual_m2), usual_m2), 20.0);
}

TEST(Spread, OfACellWithOneDetectionIsThatOfItsGroup) {
  Cells cells{std::vector(60, scattering(0.02, 8)), std::vector(60, scattering(0.02, 8))};
  const gap::PooledSpread group = cells.spreads(1e-6)[0].measured;
  gap::CellStatistics one;
  one.count = 1.0;
  const double variance = gap::varianceIn(group, one, gap::kRange, 1e-6);
  EXPECT_NEAR(variance, 4e-4, 0.15 * 4e-4);
  // Where a group tells nothing the profile does.
  EXPECT_DOUBLE_EQ(gap::varianceIn({}, one, gap::kRange, 1e-6), 1e-6);
}

// The truth scatters more than the profile states. Three simulated frames of a world that does so, too, have noisier
// means than three of one that does not: it must not pay for that.
TEST(Spread, AWorldThatIsRightToScatterMoreIsNearerFromThreeFramesOn) {
  const double recorded_m =
      SmallWorld::modelWith({}).json.at("/sensor/detection/epw_noise_m"_json_pointer).get<double>();
  const double true_m = 1.1 * recorded_m;
  const SmallWorld world;
  const model::Experiment measured =
      world.measuredBy(SmallWorld::modelWith({}, {{"/sensor/detection/epw_noise_m", true_m}}), 0.4);
  const gap::Replay replay(measured, SmallWorld::modelWith({}));
  gap::Evidence few = gap::splitOf(replay, 1).fitted;
  few.most_frames = 3;
  gap::World scatters = replay.baseline();
  scatters.model = SmallWorld::modelWith({}, {{"/sensor/detection/epw_noise_m", true_m}});
  EXPECT_LT(gap::discrepancyOf(replay, scatters, few), gap::discrepancyOf(replay, replay.baseline(), few));
}

}  // namespace
