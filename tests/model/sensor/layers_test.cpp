#include "model/sensor/layers.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "core/physics.h"

namespace model {
namespace {

Beam beam(std::int32_t layer, double azimuth_rad, double elevation_rad) {
  return {.layer = layer, .azimuth_rad = azimuth_rad, .elevation_rad = elevation_rad};
}

/// The layer of the nearest of all beams, by the angle from the scalar product: slow and independent.
std::int32_t byScalarProduct(double azimuth_rad, double elevation_rad, const std::vector<Beam>& beams) {
  const auto along = [&](const Beam& b) {
    return std::cos(elevation_rad) * std::cos(b.elevation_rad) * std::cos(azimuth_rad - b.azimuth_rad) +
           std::sin(elevation_rad) * std::sin(b.elevation_rad);
  };
  const Beam* nearest = beams.data();
  for (const Beam& b : beams) {
    if (along(b) > along(*nearest)) nearest = &b;
  }
  return nearest->layer;
}

TEST(AddLayers, EveryDetectionGetsTheLayerOfTheNearestBeam) {
  std::vector<Beam> beams;  // layers that bend: their elevation depends on the azimuth
  for (int layer = 0; layer < 5; ++layer) {
    for (int k = 0; k < 360; ++k) {
      const double azimuth_rad = (k - 180) * core::kRadPerDeg;
      beams.push_back(beam(layer, azimuth_rad, (3.0 * layer - 6.0 + std::sin(azimuth_rad)) * core::kRadPerDeg));
    }
  }
  core::Detections detections;
  for (int i = 0; i < 2000; ++i) {
    detections.azimuth_rad.push_back(std::remainder(0.7371 * i, 2.0 * std::numbers::pi));
    detections.elevation_rad.push_back(0.12 * std::sin(1.3 * i));
    detections.range_m.push_back(10.0);
  }
  addLayers(detections, beams);
  ASSERT_EQ(detections.layer.size(), detections.size());
  for (std::size_t i = 0; i < detections.size(); ++i) {
    EXPECT_EQ(detections.layer[i], byScalarProduct(detections.azimuth_rad[i], detections.elevation_rad[i], beams)) << i;
  }
}

TEST(AddLayers, RecordedLayersAndMissingDirectionsStay) {
  core::Detections recorded{.layer = {3}, .azimuth_rad = {0}, .elevation_rad = {0}, .range_m = {1}};
  addLayers(recorded, std::vector<Beam>{beam(0, 0, 0)});
  EXPECT_EQ(recorded.layer, std::vector<std::int32_t>{3});
  core::Detections ranges{.range_m = {1}};
  addLayers(ranges, std::vector<Beam>{beam(0, 0, 0)});
  EXPECT_TRUE(ranges.layer.empty());
}

}  // namespace
}  // namespace model
