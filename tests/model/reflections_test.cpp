#include "model/reflections.h"

#include <cmath>
#include <gtest/gtest.h>

#include "core/physics.h"
#include "tests/model/lab.h"
#include "tests/support/paths.h"

namespace model {
namespace {

using nlohmann::json;

/// Everything between a scene and its detections that has to come through the seam: partial hits, several echoes, a
/// pane, a mirror, a body under way, noise, effects on both sides.
lab::Case busyCase() {
  lab::Case setup;
  setup.sensor["scan"]["layers"] = {
      {{"elevation_deg", 0.0}, {"azimuth_deg", {{"from", 20}, {"to", -20}, {"step", 0.5}}}},
      {{"elevation_deg", -2.0}, {"azimuth_deg", {{"from", 20}, {"to", -20}, {"step", 0.5}}}}};
  setup.sensor["receiver"]["noise_w"] = 4e-9;
  setup.sensor["receiver"]["threshold_w"] = 5e-9;
  setup.sensor["detection"]["range_noise_m"] = 0.01;
  setup.sensor["detection"]["epw_noise_m"] = 0.03;
  setup.rays_per_beam = {3, 5};
  setup.materials["window"] = {{"reflectivity", 0.05}, {"transmission", 0.8}, {"refractive_index", 1.5}};
  setup.materials["chrome"] = {{"reflectivity", 0.8},
                               {"brdf", {{"model", "phong"}, {"diffuse_fraction", 0.2}, {"exponent", 50}}}};
  setup.effects = {{"beam-divergence", json::object()},
                   {"pulse-broadening", json::object()},
                   {"transmission", json::object()},
                   {"multipath", json::object()},
                   {"angular-reflection", json::object()},
                   {"atmospheric-attenuation", {{"visibility_m", 300}}},
                   {"atmospheric-backscatter", {{"visibility_m", 300}}},
                   {"mounting-error", {{"yaw_deg", 0.3}, {"position_m", {0.1, 0.0, 0.2}}}},
                   {"blooming", json::object()},
                   {"speckle", {{"looks", 20}}},
                   {"detection-loss", {{"probability", 0.1}}}};
  json pane = lab::board(6, 2, "window", "pane"), mirror = lab::board(8, 1.5, "chrome", "mirror");
  pane["pose"]["position_m"] = {6, 1.2, 0};
  mirror["pose"] = {{"position_m", {8, -1.5, 0}}, {"yaw_pitch_roll_deg", {40, 0, 0}}};
  json post = lab::object("post", {{"type", "cylinder"}, {"radius_m", 0.1}, {"height_m", 4}}, {12, 0.5, 0});
  post["velocity_m_s"] = {-3.0, 5.0, 0.0};
  setup.scene = {lab::board(30, 60), post, pane, mirror,
                 lab::object("side", {{"type", "box"}, {"size_m", {30, 1, 6}}}, {10, -12, 0})};
  setup.frames = 4;
  return setup;
}

core::LidarSensorView reflections(const lab::Case& setup) {
  const Experiment experiment = lab::experimentOf(setup);
  return simulateReflections(experiment, lab::modelOf(setup), experiment.samples[0]);
}

/// Through a file, as a stranger would get it.
core::Detections throughATrace(const lab::Case& setup) {
  const test_support::TemporaryFolder folder;
  const core::LidarSensorView view = reflections(setup);
  core::writeLidarSensorViews(folder / "r.osi", std::span(&view, 1));
  return receive(readReflections(folder / "r.osi"), lab::experimentOf(setup), lab::modelOf(setup), 0);
}

void expectSame(const core::Detections& a, const core::Detections& b) {
  ASSERT_EQ(a.size(), b.size());
  EXPECT_EQ(a.frame, b.frame);
  EXPECT_EQ(a.layer, b.layer);
  EXPECT_EQ(a.echo, b.echo);
  EXPECT_EQ(a.azimuth_rad, b.azimuth_rad);
  EXPECT_EQ(a.time_s, b.time_s);
  for (std::size_t i = 0; i < a.size(); ++i) {
    // A strength in dB keeps a power to |s| ln 10 / 10 · 2^-53, a time of flight a range to 2^-52. Widths near the
    // threshold magnify that.
    ASSERT_NEAR(a.range_m[i], b.range_m[i], 1e-9);
    ASSERT_NEAR(a.epw_m[i], b.epw_m[i], 1e-7);
    ASSERT_NEAR(a.intensity[i], b.intensity[i], 1e-9 * a.intensity[i]);
  }
}

TEST(Reflections, OwnOnesGiveTheDetectionsOfTheDirectSimulation) {
  const lab::Case setup = busyCase();
  const core::Detections direct = lab::fire(setup);
  ASSERT_GT(direct.size(), 500u);
  expectSame(direct, throughATrace(setup));
}

TEST(Reflections, ObjectsAreTakenTogetherWithoutPulseBroadening) {
  lab::Case setup = busyCase();
  setup.effects.erase("pulse-broadening");
  expectSame(lab::fire(setup), throughATrace(setup));
}

TEST(Reflections, MovingScansAndGaussianBeamsComeThrough) {
  lab::Case setup = busyCase();
  setup.sensor["emitter"]["beam_profile"] = "gaussian";
  setup.effects["motion-scan"] = json::object();
  expectSame(lab::fire(setup), throughATrace(setup));
}

// Laser radar equation over the emitted power, and its geometry, written down again.
TEST(Reflections, AreWhatTheLaserRadarEquationSays) {
  lab::Case setup;
  json board = lab::board(10.0);
  board["velocity_m_s"] = {-15.0, 3.0, 0.0};
  board["pose"]["yaw_pitch_roll_deg"] = {30, 0, 0};
  setup.scene = {lab::board(50.0, 20.0, "grey", "behind"), board};
  const core::LidarSensorView view = reflections(setup);
  ASSERT_EQ(view.directions.size(), 1u);
  ASSERT_EQ(view.reflections.size(), 1u);
  const core::LidarReflection& r = view.reflections[0];
  const double cosine = std::sqrt(0.75), speed_of_light_m_s = 299792458.0;
  EXPECT_NEAR(r.signal_strength_db, 10 * std::log10(lab::radarEquation(10.0, 0.5, cosine) / 75.0), 1e-6);
  EXPECT_NEAR(r.time_of_flight_s, 20.0 / speed_of_light_m_s, 1e-15);
  EXPECT_NEAR(*r.doppler_shift_hz, 2.0 * 15.0 / 905e-9, 1e-3);  // it comes nearer: higher
  EXPECT_NEAR(*view.emitter_frequency_hz, speed_of_light_m_s / 905e-9, 1.0);
  EXPECT_NEAR((*r.surface_normal)[0], -cosine, 1e-6);
  EXPECT_NEAR((*r.surface_normal)[1], -0.5, 1e-6);
  EXPECT_EQ(r.object, 1u);  // in the order of the scene
}

// The rays of a beam add up to its power: here the board fills the beam.
TEST(Reflections, OfABeamAddUpToItsPower) {
  lab::Case setup;
  setup.effects = {{"beam-divergence", json::object()}, {"pulse-broadening", json::object()}};
  setup.rays_per_beam = {7, 5};
  setup.scene = {lab::board(10.0)};
  double sum = 0.0;
  const core::LidarSensorView view = reflections(setup);
  EXPECT_EQ(view.reflections.size(), 35u);
  for (const core::LidarReflection& r : view.reflections) sum += 75.0 * std::pow(10.0, r.signal_strength_db / 10.0);
  EXPECT_NEAR(sum / lab::radarEquation(10.0), 1.0, 1e-5);
}

TEST(Reflections, RaysWithoutAHitAreRaysAllTheSame) {
  lab::Case setup = busyCase();
  setup.scene = json::array({lab::board(10, 0.5)});
  const core::LidarSensorView view = reflections(setup);
  EXPECT_EQ(view.directions.size(), 2u * 81u * 15u);
  EXPECT_LE(view.reflections.size(), 2u * 7u * 15u);  // 0.5 m at 10 m: 2.9°
  expectSame(lab::fire(setup), throughATrace(setup));
}

core::LidarReflection reflection(std::size_t ray, double range_m, double power_w) {
  return {.ray = ray,
          .signal_strength_db = 10 * std::log10(power_w / lab::kPeakPower_w),
          .time_of_flight_s = 2.0 * range_m / 299792458.0};
}

lab::Case threeBeams() {
  lab::Case setup;
  setup.sensor["scan"]["layers"][0]["azimuth_deg"] = {{"from", 1}, {"to", -1}, {"step", 1}};
  return setup;
}

/// Rays in an order of their own, about the axes of the beams; one goes past all of them.
core::LidarSensorView foreignView() {
  core::LidarSensorView view;
  const auto ray = [&](double azimuth_deg, double up_rad) {
    const double a = azimuth_deg * core::kRadPerDeg;
    view.directions.push_back({std::cos(up_rad) * std::cos(a), std::cos(up_rad) * std::sin(a), std::sin(up_rad)});
  };
  ray(-1, 0.001), ray(1, 0.0), ray(0.5, 0.0), ray(-1, -0.001), ray(0, 0.0);
  view.reflections = {reflection(0, 20, 100e-9), reflection(1, 40, 80e-9), reflection(2, 5, 1e-6),
                      reflection(3, 30, 60e-9)};
  return view;
}

TEST(Reflections, OfAnotherModelComeToTheBeamThatLightsThemUp) {
  const lab::Case setup = threeBeams();
  const core::Detections d = receive({"foreign.osi", {foreignView()}}, lab::modelOf(setup), "");
  ASSERT_EQ(d.size(), 3u);  // the ray between two beams counts for nothing
  EXPECT_NEAR(d.azimuth_rad[0], 1 * core::kRadPerDeg, 1e-12);
  EXPECT_NEAR(d.range_m[0], 40.0, 1e-9);
  EXPECT_NEAR(d.range_m[1], 20.0, 1e-9);
  EXPECT_NEAR(d.range_m[2], 30.0, 1e-9);
  EXPECT_EQ(d.echo, (std::vector<std::int32_t>{1, 1, 2}));
  EXPECT_NEAR(d.intensity[1], 100.0, 1e-9);
  EXPECT_NEAR(d.epw_m[2], lab::epwLaw(60e-9), 1e-9);
}

// Two rays of one object are one echo at their mean weighted with power, unless pulses broaden; without an object
// nobody knows that they belong together.
TEST(Reflections, OfOneObjectAreOneEcho) {
  const lab::Case setup = threeBeams();
  core::LidarSensorView view = foreignView();
  view.reflections = {reflection(0, 20, 100e-9), reflection(3, 26, 50e-9)};
  EXPECT_EQ(receive({"a.osi", {view}}, lab::modelOf(setup), "").size(), 2u);
  view.reflections[0].object = view.reflections[1].object = ~std::uint64_t{0};
  const core::Detections together = receive({"a.osi", {view}}, lab::modelOf(setup), "");
  ASSERT_EQ(together.size(), 1u);
  EXPECT_NEAR(together.range_m[0], 22.0, 1e-9);
  EXPECT_NEAR(together.intensity[0], 150.0, 1e-7);
}

TEST(Reflections, EveryMessageIsAFrame) {
  lab::Case setup = threeBeams();
  core::LidarSensorView farther = foreignView();
  for (core::LidarReflection& r : farther.reflections) r.time_of_flight_s *= 1.5;
  const ReflectionTrace trace{"two.osi", {foreignView(), farther}};
  const core::Detections d = receive(trace, lab::modelOf(setup), "");
  EXPECT_EQ(d.frame, (std::vector<std::int32_t>{0, 0, 0, 1, 1, 1}));
  EXPECT_NEAR(d.range_m[3], 60.0, 1e-9);
  setup.frames = 2;
  EXPECT_EQ(receive(trace, lab::experimentOf(setup), lab::modelOf(setup), 0).range_m, d.range_m);
  setup.frames = 3;
  const std::string refusal =
      lab::refusal([&] { (void)receive(trace, lab::experimentOf(setup), lab::modelOf(setup), 0); });
  EXPECT_NE(refusal.find("two.osi: has 2 messages, but the sample 's' has 3 frames"), std::string::npos) << refusal;
}

// Attenuation lies before the reflection, backscatter and noise behind it.
TEST(Reflections, EffectsOnTheirPowerAreLeftToThem) {
  lab::Case setup = threeBeams();
  const ReflectionTrace trace{"foreign.osi", {foreignView()}};
  const core::Detections plain = receive(trace, lab::modelOf(setup), "");
  setup.effects = {{"atmospheric-attenuation", {{"visibility_m", 50}}}, {"range-offset", {{"offset_m", 0.5}}}};
  const core::Detections d = receive(trace, lab::modelOf(setup), "");
  EXPECT_EQ(d.intensity, plain.intensity);
  EXPECT_NEAR(d.range_m[0], plain.range_m[0] + 0.5, 1e-12);
  EXPECT_EQ(effectsInReflections(lab::modelOf(setup)), (std::vector<std::string>{"atmospheric-attenuation"}));
}

TEST(Reflections, ThatCannotBeMeantAreSaidWithTheMessage) {
  const LidarModel model = lab::modelOf(threeBeams());
  core::LidarSensorView upwards = foreignView();
  for (auto& direction : upwards.directions) direction = {0, 0, 1};
  const std::string outside = lab::refusal([&] { (void)receive({"up.osi", {foreignView(), upwards}}, model, ""); });
  EXPECT_NE(outside.find("up.osi, message 2: none of its 4 reflections lies in a beam"), std::string::npos) << outside;
  core::LidarSensorView linear = foreignView();
  for (core::LidarReflection& r : linear.reflections) r.signal_strength_db = 1e-9;
  const std::string strong = lab::refusal([&] { (void)receive({"w.osi", {linear}}, model, ""); });
  EXPECT_NE(strong.find("w.osi, message 1: has no reflection that is weaker than what was sent"), std::string::npos)
      << strong;
  EXPECT_NE(strong.find("10 log10"), std::string::npos);
}

}  // namespace
}  // namespace model
