#include "app/desktop/cloud/point_cloud.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "app/desktop/cloud/colour_scale.h"
#include "app/desktop/cloud/readout.h"
#include "app/desktop/colours.h"

namespace {

using desktop::ColourBy;
using desktop::pointCloudOf;

constexpr double kQuarter = std::numbers::pi / 2;

core::Detections three() {
  return {.frame = {0, 1, 1},
          .layer = {0, 0, 1},
          .azimuth_rad = {0.0, 0.01, kQuarter},
          .elevation_rad = {0.0, 0.0, kQuarter / 3},
          .echo = {1, 1, 2},
          .range_m = {10.0, 20.0, 4.0}};
}

// ISO 8855: azimuth to the left, elevation up. cos 30 = sqrt(3)/2, sin 30 = 1/2.
TEST(PointCloud, PlacesFollowFromRangeAndDirection) {
  const auto cloud = pointCloudOf(three());
  EXPECT_NEAR(cloud.x[0], 10.0, 1e-6);
  EXPECT_NEAR(cloud.x[2], 0.0, 1e-6);
  EXPECT_NEAR(cloud.y[2], 2.0 * std::sqrt(3.0), 1e-6);
  EXPECT_NEAR(cloud.z[2], 2.0, 1e-6);
  EXPECT_EQ(cloud.frames(), 2);
}

TEST(PointCloud, OutlineHoldsTheExtremesAndTheSensor) {
  core::Detections all{.frame = {}, .layer = {}, .azimuth_rad = {}, .elevation_rad = {}, .echo = {}, .range_m = {}};
  for (int k = 0; k < 1000; ++k) {  // one of them far out
    all.frame.push_back(0);
    all.layer.push_back(0);
    all.azimuth_rad.push_back(0.006 * k);
    all.elevation_rad.push_back(0.0);
    all.echo.push_back(1);
    all.range_m.push_back(k == 321 ? 90.0 : 10.0);
  }
  const auto outline = pointCloudOf(all).outline;
  const auto distance = [](const desktop::Point3& p) { return std::hypot(p.x, p.y, p.z); };
  EXPECT_TRUE(std::ranges::any_of(outline, [&](const auto& p) { return std::abs(distance(p) - 90.0) < 1e-4; }));
  EXPECT_TRUE(std::ranges::any_of(outline, [&](const auto& p) { return distance(p) == 0.0; }));
}

TEST(PointCloud, WithoutDirectionsThereAreNoPlaces) {
  const auto cloud = pointCloudOf({.frame = {0}, .echo = {1}, .range_m = {3.0}});
  EXPECT_EQ(cloud.size(), 0u);
  EXPECT_EQ(cloud.detections.size(), 1u);
}

// Two beams of layer 0 at 0 and 10 mrad, and the picked one at 4 mrad: nearer to the first.
TEST(PointCloud, SameBeamIsTheNearestOfTheLayerWithTheSameEcho) {
  core::Detections other{.frame = {0, 1, 0, 0, 0},
                         .layer = {0, 0, 0, 1, 0},
                         .azimuth_rad = {0.0, 0.000001, 0.010, 0.004, 0.0},
                         .elevation_rad = {0, 0, 0, 0, 0},
                         .echo = {1, 1, 1, 1, 2},
                         .range_m = {10.0, 10.5, 20.0, 30.0, 40.0},
                         .epw_m = {1.0, 2.0, 9.0, 9.0, 9.0}};
  core::Detections picked{
      .frame = {0}, .layer = {0}, .azimuth_rad = {0.004}, .elevation_rad = {0}, .echo = {1}, .range_m = {11.0}};
  const auto own = pointCloudOf(picked);
  const auto found = desktop::sameBeam(pointCloudOf(other), own, 0);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->count, 2u);
  EXPECT_DOUBLE_EQ(found->range_m, 10.25);
  EXPECT_DOUBLE_EQ(*found->epw_m, 1.5);
  EXPECT_FALSE(found->intensity_nw);
  picked.azimuth_rad = {0.1};  // more than half a degree from all
  EXPECT_FALSE(desktop::sameBeam(pointCloudOf(other), pointCloudOf(picked), 0));
}

// 180 degrees to the left is 180 degrees to the right: one beam, whichever sign a file writes.
TEST(PointCloud, SameBeamIsFoundAcrossTheSeamBehindTheSensor) {
  const double behind = std::numbers::pi - 1e-6;
  core::Detections left{
      .frame = {0}, .layer = {0}, .azimuth_rad = {behind}, .elevation_rad = {0}, .echo = {1}, .range_m = {5.0}};
  core::Detections right = left;
  right.azimuth_rad = {-behind};
  right.range_m = {5.5};
  const auto found = desktop::sameBeam(pointCloudOf(right), pointCloudOf(left), 0);
  ASSERT_TRUE(found);
  EXPECT_DOUBLE_EQ(found->range_m, 5.5);
  EXPECT_DOUBLE_EQ(desktop::rangeDifferences(pointCloudOf(left), pointCloudOf(right)).at(0), 0.5);
}

