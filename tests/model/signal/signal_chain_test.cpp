#include "model/signal/signal_chain.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "tests/model/lab.h"

namespace model {
namespace {

using lab::Case;
using lab::epwLaw;
using lab::fire;
using lab::radarEquation;

Case wallAt(double range_m, double reflectivity = 0.5) {
  Case setup;
  setup.scene = {lab::board(range_m)};
  setup.materials["grey"]["reflectivity"] = reflectivity;
  return setup;
}

TEST(SignalChain, WallReturnsThePowerOfTheRadarEquation) {
  for (const double range : {5.0, 10.0, 50.0, 200.0}) {
    EXPECT_NEAR(lab::power_w(wallAt(range)) / radarEquation(range), 1.0, 1e-6);
  }
  Case slanted = wallAt(20);
  slanted.scene[0]["pose"]["yaw_pitch_roll_deg"] = {60, 0, 0};
  EXPECT_NEAR(lab::power_w(slanted) / radarEquation(20, 0.5, 0.5), 1.0, 1e-6);
}

// EPW = c · FWHM · sqrt(log2(P/P_th)): the check that formats.md asks of every implementation.
TEST(SignalChain, EchoPulseWidthOfAFlatTargetIsTheClosedForm) {
  for (const double range : {5.0, 20.0, 60.0, 120.0, 180.0}) {
    const auto detections = fire(wallAt(range));
    const double power_w = radarEquation(range);
    ASSERT_EQ(detections.size(), power_w > lab::kThreshold_w ? 1u : 0u) << range;
    if (detections.size() == 0) continue;
    EXPECT_NEAR(detections.epw_m[0], epwLaw(power_w), 1e-5) << range;
    EXPECT_NEAR(detections.range_m[0], range, 1e-5) << range;
    EXPECT_NEAR(detections.intensity[0], 1e9 * power_w, 1e-3 * power_w * 1e9) << range;
  }
}

TEST(SignalChain, RangeModesAreEdgePeakAndMiddle) {
  Case setup = wallAt(30);
  const double half = epwLaw(radarEquation(30)) / 4.0;  // EPW counts the way there and back
  setup.sensor["detection"]["range_mode"] = "leading-edge";
  EXPECT_NEAR(fire(setup).range_m.at(0), 30 - half, 1e-5);
  setup.sensor["detection"]["range_mode"] = "centre";
  EXPECT_NEAR(fire(setup).range_m.at(0), 30, 1e-5);
}

// P ∝ r⁻²: everything that the beam sends meets the wall.
double exponentBetween(const Case& near, double near_m, const Case& far, double far_m) {
  return std::log(lab::power_w(far) / lab::power_w(near)) / std::log(far_m / near_m);
}

Case target(double range_m, double width_m, double height_m) {
  Case setup;
  setup.effects["beam-divergence"] = {{"horizontal_rad", 0.02}, {"vertical_rad", 0.02}};
  setup.rays_per_beam = {401, 401};
  setup.scene = {
      lab::object("t", {{"type", "rectangle"}, {"width_m", width_m}, {"height_m", height_m}}, {range_m, 0, 0})};
  return setup;
}

TEST(SignalChain, WallFallsWithTheSquareOfTheRange) {
  EXPECT_NEAR(exponentBetween(target(10, 20, 20), 10, target(40, 20, 20), 40), -2.0, 1e-3);
}

// A strip narrower than the beam takes the share b / (φ r) of it. Sub-rays count in whole columns: widths and ranges
// are chosen so that the strip's edges fall between two columns (b/(φ r) = odd/401).
TEST(SignalChain, WireFallsWithTheThirdPower) {
  const double width = 101.0 / 401.0 * 2.0 * std::tan(0.01) * 10.0;
  EXPECT_NEAR(exponentBetween(target(10, width, 20), 10, target(10 * 101.0 / 25.0, width, 20), 10 * 101.0 / 25.0), -3.0,
              2e-3);
}

TEST(SignalChain, SmallTargetFallsWithTheFourthPower) {
  const double width = 101.0 / 401.0 * 2.0 * std::tan(0.01) * 10.0;
  EXPECT_NEAR(exponentBetween(target(10, width, width), 10, target(10 * 101.0 / 25.0, width, width), 10 * 101.0 / 25.0),
              -4.0, 4e-3);
}

// Absolute: a disc of area A in a uniform beam of φ × ψ takes A / (φ r · ψ r). A sphere of radius a seen from afar
// returns per projected area the mean of cos θ over its disc: 2/3.
TEST(SignalChain, SmallSphereReturnsTwoThirdsOfADiscsPower) {
  Case setup = target(30, 1, 1);
  setup.scene = {lab::object("ball", {{"type", "sphere"}, {"radius_m", 0.1}}, {30, 0, 0})};
  const double share = M_PI * 0.01 / std::pow(2.0 * std::tan(0.01) * 30.0, 2);
  EXPECT_NEAR(lab::power_w(setup) / (radarEquation(30) * share * 2.0 / 3.0), 1.0, 0.01);
}

// A wire is a thin cylinder: per projected width the mean of cos θ across is π/4.
TEST(SignalChain, ThinCylinderReturnsAQuarterOfPiOfAStripsPower) {
  Case setup = target(10, 1, 1);
  setup.scene = {lab::object("wire", {{"type", "cylinder"}, {"radius_m", 0.02}, {"height_m", 5}}, {10, 0, 0})};
  const double share = 0.04 / (2.0 * std::tan(0.01) * 10.0);
  EXPECT_NEAR(lab::power_w(setup) / (radarEquation(10) * share * M_PI / 4.0), 1.0, 0.02);
}

/// The beam's left half meets the first board, all the rest the second.
Case twoBoards(double first_m, double second_m) {
  Case setup;
  setup.effects["beam-divergence"] = nlohmann::json::object();
  setup.rays_per_beam = {10, 3};
  setup.scene = {lab::object("near", {{"type", "rectangle"}, {"width_m", 2}, {"height_m", 2}}, {first_m, 1.0, 0}),
                 lab::board(second_m)};
  return setup;
}

TEST(SignalChain, TwoSurfacesInOneBeamAreTwoEchoes) {
  const auto detections = fire(twoBoards(10, 15));
  ASSERT_EQ(detections.size(), 2u);
  EXPECT_EQ(detections.echo, (std::vector<std::int32_t>{1, 2}));
  EXPECT_NEAR(detections.range_m[0], 10, 1e-4);
  EXPECT_NEAR(detections.range_m[1], 15, 1e-4);
  EXPECT_NEAR(detections.intensity[0], 0.5e9 * radarEquation(10), 1.0);
  EXPECT_NEAR(detections.intensity[1], 0.5e9 * radarEquation(15), 1.0);
}

// Peaks closer than the separation are one echo from the first rise to the last fall, at the highest peak.
TEST(SignalChain, SurfacesCloserThanTheSeparationAreOneEcho) {
  Case setup = twoBoards(10, 15);
  setup.sensor["detection"]["echo_separation_m"] = 5.01;
  const auto merged = fire(setup);
  ASSERT_EQ(merged.size(), 1u);
  EXPECT_NEAR(merged.range_m[0], 10, 1e-4);
  EXPECT_NEAR(merged.intensity[0], 0.5e9 * radarEquation(10), 1.0);
  EXPECT_NEAR(merged.epw_m[0], 2 * 5.0 + epwLaw(0.5 * radarEquation(10)) / 2 + epwLaw(0.5 * radarEquation(15)) / 2,
              1e-4);
  setup.sensor["detection"]["echo_separation_m"] = 4.99;
  EXPECT_EQ(fire(setup).size(), 2u);
}

// Each is compared with the one before it: 10, 14, 18 m are one echo with a separation of 5 m, though 18 - 10 > 5.
TEST(SignalChain, MergingGoesFromEachEchoToTheNext) {
  Case setup;
  setup.effects["beam-divergence"] = nlohmann::json::object();
  setup.rays_per_beam = {3, 1};
  setup.sensor["detection"]["echo_separation_m"] = 5.0;
  setup.materials["dark"] = {{"reflectivity", 0.1}};
  setup.scene = {
      lab::object("a", {{"type", "rectangle"}, {"width_m", 2}, {"height_m", 2}}, {10, 1.005, 0}, {0, 0, 0}, "dark"),
      lab::object("b", {{"type", "rectangle"}, {"width_m", 2}, {"height_m", 2}}, {14, 0.993, 0}), lab::board(18)};
  const auto merged = fire(setup);
  ASSERT_EQ(merged.size(), 1u);
  EXPECT_NEAR(merged.range_m[0], 14, 1e-4);  // the highest peak
  setup.sensor["detection"]["echo_separation_m"] = 3.9;
  EXPECT_EQ(fire(setup).size(), 3u);
}

TEST(SignalChain, OnlyTheFirstEchoesAreReported) {
  Case setup = twoBoards(10, 15);
  setup.sensor["detection"]["max_echoes"] = 1;
  const auto detections = fire(setup);
  ASSERT_EQ(detections.size(), 1u);
  EXPECT_NEAR(detections.range_m[0], 10, 1e-4);
}

TEST(SignalChain, EchoesOutsideTheRangeAreDroppedBeforeTheyCount) {
  Case setup = twoBoards(10, 15);
  setup.sensor["detection"]["max_echoes"] = 1;
  setup.sensor["detection"]["min_range_m"] = 12;
  const auto far = fire(setup);
  ASSERT_EQ(far.size(), 1u);
  EXPECT_EQ(far.echo[0], 1);
  EXPECT_NEAR(far.range_m[0], 15, 1e-4);
  setup.sensor["detection"]["min_range_m"] = 0.1;
  setup.sensor["detection"]["max_range_m"] = 12;
  EXPECT_EQ(fire(setup).size(), 1u);
  setup.sensor["detection"]["max_range_m"] = 9;
  EXPECT_EQ(fire(setup).size(), 0u);
}

TEST(SignalChain, OutputsAreRoundedToTheirSteps) {
  Case setup = wallAt(20.0037);
  setup.sensor["detection"]["range_resolution_m"] = 0.01;
  setup.sensor["detection"]["epw_resolution_m"] = 0.04;
  setup.sensor["detection"]["intensity_resolution"] = 25;
  const auto detections = fire(setup);
  ASSERT_EQ(detections.size(), 1u);
  EXPECT_NEAR(detections.range_m[0], 20.00, 1e-9);
  const double power_w = radarEquation(20.0037);
  EXPECT_NEAR(detections.epw_m[0], 0.04 * std::round(epwLaw(power_w) / 0.04), 1e-9);
  EXPECT_NEAR(detections.intensity[0], 25.0 * std::round(1e9 * power_w / 25.0), 1e-6);
}

// n = 20 000: a standard deviation is known to 1/sqrt(2n) = 0.5 %, a mean to σ/sqrt(n). Four standard errors.
TEST(SignalChain, RangeAndWidthScatterAsTheProfileSays) {
  Case setup = wallAt(20);
  setup.frames = 20000;
  setup.sensor["detection"]["range_noise_m"] = 0.012;
  setup.sensor["detection"]["epw_noise_m"] = 0.05;
  const auto detections = fire(setup);
  ASSERT_EQ(detections.size(), 20000u);
  EXPECT_NEAR(lab::deviation(detections.range_m) / 0.012, 1.0, 4 * 0.005);
  EXPECT_NEAR(lab::deviation(detections.epw_m) / 0.05, 1.0, 4 * 0.005);
  EXPECT_NEAR(lab::mean(detections.range_m), 20.0, 4 * 0.012 / std::sqrt(20000.0));
  EXPECT_NEAR(lab::mean(detections.epw_m), epwLaw(radarEquation(20)), 4 * 0.05 / std::sqrt(20000.0));
}

// P(detected) = P(n > P_th - P) = Φ((P - P_th)/σ): a binomial proportion, four standard errors.
TEST(SignalChain, DetectionRateNearTheThresholdIsTheNormalDistribution) {
  for (const double z : {-1.5, -0.5, 0.0, 1.0}) {
    const double noise_w = 2e-9, power_w = lab::kThreshold_w + z * noise_w;
    const double range = 10.0 * std::sqrt(radarEquation(10) / power_w);
    Case setup = wallAt(range);
    setup.frames = 20000;
    setup.sensor["receiver"]["noise_w"] = noise_w;
    const double expected = lab::normalCdf(z);
    const double got = static_cast<double>(fire(setup).size()) / setup.frames;
    EXPECT_NEAR(got, expected, 4 * std::sqrt(expected * (1 - expected) / setup.frames)) << z;
  }
}

// The noise shows in the intensity (s + n) and in the EPW, which widens with n: both from one draw per echo.
TEST(SignalChain, NoiseOfAnEchoIsOneDrawForIntensityAndWidth) {
  Case setup = wallAt(40);
  setup.frames = 5000;
  setup.sensor["receiver"]["noise_w"] = 3e-9;
  const auto detections = fire(setup);
  ASSERT_EQ(detections.size(), 5000u);
  EXPECT_NEAR(lab::mean(detections.intensity), 1e9 * radarEquation(40), 4 * 3.0 / std::sqrt(5000.0));
  EXPECT_NEAR(lab::deviation(detections.intensity) / 3.0, 1.0, 4 / std::sqrt(10000.0));
  for (std::size_t i = 0; i < 100; ++i) {
    const double noise_w = 1e-9 * detections.intensity[i] - radarEquation(40);
    EXPECT_NEAR(detections.epw_m[i], epwLaw(radarEquation(40), lab::kThreshold_w - noise_w), 1e-4);
  }
}

// However noisy: no echo without light, and the level never falls below a tenth of the threshold.
TEST(SignalChain, NoiseIsCutAtNineTenthsOfTheThreshold) {
  const auto detectionsAt = [](double share_of_threshold) {
    Case setup = wallAt(10.0 * std::sqrt(radarEquation(10) / (share_of_threshold * lab::kThreshold_w)));
    setup.frames = 2000;
    setup.sensor["receiver"]["noise_w"] = 100e-9;
    return fire(setup);
  };
  EXPECT_EQ(detectionsAt(0.099).size(), 0u);
  EXPECT_GT(detectionsAt(0.101).size(), 400u);
  const auto strong = detectionsAt(5.0);
  EXPECT_NEAR(*std::max_element(strong.intensity.begin(), strong.intensity.end()), 1e9 * 5.9 * lab::kThreshold_w, 1e-3);
}

// Off: all sub-rays on one object count at their mean range; on: each for itself, so an oblique wall widens the echo.
TEST(SignalChain, SubRaysOnOneObjectCountAtTheirMeanRange) {
  Case setup = wallAt(50);
  setup.scene[0]["pose"]["yaw_pitch_roll_deg"] = {70, 0, 0};
  setup.effects["beam-divergence"] = {{"horizontal_rad", 0.01}, {"vertical_rad", 0}};
  setup.rays_per_beam = {51, 1};
  const auto pulses = lab::pulses(setup);
  ASSERT_EQ(pulses.size(), 1u);
  setup.effects["pulse-broadening"] = nlohmann::json::object();
  const auto spread = lab::pulses(setup);
  ASSERT_EQ(spread.size(), 51u);
  double power = 0.0, moment = 0.0;
  for (const Pulse& pulse : spread) {
    power += pulse.power_w;
    moment += pulse.power_w * pulse.range_m;
  }
  EXPECT_NEAR(pulses[0].power_w / power, 1.0, 1e-9);
  EXPECT_NEAR(pulses[0].range_m, moment / power, 1e-9);
}

TEST(SignalChain, DirectionsAreTheBeamsCentres) {
  Case setup = wallAt(20);
  setup.sensor["scan"]["layers"][0] = {{"elevation_deg", 1.5},
                                       {"azimuth_deg", {{"from", 10}, {"to", -10}, {"step", 5}}}};
  setup.frames = 2;
  const auto detections = fire(setup);
  ASSERT_EQ(detections.size(), 10u);
  EXPECT_EQ(detections.frame, (std::vector<std::int32_t>{0, 0, 0, 0, 0, 1, 1, 1, 1, 1}));
  EXPECT_NEAR(detections.azimuth_rad[1], 5 * M_PI / 180, 1e-12);
  EXPECT_NEAR(detections.elevation_rad[1], 1.5 * M_PI / 180, 1e-12);
  EXPECT_NEAR(detections.time_s[1], 0.2 * 0.05, 1e-12);
  EXPECT_NEAR(detections.range_m[1], 20 / std::cos(5 * M_PI / 180) / std::cos(1.5 * M_PI / 180), 1e-5);
}

// The middle one of three beams meets both boards: it is fired apart from the others, which have one pulse each.
TEST(SignalChain, DetectionsComeFrameByFrameAndBeamByBeam) {
  Case setup = twoBoards(10, 15);
  setup.sensor["scan"]["layers"][0]["azimuth_deg"] = {{"from", 2}, {"to", -2}, {"step", 2}};
  setup.frames = 2;
  const auto detections = fire(setup);
  EXPECT_EQ(detections.frame, (std::vector<std::int32_t>{0, 0, 0, 0, 1, 1, 1, 1}));
  EXPECT_EQ(detections.echo, (std::vector<std::int32_t>{1, 1, 2, 1, 1, 1, 2, 1}));
  const double two_deg = 2.0 * M_PI / 180.0;
  for (const std::size_t first : {0U, 4U}) {
    EXPECT_NEAR(detections.azimuth_rad[first], two_deg, 1e-9);
    EXPECT_NEAR(detections.azimuth_rad[first + 1], 0.0, 1e-9);
    EXPECT_NEAR(detections.azimuth_rad[first + 2], 0.0, 1e-9);
    EXPECT_NEAR(detections.azimuth_rad[first + 3], -two_deg, 1e-9);
  }
}

TEST(SignalChain, OnlyTheListedOutputsAreThere) {
  Case setup = wallAt(20);
  setup.sensor["detection"]["output"] = {"range", "intensity"};
  const auto detections = fire(setup);
  EXPECT_TRUE(detections.epw_m.empty());
  EXPECT_EQ(detections.intensity.size(), 1u);
}

TEST(SignalChain, BlackOrTouchingSurfacesAreNoTrouble) {
  EXPECT_EQ(fire(wallAt(10, 0.0)).size(), 0u);
  EXPECT_LE(fire(wallAt(0.0)).size(), 1u);  // the sensor stands in the board
  EXPECT_LE(fire(wallAt(1e-7)).size(), 1u);
}

}  // namespace
}  // namespace model
