#include "model/sensor/beams.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numeric>

#include "core/physics.h"
#include "tests/model/lab.h"
#include "tests/support/paths.h"

namespace model {
namespace {

Scan scanOf(double from_deg, double to_deg, double step_deg, bool left_to_right) {
  return {.frame_rate_hz = 12.5,
          .duty = 0.4,
          .left_to_right = left_to_right,
          .layers = {{0.0, from_deg, to_deg, step_deg}}};
}

TEST(Beams, BothEndsOfTheScanAreIncluded) {
  const auto beams = beamsOf(scanOf(50, -50, 0.25, true));
  ASSERT_EQ(beams.size(), 401u);
  EXPECT_NEAR(beams.front().azimuth_rad, 50 * core::kRadPerDeg, 1e-12);
  EXPECT_NEAR(beams.back().azimuth_rad, -50 * core::kRadPerDeg, 1e-12);
}

TEST(Beams, AnEndThatTheStepMissesIsLeftOut) {
  EXPECT_EQ(beamsOf(scanOf(0, 1, 0.3, true)).size(), 4u);    // 0, 0.3, 0.6, 0.9
  EXPECT_EQ(beamsOf(scanOf(0, 0.9, 0.3, true)).size(), 4u);  // 0.9 / 0.3 is 2.999… in binary
  EXPECT_EQ(beamsOf(scanOf(5, 5, 0.3, true)).size(), 1u);
}

// t = k/n · duty / frame_rate for the k-th beam fired; left-to-right means falling azimuth, however `from` and `to`
// stand.
TEST(Beams, DirectionAloneDecidesTheOrderOfFiring) {
  for (const bool falling : {true, false}) {
    for (const auto& [from, to] : {std::pair{10.0, -10.0}, std::pair{-10.0, 10.0}}) {
      const auto beams = beamsOf(scanOf(from, to, 5, falling));
      ASSERT_EQ(beams.size(), 5u);
      for (const Beam& beam : beams) {
        const double left = (10.0 - beam.azimuth_rad * core::kDegPerRad) / 5.0;  // 0 at the left end
        const double k = falling ? left : 4.0 - left;
        EXPECT_NEAR(beam.time_s, k / 5.0 * 0.4 / 12.5, 1e-12);
      }
    }
  }
}

TEST(Beams, LayersOfAnAzimuthAreFiredTogether) {
  Scan scan = scanOf(2, -2, 1, true);
  scan.layers.push_back(scan.layers[0]);
  scan.layers[1].elevation_deg = 0.8;
  const auto beams = beamsOf(scan);
  ASSERT_EQ(beams.size(), 10u);
  for (std::size_t c = 0; c < 5; ++c) {
    EXPECT_EQ(beams[c].time_s, beams[c + 5].time_s);
    EXPECT_EQ(beams[c + 5].layer, 1);
    EXPECT_NEAR(beams[c + 5].elevation_rad, 0.8 * core::kRadPerDeg, 1e-15);
  }
}

TEST(Beams, OwnDirectionsAreReadPointByPoint) {
  const test_support::TemporaryFolder folder;
  const auto beams =
      readBeams(folder.write("b.csv", "layer,azimuth_rad,elevation_rad,time_s\n0,0.1,-0.02,0\n2,-0.1,0.03,0.004\n"));
  ASSERT_EQ(beams.size(), 2u);
  EXPECT_EQ(beams[1].layer, 2);
  EXPECT_EQ(beams[1].azimuth_rad, -0.1);
  EXPECT_EQ(beams[1].elevation_rad, 0.03);
  EXPECT_EQ(beams[1].time_s, 0.004);
  EXPECT_EQ(readBeams(folder.write("no_time.csv", "layer,azimuth_rad,elevation_rad\n0,0,0\n"))[0].time_s, 0.0);
}

TEST(Beams, FaultyDirectionsNameFileAndLine) {
  const test_support::TemporaryFolder folder;
  const auto bad = folder.write("bad.csv", "layer,azimuth_rad,elevation_rad\n0,0,0\n0.5,0,0\n");
  EXPECT_NE(lab::refusal([&] { (void)readBeams(bad); }).find("bad.csv:3"), std::string::npos);
  const auto empty = folder.write("empty.csv", "layer,azimuth_rad,elevation_rad\n");
  EXPECT_NE(lab::refusal([&] { (void)readBeams(empty); }).find("lists no beam"), std::string::npos);
  const auto lacking = folder.write("lacking.csv", "layer,azimuth_rad,elevaton_rad\n0,0,0\n");
  EXPECT_NE(lab::refusal([&] { (void)readBeams(lacking); }).find("elevation_rad"), std::string::npos);
}

TEST(SubRays, UniformGridHasEqualWeightsAtCellCentres) {
  const SubRays rays = subRaysOf(BeamProfile::kUniform, {0.004, 0.010}, 2, 5);
  ASSERT_EQ(rays.weight.size(), 10u);
  for (const double weight : rays.weight) EXPECT_NEAR(weight, 0.1, 1e-15);
  EXPECT_NEAR(*std::min_element(rays.left_rad.begin(), rays.left_rad.end()), -0.001, 1e-15);  // half a cell inside
  EXPECT_NEAR(*std::max_element(rays.left_rad.begin(), rays.left_rad.end()), 0.001, 1e-15);
  EXPECT_NEAR(*std::max_element(rays.up_rad.begin(), rays.up_rad.end()), 0.004, 1e-15);
}

// w ∝ exp(-2 (x²/a² + y²/b²)) over ±1.5 a by ±1.5 b, a and b half the 1/e² full widths.
TEST(SubRays, GaussianWeightsFollowTheProfileOverOneAndAHalfWidths) {
  const double a = 0.002, b = 0.001;
  const SubRays rays = subRaysOf(BeamProfile::kGaussian, {2 * a, 2 * b}, 9, 7);
  EXPECT_NEAR(std::accumulate(rays.weight.begin(), rays.weight.end(), 0.0), 1.0, 1e-12);
  EXPECT_NEAR(*std::max_element(rays.left_rad.begin(), rays.left_rad.end()), 1.5 * a * 8.0 / 9.0, 1e-15);
  EXPECT_NEAR(*std::max_element(rays.up_rad.begin(), rays.up_rad.end()), 1.5 * b * 6.0 / 7.0, 1e-15);
  const std::size_t centre = 3 * 9 + 4;
  ASSERT_NEAR(rays.left_rad[centre], 0.0, 1e-15);
  for (std::size_t i = 0; i < rays.weight.size(); ++i) {
    const double x = rays.left_rad[i] / a, y = rays.up_rad[i] / b;
    EXPECT_NEAR(rays.weight[i] / rays.weight[centre], std::exp(-2.0 * (x * x + y * y)), 1e-12);
  }
}

TEST(SubRays, WithoutDivergenceTheBeamIsItsCentralRay) {
  const SubRays rays = subRaysOf(BeamProfile::kGaussian, {0.0, 0.0}, 9, 9);
  ASSERT_EQ(rays.weight.size(), 1u);
  EXPECT_EQ(rays.left_rad[0], 0.0);
  EXPECT_EQ(rays.weight[0], 1.0);
  EXPECT_EQ(subRaysOf(BeamProfile::kUniform, {0.0, 0.01}, 9, 3).weight.size(), 3u);
}

}  // namespace
}  // namespace model
