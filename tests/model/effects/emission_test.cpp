// Effects of the emission: beam divergence is held by signal_chain_test.cpp.
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "tests/model/effects/effect_bench.h"

namespace model {
namespace {

using nlohmann::json;

json bistaticSensor() {
  json sensor = lab::sensor();
  sensor["receiver"]["field_of_view_rad"] = {{"horizontal", 0.006}, {"vertical", 0.006}};
  return sensor;
}

double overlap(double range_m, double offset_m) {
  lab::Case with = lab::boardWith(range_m, "aperture-offset", {{"offset_m", offset_m}});
  with.sensor = bistaticSensor();
  return lab::power_w(with) / lab::power_w(lab::boardWith(range_m));
}

/// Share of a disc within another one, by a fine grid: independent and slow.
double gridOverlap(double radius, double other, double distance) {
  int inside = 0, both = 0;
  for (int i = -1000; i < 1000; ++i) {
    for (int k = -1000; k < 1000; ++k) {
      const double x = (i + 0.5) / 1000 * radius, y = (k + 0.5) / 1000 * radius;
      if (x * x + y * y > radius * radius) continue;
      ++inside;
      both += (x - distance) * (x - distance) + y * y <= other * other;
    }
  }
  return static_cast<double>(both) / inside;
}

TEST(ApertureOffset, CrossoverIsTheSharedAreaOfTwoDiscs) {
  for (const double range : {2.0, 10.0, 20.0, 30.0, 35.0}) {
    EXPECT_NEAR(overlap(range, 0.1), gridOverlap(0.0015 * range, 0.01 + 0.003 * range, 0.1), 2e-3) << range;
  }
}

// Blind while r (φ + Ψ)/2 + D/2 < offset, complete once r (Ψ - φ)/2 + D/2 > offset.
TEST(ApertureOffset, NearIsBlindAndFarIsComplete) {
  EXPECT_EQ(overlap(0.09 / 0.0045 - 0.1, 0.1), 0.0);
  EXPECT_GT(overlap(0.09 / 0.0045 + 0.1, 0.1), 0.0);
  EXPECT_EQ(overlap(0.09 / 0.0015 + 0.1, 0.1), 1.0);
  EXPECT_EQ(overlap(5.0, 0.0), 1.0);
}

// Beams leave turned, directions are reported as ever: a wall at x = d is met at d / cos(azimuth + yaw).
TEST(MountingError, YawTurnsTheBeamAndNotWhatIsReported) {
  lab::Case setup = lab::boardWith(20, "mounting-error", {{"yaw_deg", 3.0}});
  setup.sensor["scan"]["layers"][0]["azimuth_deg"] = {{"from", 10}, {"to", 10}, {"step", 1}};
  const auto detections = lab::fire(setup);
  EXPECT_NEAR(detections.range_m.at(0), 20 / std::cos(13 * std::numbers::pi / 180), 1e-6);
  EXPECT_NEAR(detections.azimuth_rad.at(0), 10 * std::numbers::pi / 180, 1e-12);
}

TEST(MountingError, PositivePitchLooksDownAndPositiveRollLowersTheRight) {
  const auto rangeToGround = [](const json& parameters, double azimuth_deg) {
    lab::Case setup = lab::boardWith(1, "mounting-error", parameters);
    setup.scene = {lab::object("road", {{"type", "plane"}}, {0, 0, -1.5})};
    setup.sensor["scan"]["layers"][0]["azimuth_deg"] = {{"from", azimuth_deg}, {"to", azimuth_deg}, {"step", 1}};
    const auto detections = lab::fire(setup);
    return detections.size() == 1 ? detections.range_m[0] : 0.0;
  };
  const double s = std::sin(4 * std::numbers::pi / 180);
  EXPECT_NEAR(rangeToGround({{"pitch_deg", 4.0}}, 0), 1.5 / s, 1e-5);
  EXPECT_EQ(rangeToGround({{"pitch_deg", -4.0}}, 0), 0.0);
  EXPECT_NEAR(rangeToGround({{"roll_deg", 4.0}}, -90), 1.5 / s, 1e-5);
  EXPECT_EQ(rangeToGround({{"roll_deg", 4.0}}, 90), 0.0);
}

// The sensor stands half a metre nearer to the wall and 0.4 m higher above the road than assumed.
TEST(MountingError, PositionIsTrueMinusAssumed) {
  const auto range = [](const std::vector<double>& position_m, const json& scene) {
    lab::Case setup = lab::boardWith(20, "mounting-error", {{"position_m", position_m}, {"pitch_deg", 4.0}});
    setup.scene = scene;
    return lab::fire(setup).range_m.at(0);
  };
  const double pitch = 4 * std::numbers::pi / 180;
  EXPECT_NEAR(range({0.5, 0.2, 0}, json::array({lab::board(20)})), 19.5 / std::cos(pitch), 1e-5);
  const json road = json::array({lab::object("road", {{"type", "plane"}}, {0, 0, -1.5})});
  EXPECT_NEAR(range({0, 0, 0.4}, road), 1.9 / std::sin(pitch), 1e-4);
  lab::Case bad = lab::boardWith(20, "mounting-error", {{"position_m", {0.5, 0}}});
  EXPECT_NE(lab::refusal([&] { (void)lab::modelOf(bad); }).find("/effects/mounting-error/position_m"),
            std::string::npos);
  bad.effects["mounting-error"]["position_m"] = {0, 0, 5};
  EXPECT_NE(lab::refusal([&] { (void)lab::modelOf(bad); }).find("holds 5"), std::string::npos);
}

// n = 20 000: a standard deviation is known to 0.5 %; four standard errors.
TEST(PulseJitter, PowerAndDurationScatterAsGiven) {
  lab::Case power = lab::boardWith(20, "pulse-jitter", {{"power_stddev", 0.05}});
  power.frames = 20000;
  const auto bright = lab::fire(power).intensity;
  EXPECT_NEAR(lab::deviation(bright) / lab::mean(bright) / 0.05, 1.0, 0.02);
  lab::Case duration = lab::boardWith(20, "pulse-jitter", {{"duration_stddev_ns", 0.2}});
  duration.frames = 20000;
  const auto wide = lab::fire(duration).epw_m;
  EXPECT_NEAR(lab::mean(wide), lab::epwLaw(lab::radarEquation(20)), 4 * 0.04 * lab::mean(wide) / std::sqrt(20000.0));
  EXPECT_NEAR(lab::deviation(wide) / lab::mean(wide) / (0.2 / lab::kFwhm_ns), 1.0, 0.02);
}

// A board so oblique that the footprint stretches the echo: longer pulses overlap more, and what the tilt adds to the
// width stays. Held against sensors whose pulse is 1 % longer and shorter.
TEST(PulseJitter, OfAStretchedEchoTheDurationChangesThePeakAndLessOfTheWidth) {
  lab::Case setup = lab::boardWith(20, "beam-divergence", json::object());
  setup.scene = json::array(
      {lab::object("board", {{"type", "rectangle"}, {"width_m", 20}, {"height_m", 20}}, {20, 0, 0}, {86, 0, 0})});
  setup.rays_per_beam = {101, 1};
  setup.effects["pulse-broadening"] = json::object();
  const auto ofPulse = [&](double of_fwhm) {
    lab::Case longer = setup;
    longer.sensor["emitter"]["pulse_fwhm_ns"] = of_fwhm * lab::kFwhm_ns;
    return lab::fire(longer);
  };
  const core::Detections longer = ofPulse(1.01), shorter = ofPulse(0.99);
  const auto perWidth = [](double more, double less) { return (more - less) / (more + less) / 0.01; };
  const double of_width = perWidth(longer.epw_m.at(0), shorter.epw_m.at(0));
  const double of_peak = perWidth(longer.intensity.at(0), shorter.intensity.at(0));
  ASSERT_LT(of_width, 0.8);
  ASSERT_GT(of_peak, 0.2);
  setup.effects["pulse-jitter"] = {{"duration_stddev_ns", 0.2}};
  setup.frames = 20000;
  const core::Detections jittered = lab::fire(setup);
  const auto scatter = [](const std::vector<double>& values) { return lab::deviation(values) / lab::mean(values); };
  EXPECT_NEAR(scatter(jittered.epw_m) / (of_width * 0.2 / lab::kFwhm_ns), 1.0, 0.02);
  EXPECT_NEAR(scatter(jittered.intensity) / (of_peak * 0.2 / lab::kFwhm_ns), 1.0, 0.02);
}

TEST(PulseJitter, PowerAndDurationAreIndependent) {
  lab::Case setup = lab::boardWith(20, "pulse-jitter", {{"power_stddev", 0.1}, {"duration_stddev_ns", 0.5}});
  setup.frames = 20000;
  const auto detections = lab::fire(setup);
  double covariance = 0.0;
  std::vector<double> stretch;
  for (std::size_t i = 0; i < detections.size(); ++i)
    stretch.push_back(detections.epw_m[i] / lab::epwLaw(1e-9 * detections.intensity[i]));
  const double power = lab::mean(detections.intensity), width = lab::mean(stretch);
  for (std::size_t i = 0; i < detections.size(); ++i)
    covariance += (detections.intensity[i] - power) * (stretch[i] - width);
  covariance /= static_cast<double>(detections.size());
  EXPECT_NEAR(covariance / lab::deviation(detections.intensity) / lab::deviation(stretch), 0.0, 4 / std::sqrt(20000.0));
}

}  // namespace
}  // namespace model
