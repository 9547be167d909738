#include "model/sensor/beam_finder.h"

#include <cmath>
#include <gtest/gtest.h>

#include "core/physics.h"

namespace model {
namespace {

constexpr double kHalfLeft_rad = 0.0015, kHalfUp_rad = 0.006;

/// Overlapping beams all around and up to the zenith, where azimuths lose their meaning.
std::vector<Beam> manyBeams() {
  std::vector<Beam> beams;
  for (int layer = 0; layer < 19; ++layer) {
    for (int k = 0; k < 360; ++k) {
      beams.push_back({.layer = layer,
                       .column = k,
                       .azimuth_rad = (k - 180) * core::kRadPerDeg,
                       .elevation_rad = (5.0 * layer - 1.0) * core::kRadPerDeg});
    }
  }
  beams.push_back(beams[7 * 360 + 40]);
  beams.back().azimuth_rad += kHalfLeft_rad;
  return beams;
}

// Whatever lies inside a beam is found in it, or in one whose axis is nearer; what lies outside is in none.
TEST(BeamFinder, FindsTheBeamThatADirectionWasMadeFrom) {
  const std::vector<Beam> beams = manyBeams();
  const BeamFinder finder(beams, kHalfLeft_rad, kHalfUp_rad);
  for (std::uint32_t b = 0; b < beams.size(); ++b) {
    const double left = kHalfLeft_rad * std::sin(b), up = kHalfUp_rad * std::cos(1.7 * b);
    const auto place = finder.find(directionOf(beams[b], left, up));
    ASSERT_TRUE(place) << b;
    if (place->beam != b) {
      EXPECT_LE(std::hypot(place->left_rad, place->up_rad), std::hypot(left, up)) << b;
      continue;
    }
    EXPECT_NEAR(place->left_rad, left, 1e-12);
    EXPECT_NEAR(place->up_rad, up, 1e-12);
  }
}

TEST(BeamFinder, FindsNothingBesideABeam) {
  const std::vector<Beam> beams{{.azimuth_rad = 0.3, .elevation_rad = -0.1}};
  const BeamFinder finder(beams, kHalfLeft_rad, kHalfUp_rad);
  EXPECT_TRUE(finder.find(directionOf(beams[0], kHalfLeft_rad, kHalfUp_rad)));
  EXPECT_FALSE(finder.find(directionOf(beams[0], kHalfLeft_rad + 1e-4, 0.0)));
  EXPECT_FALSE(finder.find(directionOf(beams[0], 0.0, -kHalfUp_rad - 1e-4)));
  const Vector3 ahead = directionOf(beams[0], 0.0, 0.0);
  EXPECT_FALSE(finder.find({-ahead[0], -ahead[1], -ahead[2]}));
}

TEST(BeamFinder, NearestAxisCountsWhereBeamsOverlap) {
  const std::vector<Beam> beams{{.azimuth_rad = 0.0}, {.azimuth_rad = 0.002}};
  const BeamFinder finder(beams, kHalfLeft_rad, kHalfUp_rad);
  EXPECT_EQ(finder.find(directionOf(beams[0], 0.0009, 0.0))->beam, 0u);
  EXPECT_EQ(finder.find(directionOf(beams[0], 0.0011, 0.0))->beam, 1u);
}

}  // namespace
}  // namespace model