// A file that knows no layers: the azimuth alone tells.
TEST(PointCloud, WithoutLayersTheAzimuthTellsTheBeam) {
  const core::Detections no_layer{
      .frame = {0, 0}, .azimuth_rad = {0.0, 0.1}, .elevation_rad = {0, 0}, .echo = {1, 1}, .range_m = {5.0, 7.0}};
  const auto found = desktop::sameBeam(pointCloudOf(no_layer), pointCloudOf(three()), 0);
  ASSERT_TRUE(found);
  EXPECT_DOUBLE_EQ(found->range_m, 5.0);
}

// The differences are those of sameBeam, which looks at every detection: same mates, same means.
TEST(PointCloud, RangeDifferencesAreThoseOfTheSameBeams) {
  core::Detections all{.frame = {}, .layer = {}, .azimuth_rad = {}, .elevation_rad = {}, .echo = {}, .range_m = {}};
  for (int k = 0; k < 400; ++k) {
    all.frame.push_back(k % 3);
    all.layer.push_back(k % 4);
    all.azimuth_rad.push_back(std::remainder(0.05 * (k / 8), 2.0 * std::numbers::pi));
    all.elevation_rad.push_back(0.0);
    all.echo.push_back(1 + k % 2);
    all.range_m.push_back(10.0 + 0.37 * (k % 11));
  }
  core::Detections other = all;
  for (std::size_t i = 0; i < other.size(); ++i) {
    other.azimuth_rad[i] += 0.003;
    other.range_m[i] += 0.01 * static_cast<double>(i % 7);
    if (i % 5 == 0) other.layer[i] = 9;
  }
  const auto own = pointCloudOf(all);
  const auto there = pointCloudOf(other);
  const auto differences = desktop::rangeDifferences(own, there);
  ASSERT_EQ(differences.size(), own.size());
  for (std::size_t i = 0; i < own.size(); ++i) {
    const auto mate = desktop::sameBeam(there, own, i);
    ASSERT_EQ(mate.has_value(), !std::isnan(differences[i])) << i;
    if (mate) {
      EXPECT_NEAR(differences[i], mate->range_m - all.range_m[i], 1e-12) << i;
    }
  }
}

TEST(ColourScale, DifferencesAreSymmetricAndAWildOneDoesNotFlattenTheRest) {
  std::vector<double> values(200, 0.1);
  values[7] = -50.0;
  values[8] = std::nan("");
  const auto scale = desktop::scaleFor(ColourBy::Difference, std::span(&values, 1));
  EXPECT_DOUBLE_EQ(scale.high, 0.1);
  EXPECT_DOUBLE_EQ(scale.low, -0.1);
  EXPECT_DOUBLE_EQ(scale.shareOf(0.0), 0.5);
  EXPECT_NE(scale(std::nan("")), scale(0.0));
  EXPECT_FALSE(desktop::scaleFor(ColourBy::Difference, {}).known);
}

TEST(Readout, IsTextWithATabBetweenNameAndValue) {
  const auto part = desktop::partOf(pointCloudOf(three()), desktop::CloudSource::Measured, 1, "wall");
  const QString text = desktop::toText({part});
  EXPECT_TRUE(text.startsWith("Measured detection\n"));
  EXPECT_TRUE(text.contains("Sample\twall\n"));
  EXPECT_TRUE(text.contains("Range\t20.000 m\n"));
}

TEST(ColourScale, BrightnessRisesAllTheWayAndStandsOutFromTheCanvas) {
  const QColor canvas(0x12, 0x15, 0x1a);
  double before = 0.0;
  for (int k = 0; k <= 20; ++k) {
    const double now = desktop::contrast(desktop::rampColour(k / 20.0), canvas);
    EXPECT_GT(now, before);
    before = now;
  }
  EXPECT_GT(desktop::contrast(desktop::rampColour(0.0), canvas), 3.0);
}

TEST(ColourScale, TicksAreRoundAndInside) {
  const std::vector<double> ranges{3.2, 47.0};
  const auto scale = desktop::scaleFor(ColourBy::Range, std::span(&ranges, 1));
  EXPECT_EQ(scale.ticks(), (std::vector<double>{10, 20, 30, 40}));
  EXPECT_DOUBLE_EQ(scale.shareOf(47.0), 1.0);
  const std::vector<double> layers{0, 3};
  EXPECT_EQ(desktop::scaleFor(ColourBy::Layer, std::span(&layers, 1)).ticks(), (std::vector<double>{0, 1, 2, 3}));
}

TEST(ColourScale, IntensitiesOverDecadesAreLogarithmic) {
  const std::vector<double> intensities{1.0, 10.0, 10000.0};
  const auto scale = desktop::scaleFor(ColourBy::Intensity, std::span(&intensities, 1));
  EXPECT_TRUE(scale.logarithmic);
  EXPECT_NEAR(scale.shareOf(100.0), 0.5, 1e-12);
  const std::vector<double> same{7.0, 7.0};
  EXPECT_EQ(desktop::scaleFor(ColourBy::Range, std::span(&same, 1)).shareOf(7.0), 0.5);
}

}  // namespace
