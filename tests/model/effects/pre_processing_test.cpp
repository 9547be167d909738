#include <cmath>
#include <gtest/gtest.h>

#include "tests/model/effects/effect_bench.h"

namespace model {
namespace {

using nlohmann::json;

double rangeWith(double range_m, const std::string& effect, const json& parameters,
                 const json& environment = json::object()) {
  lab::Case setup = lab::boardWith(range_m, effect, parameters);
  setup.environment = environment;
  return lab::fire(setup).range_m.at(0);
}

// The leading edge lies a quarter of the EPW before the peak.
TEST(RangeWalk, EdgeLiesAQuarterOfTheEchoPulseWidthBeforeThePeak) {
  for (const double range : {10.0, 40.0, 100.0}) {
    EXPECT_NEAR(rangeWith(range, "range-walk", json::object()), range - lab::epwLaw(lab::radarEquation(range)) / 4,
                1e-5);
  }
}

TEST(RangeWalk, CalibratedSensorIsRightAtThatEchoAndFarBelowIt) {
  const double range = 10 * std::sqrt(lab::radarEquation(10) / (50 * lab::kThreshold_w));  // P = 50 P_th there
  EXPECT_NEAR(rangeWith(range, "range-walk", {{"calibrated_at_snr", 50}}), range, 1e-5);
  EXPECT_GT(rangeWith(1.5 * range, "range-walk", {{"calibrated_at_snr", 50}}), 1.5 * range);  // weaker: too far
  EXPECT_LT(rangeWith(0.5 * range, "range-walk", {{"calibrated_at_snr", 50}}), 0.5 * range);
}

TEST(RangeWalk, LinearFrontErrsByThresholdOverPower) {
  EXPECT_NEAR(rangeWith(30, "range-walk", {{"coefficient_m", 0.5}}),
              30 + 0.5 * lab::kThreshold_w / lab::radarEquation(30), 1e-6);
}

TEST(RangeOffset, MovesEveryRangeByTheSame) {
  EXPECT_NEAR(rangeWith(10, "range-offset", {{"offset_m", -0.07}}), 9.93, 1e-5);
  EXPECT_NEAR(rangeWith(90, "range-offset", {{"offset_m", -0.07}}), 89.93, 1e-5);
}

TEST(ClockDrift, ErrorIsProportionalToRangeAndTemperature) {
  EXPECT_NEAR(rangeWith(100, "clock-drift", {{"scale_ppm", 500}}), 100.05, 1e-5);
  EXPECT_NEAR(rangeWith(50, "clock-drift", {{"scale_ppm", 500}}), 50.025, 1e-5);
  EXPECT_NEAR(rangeWith(100, "clock-drift", {{"per_kelvin_ppm", 10}}, {{"temperature_degC", 45}}), 100.025, 1e-5);
  EXPECT_NEAR(rangeWith(100, "clock-drift", {{"per_kelvin_ppm", 10}}), 100, 1e-5);
}

TEST(Quantisation, RoundsToItsSteps) {
  lab::Case setup = lab::boardWith(
      20.03, "quantisation",
      {{"range_step_m", 0.25}, {"epw_step_m", 0.5}, {"intensity_bits", 8}, {"intensity_full_scale_nw", 25500}});
  const auto detections = lab::fire(setup);
  EXPECT_NEAR(detections.range_m.at(0), 20.0, 1e-12);
  const double epw = lab::epwLaw(lab::radarEquation(20.03));
  EXPECT_NEAR(detections.epw_m.at(0), 0.5 * std::round(epw / 0.5), 1e-12);
  EXPECT_NEAR(detections.intensity.at(0), 100 * std::round(1e9 * lab::radarEquation(20.03) / 100), 1e-6);
}

// 478 steps of 41.9 mm are 20.0282 m.
TEST(Quantisation, OutputsAreRoundedToTheProfileAfterTheyWereCounted) {
  lab::Case setup = lab::boardWith(
      20.03, "quantisation",
      {{"range_step_m", 0.0419}, {"epw_step_m", 0.31}, {"intensity_bits", 8}, {"intensity_full_scale_nw", 25500}});
  const auto counted = lab::fire(setup);
  setup.sensor["detection"]["range_resolution_m"] = 0.02;
  setup.sensor["detection"]["epw_resolution_m"] = 0.04;
  setup.sensor["detection"]["intensity_resolution"] = 90;
  const auto reported = lab::fire(setup);
  EXPECT_NEAR(counted.range_m.at(0), 20.0282, 1e-9);
  EXPECT_NEAR(reported.range_m.at(0), 20.02, 1e-9);
  EXPECT_NEAR(reported.epw_m.at(0), 0.04 * std::round(counted.epw_m.at(0) / 0.04), 1e-9);
  EXPECT_NEAR(reported.intensity.at(0), 90 * std::round(counted.intensity.at(0) / 90), 1e-6);
}

TEST(Quantisation, NoIntensityIsAboveTheHighestLevel) {
  const auto detections =
      lab::fire(lab::boardWith(20.03, "quantisation", {{"intensity_bits", 8}, {"intensity_full_scale_nw", 255}}));
  EXPECT_NEAR(detections.intensity.at(0), 255, 1e-9);
}

// Widrow: over many ranges the error of rounding is uniform with variance q²/12.
TEST(Quantisation, ErrorHasTheVarianceOfAUniformDistribution) {
  std::vector<double> errors;
  for (int i = 0; i < 400; ++i) {
    const double range = 20 + 0.0025 * (i + 0.5);
    errors.push_back(rangeWith(range, "quantisation", {{"range_step_m", 0.1}}) - range);
  }
  EXPECT_NEAR(lab::deviation(errors), 0.1 / std::sqrt(12.0), 1e-3);
}

TEST(RangeGating, DropsWhatLiesOutsideTheGate) {
  EXPECT_EQ(lab::fire(lab::boardWith(20, "range-gating", {{"from_m", 21}})).size(), 0u);
  EXPECT_EQ(lab::fire(lab::boardWith(20, "range-gating", {{"from_m", 19}, {"to_m", 21}})).size(), 1u);
  EXPECT_EQ(lab::fire(lab::boardWith(20, "range-gating", {{"to_m", 19}})).size(), 0u);
}

TEST(EchoMerging, ReplacesTheSeparation) {
  lab::Case setup;
  setup.rays_per_beam = {10, 1};
  setup.scene = {lab::object("near", {{"type", "rectangle"}, {"width_m", 2}, {"height_m", 2}}, {10, 1.0, 0}),
                 lab::board(15)};
  setup.effects = {{"beam-divergence", json::object()}, {"echo-merging", {{"separation_m", 4.9}}}};
  EXPECT_EQ(lab::fire(setup).size(), 2u);
  setup.effects["echo-merging"]["separation_m"] = 5.1;
  EXPECT_EQ(lab::fire(setup).size(), 1u);
}

TEST(DynamicThreshold, IsAMultipleOfTheNoiseThatIsThere) {
  lab::Case setup = lab::boardWith(20, "dynamic-threshold", {{"factor", 6}});
  setup.sensor["receiver"]["noise_w"] = 1e-9;
  setup.effects["thermal-noise"] = {{"temperature_degC", 36}};  // twice the noise
  const LidarModel model = lab::modelOf(setup);
  EXPECT_NEAR(SignalChain(model.sensor(""), model.effects, {}).settings().receiver.threshold_w, 12e-9, 1e-18);
}

// Up to the window the threshold is (w/r)² of itself: width and leading edge are those of that threshold.
TEST(DynamicThreshold, WithinItsWindowItFallsWithTheSquareOfTheRange) {
  for (const double range : {6.0, 10.0, 29.0, 40.0}) {
    const double raised = range < 30 ? std::pow(30 / range, 2) : 1.0;
    lab::Case setup = lab::boardWith(range, "dynamic-threshold", {{"window", 30}});
    const auto detections = lab::fire(setup);
    const double epw = lab::epwLaw(lab::radarEquation(range), raised * lab::kThreshold_w);
    EXPECT_NEAR(detections.epw_m.at(0), epw, 1e-5) << range;
    EXPECT_NEAR(1e-9 * detections.intensity.at(0) / lab::radarEquation(range), 1.0, 1e-6);
    setup.sensor["detection"]["range_mode"] = "leading-edge";
    EXPECT_NEAR(lab::fire(setup).range_m.at(0), range - epw / 4, 1e-5);
  }
}

TEST(DynamicThreshold, WeakEchoesInTheWindowAreLost) {
  lab::Case setup = lab::boardWith(10, "dynamic-threshold", {{"window", 40}});  // 16 times the threshold there
  const auto reflectivityOf = [](double times) { return 0.5 * times * lab::kThreshold_w / lab::radarEquation(10); };
  setup.materials["grey"]["reflectivity"] = reflectivityOf(15);
  EXPECT_EQ(lab::fire(setup).size(), 0u);
  setup.materials["grey"]["reflectivity"] = reflectivityOf(18);
  EXPECT_EQ(lab::fire(setup).size(), 1u);
  setup.effects.clear();
  setup.materials["grey"]["reflectivity"] = reflectivityOf(15);
  EXPECT_EQ(lab::fire(setup).size(), 1u);
}

}  // namespace
}  // namespace model
