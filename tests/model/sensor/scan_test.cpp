#include "model/sensor/scan.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "core/physics.h"
#include "model/sensor/beams.h"
#include "model/sensor/sensor_profile.h"
#include "tests/model/lab.h"
#include "tests/support/paths.h"

namespace model {
namespace {

using nlohmann::json;

Scan scanOf(const char* id) { return resolveSensorProfile(id, "m.json", "/sensor").scan; }

std::string refusalOf(const json& scan) {
  json profile = lab::sensor();
  profile["scan"] = scan;
  return lab::refusal([&] { (void)resolveSensorProfile(profile, "m.json", "/sensor"); });
}

json lissajous() {
  return {{"frame_rate_hz", 10},
          {"lissajous",
           {{"azimuth_amplitude_deg", 36},
            {"elevation_amplitude_deg", 10},
            {"azimuth_step_deg", 0.4},
            {"mirror_frequency_hz", 320},
            {"ramp_s", 0.1}}}};
}

TEST(AzimuthGain, IsStraightBetweenItsPointsAndHeldBeyondThem) {
  const AzimuthGain table{{-10, 0, 20}, {0.2, 1.0, 0.5}};
  EXPECT_DOUBLE_EQ(table.at(-50), 0.2);
  EXPECT_DOUBLE_EQ(table.at(-10), 0.2);
  EXPECT_DOUBLE_EQ(table.at(-5), 0.6);
  EXPECT_DOUBLE_EQ(table.at(0), 1.0);
  EXPECT_DOUBLE_EQ(table.at(15), 0.625);
  EXPECT_DOUBLE_EQ(table.at(20), 0.5);
  EXPECT_DOUBLE_EQ(table.at(99), 0.5);
  EXPECT_DOUBLE_EQ(AzimuthGain{}.at(3), 1.0);
}

TEST(Scan, WithoutItsOptionalKeysGivesEveryBeamFullGain) {
  for (const Beam& beam : beamsOf(scanOf("demo-scanner"))) EXPECT_EQ(beam.gain, 1.0);
}

TEST(Scan, OwnBeamsGetTheGainOfTheirLayerAndAzimuth) {
  Scan scan{.layers = {{.gain = {{-10, 10}, {0.0, 1.0}}}, {}}};
  std::vector<Beam> beams{{.layer = 0, .azimuth_rad = 5 * core::kRadPerDeg}, {.layer = 1}, {.layer = 7}};
  applyGain(scan, beams);
  EXPECT_NEAR(beams[0].gain, 0.75, 1e-12);
  EXPECT_EQ(beams[1].gain, 1.0);
  EXPECT_EQ(beams[2].gain, 1.0);
}

// All beams of a flash leave at one time; layers may follow each other as slices of it.
TEST(Scan, FlashFiresAllBeamsOfALayerAtItsOffset) {
  Scan scan{.layers = {{0.0, 10, -10, 1}, {1.0, 10, -10, 1}}, .at_once = true};
  scan.layers[1].time_offset_s = 1e-5;
  for (const Beam& beam : beamsOf(scan)) EXPECT_EQ(beam.time_s, beam.layer == 0 ? 0.0 : 1e-5);
  for (const Beam& beam : beamsOf(scanOf("flash-spad-array"))) EXPECT_EQ(beam.time_s, 0.0);
}

TEST(Scan, OffsetOfALayerIsAddedToItsTimes) {
  Scan scan{.frame_rate_hz = 10.0, .duty = 0.5, .layers = {{0.0, 10, -10, 1}, {1.0, 10, -10, 1}}};
  scan.layers[1].time_offset_s = 0.004;
  const auto beams = beamsOf(scan);
  ASSERT_EQ(beams.size(), 42u);
  for (std::size_t c = 0; c < 21; ++c) EXPECT_NEAR(beams[c + 21].time_s - beams[c].time_s, 0.004, 1e-15);
}

// On the way the phase φ = 2πFt obeys azimuth = A cos φ, elevation = E (t/T) sin φ, time never goes back, and beams are
// where the azimuth is a multiple of the step.
TEST(Lissajous, BeamsLieOnTheFigureInOrderOfTime) {
  const double f = 320, amplitude = 36, height = 10, ramp = 0.1;
  const auto beams = beamsOf(scanOf("blickfeld-cube"));
  for (std::size_t i = 0; i < beams.size(); ++i) {
    const double phase = 2.0 * M_PI * f * beams[i].time_s;
    // acos is steep at the ends of the swing: rounding of the azimuth grows to its square root there.
    EXPECT_NEAR(beams[i].azimuth_rad * core::kDegPerRad, amplitude * std::cos(phase), 1e-6);
    EXPECT_NEAR(beams[i].elevation_rad * core::kDegPerRad, height * beams[i].time_s / ramp * std::sin(phase), 1e-6);
    if (i > 0) {
      EXPECT_GT(beams[i].time_s, beams[i - 1].time_s);
    }
    const double steps = (amplitude - beams[i].azimuth_rad * core::kDegPerRad) / 0.4;
    EXPECT_NEAR(steps, std::round(steps), 1e-9);
  }
}

// Within a way of the mirror, azimuth alone tells beams apart: no two of a layer share one.
TEST(Lissajous, EveryWayOfTheMirrorIsALayer) {
  const Scan scan = scanOf("blickfeld-cube");
  const auto beams = beamsOf(scan);
  EXPECT_EQ(layerCount(scan), 64u);
  EXPECT_EQ(beams.back().layer, 63);
  for (std::size_t i = 1; i < beams.size(); ++i) {
    if (beams[i].layer != beams[i - 1].layer) continue;
    EXPECT_EQ(beams[i].column, beams[i - 1].column + 1);
    EXPECT_EQ(beams[i].azimuth_rad < beams[i - 1].azimuth_rad, beams[i].layer % 2 == 0);
  }
}

// A swing that its step does not divide turns round at its last beam.
TEST(Lissajous, StepThatMissesTheEndGoesBackThroughTheSameAzimuths) {
  const auto beams = beamsOf({.lissajous = Lissajous{.azimuth_amplitude_deg = 1.0,
                                                     .elevation_amplitude_deg = 1.0,
                                                     .azimuth_step_deg = 0.7,
                                                     .mirror_frequency_hz = 10.0,
                                                     .ramp_s = 0.1}});
  std::vector<double> azimuths;
  for (const Beam& beam : beams) azimuths.push_back(std::round(10 * beam.azimuth_rad * core::kDegPerRad));
  EXPECT_EQ(azimuths, (std::vector<double>{10, 3, -4, 3}));
}

TEST(Scan, FaultsOfItsOptionalKeysAreNamedWithPointer) {
  json scan = lab::sensor()["scan"];
  scan["layers"][0]["azimuth_gain"] = {{"azimuth_deg", {0, 0}}, {"gain", {1, 1}}};
  EXPECT_NE(
      refusalOf(scan).find("/sensor/scan/layers/0/azimuth_gain/azimuth_deg/1: is 0, after 0; the table must rise"),
      std::string::npos)
      << refusalOf(scan);
  scan["layers"][0]["azimuth_gain"] = {{"azimuth_deg", {0, 1}}, {"gain", {1, 1.1}}};
  EXPECT_NE(refusalOf(scan).find("/azimuth_gain/gain/1: is 1.1; it must be 0 to 1."), std::string::npos);
  scan["layers"][0]["azimuth_gain"] = {{"azimuth_deg", {0, 1}}, {"gain", {1}}};
  EXPECT_NE(refusalOf(scan).find("/azimuth_gain/gain: has 1 elements; 2 were expected."), std::string::npos);
  scan["layers"][0]["azimuth_gain"] = {{"azimuth_deg", json::array()}, {"gain", json::array()}};
  EXPECT_NE(refusalOf(scan).find("/azimuth_gain/azimuth_deg: is empty"), std::string::npos);
  scan = lab::sensor()["scan"];
  scan["layers"][0]["time_offset_s"] = -1;
  EXPECT_NE(refusalOf(scan).find("/layers/0/time_offset_s"), std::string::npos);
  scan["layers"][0]["time_offset_s"] = 0;
  scan["firing"] = "atonce";
  EXPECT_NE(refusalOf(scan).find("Did you mean 'at-once'?"), std::string::npos);
}

TEST(Scan, FaultsOfALissajousFigureAreNamedWithPointer) {
  EXPECT_EQ(refusalOf(lissajous()), "");
  json scan = lissajous();
  scan["layers"] = lab::sensor()["scan"]["layers"];
  EXPECT_NE(refusalOf(scan).find("/sensor/scan/layers: says nothing beside 'lissajous'"), std::string::npos);
  scan = lissajous();
  scan["lissajous"]["ramp_s"] = 0.2;
  EXPECT_NE(refusalOf(scan).find("/lissajous/ramp_s: is 0.2; a frame is over after 0.1 s"), std::string::npos);
  scan["lissajous"]["ramp_s"] = 0.003;
  EXPECT_NE(refusalOf(scan).find("before the mirror has swung once"), std::string::npos);
  scan = lissajous();
  scan["lissajous"]["azimuth_step_deg"] = 80;
  EXPECT_NE(refusalOf(scan).find("/lissajous/azimuth_step_deg: leads out of the swing"), std::string::npos);
  scan = lissajous();
  scan["lissajous"]["mirror_frequency_hz"] = 1e12;
  EXPECT_NE(refusalOf(scan).find("/lissajous/mirror_frequency_hz"), std::string::npos);
}

TEST(Scan, ABillionBeamsAreRefusedWithTheMemoryTheyWouldTake) {
  json scan = lab::sensor()["scan"];
  scan["layers"][0]["azimuth_deg"] = {{"from", 0}, {"to", 100}, {"step", 1e-7}};
  const std::string refusal = refusalOf(scan);
  EXPECT_NE(refusal.find("/sensor/scan/layers: asks for 1e+09 beams a frame"), std::string::npos) << refusal;
  EXPECT_NE(refusal.find("GB of memory"), std::string::npos) << refusal;
  scan["layers"][0]["azimuth_deg"]["step"] = 1e-300;  // more than any integer holds
  EXPECT_NE(refusalOf(scan).find("beams a frame"), std::string::npos);
  scan = lissajous();
  scan["lissajous"]["azimuth_step_deg"] = 1e-9;
  EXPECT_NE(refusalOf(scan).find("/sensor/scan/lissajous: asks for"), std::string::npos);
}

TEST(Scan, CountsItsBeamsWithoutMakingThem) {
  for (const auto& entry : std::filesystem::directory_iterator(test_support::sourceFolder() / "resources/sensors")) {
    const Scan scan = scanOf(entry.path().stem().string().c_str());
    const auto beams = beamsOf(scan);
    EXPECT_EQ(beamCount(scan), static_cast<double>(beams.size())) << entry.path();
    const auto last = std::max_element(beams.begin(), beams.end(), [](auto& a, auto& b) { return a.layer < b.layer; });
    EXPECT_EQ(layerCount(scan), static_cast<std::size_t>(last->layer) + 1) << entry.path();
  }
}

}  // namespace
}  // namespace model
