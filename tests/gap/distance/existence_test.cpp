#include "gap/distance/existence.h"

#include <cmath>
#include <gtest/gtest.h>

#include "core/physics.h"

namespace gap {
namespace {

struct Echo {
  int frame;
  int layer;
  double azimuth_deg;
};

core::Detections detections(const std::vector<Echo>& echoes) {
  core::Detections all;
  for (const Echo& echo : echoes) {
    all.frame.push_back(echo.frame);
    all.layer.push_back(echo.layer);
    all.azimuth_rad.push_back(echo.azimuth_deg * core::kRadPerDeg);
    all.elevation_rad.push_back(0.0);
    all.echo.push_back(1);
    all.range_m.push_back(10.0);
  }
  return all;
}

// By hand: simulated 2 + 2 echoes in two cells over 2 frames, measured 1 + 2 there and 1 in a third cell.
TEST(ExistenceGap, CountsPerCellAndRelatesToAllSimulatedEchoes) {
  const core::Detections simulated = detections({{0, 0, 1.0}, {1, 0, 1.0}, {0, 0, 3.0}, {1, 0, 3.0}});
  const core::Detections measured = detections({{0, 0, 1.0}, {0, 0, 3.0}, {1, 0, 3.0}, {1, 1, 3.0}});
  const ExistenceGap found = existenceGap({simulated, 2}, {measured, 2});
  EXPECT_DOUBLE_EQ(found.missing, 0.25);
  EXPECT_DOUBLE_EQ(found.extra, 0.25);
}

TEST(ExistenceGap, OfEqualSidesIsZeroAlsoWithDifferentNumbersOfFrames) {
  const core::Detections two = detections({{0, 0, 1.0}, {1, 0, 1.0}});
  const core::Detections one = detections({{0, 0, 1.0}});
  EXPECT_DOUBLE_EQ(existenceGap({two, 2}, {one, 1}).missing, 0.0);
  EXPECT_DOUBLE_EQ(existenceGap({two, 2}, {one, 1}).extra, 0.0);
}

// Beams stand on full degrees; a file rounds them to a microradian. That alone must not look like missing echoes.
TEST(ExistenceGap, IsNotFooledByRoundedAngles) {
  core::Detections exact = detections({{0, 0, -4.0}, {0, 0, 0.0}, {0, 0, 2.0}, {0, 0, 4.0}});
  core::Detections rounded = exact;
  for (double& azimuth : rounded.azimuth_rad) azimuth = std::round(1e6 * azimuth) / 1e6 - 1e-12;
  const ExistenceGap found = existenceGap({exact, 1}, {rounded, 1});
  EXPECT_DOUBLE_EQ(found.missing + found.extra, 0.0);
}

TEST(ExistenceGap, IsUndefinedIfNothingWasSimulated) {
  EXPECT_TRUE(std::isnan(existenceGap({detections({}), 1}, {detections({{0, 0, 1.0}}), 1}).missing));
}

TEST(DetectionRate, CountsABeamOnceHoweverManyEchoesItHas) {
  core::Detections twice = detections({{0, 0, 1.0}, {0, 0, 1.0}, {1, 0, 1.0}});
  twice.echo = {1, 2, 2};  // the gate dropped the first echo of frame 1
  EXPECT_DOUBLE_EQ(detectionRate({twice, 4}, 2), 2.0 / 8.0);
}

TEST(DetectionRate, WithoutDirectionsCountsFirstEchoes) {
  core::Detections pooled = detections({{0, 0, 1.0}, {0, 0, 1.0}, {1, 0, 1.0}});
  pooled.echo = {1, 2, 1};
  pooled.layer.clear();
  pooled.azimuth_rad.clear();
  pooled.elevation_rad.clear();
  EXPECT_DOUBLE_EQ(detectionRate({pooled, 4}, 1), 0.5);
}

}  // namespace
}  // namespace gap
