#include "model/sensor/sensor_profile.h"

#include <cmath>
#include <gtest/gtest.h>

#include "model/sensor/beams.h"
#include "tests/model/lab.h"
#include "tests/support/paths.h"

namespace model {
namespace {

std::string refusalOf(const nlohmann::json& profile) {
  return lab::refusal([&] { (void)resolveSensorProfile(profile, "m.json", "/sensor"); });
}

TEST(SensorProfile, IsReadAsWritten) {
  nlohmann::json json = lab::sensor();
  json["emitter"]["beam_profile"] = "gaussian";
  json["scan"]["direction"] = "right-to-left";
  json["detection"]["range_mode"] = "centre";
  json["receiver"]["saturation_w"] = nullptr;
  const SensorProfile profile = resolveSensorProfile(json, "m.json", "/sensor");
  EXPECT_EQ(profile.emitter.beam_profile, BeamProfile::kGaussian);
  EXPECT_FALSE(profile.scan.left_to_right);
  EXPECT_EQ(profile.detection.range_mode, RangeMode::kCentre);
  EXPECT_FALSE(profile.receiver.saturation_w.has_value());
  EXPECT_EQ(profile.emitter.divergence.vertical_rad, 0.003);
  EXPECT_EQ(profile.detection.output.size(), 3u);
}

TEST(SensorProfile, FaultsAreNamedWithPointer) {
  nlohmann::json json = lab::sensor();
  json["receiver"]["treshold_w"] = 1e-9;
  EXPECT_NE(
      refusalOf(json).find("m.json, /sensor/receiver/treshold_w: is an unknown key.\n  Did you mean 'threshold_w'?"),
      std::string::npos);
  json = lab::sensor();
  json["scan"]["layers"][0]["azimuth_deg"]["step"] = 0;
  EXPECT_NE(refusalOf(json).find("/sensor/scan/layers/0/azimuth_deg/step: is 0; it must be greater than 0"),
            std::string::npos);
  json = lab::sensor();
  json["emitter"].erase("pulse_fwhm_ns");
  EXPECT_NE(refusalOf(json).find("/sensor/emitter/pulse_fwhm_ns: is missing."), std::string::npos);
  json = lab::sensor();
  json["detection"]["range_mode"] = "center";
  EXPECT_NE(refusalOf(json).find("Did you mean 'centre'?"), std::string::npos);
  json = lab::sensor();
  json["scan"]["layers"] = nlohmann::json::array();
  EXPECT_NE(refusalOf(json).find("/sensor/scan/layers"), std::string::npos);
  EXPECT_NE(refusalOf(5).find("/sensor: is a number"), std::string::npos);
  json = lab::sensor();
  json["emitter"]["divergence_rad"]["vertical"] = 0;
  EXPECT_NE(refusalOf(json).find("/sensor/emitter/divergence_rad/vertical: is 0; every beam has a width."),
            std::string::npos);
  json = lab::sensor();
  json["emitter"]["peak_power_w"] = -50;
  EXPECT_NE(refusalOf(json).find("/sensor/emitter/peak_power_w: is -50"), std::string::npos);
  json = lab::sensor();
  json["receiver"]["threshold_w"] = 0;
  EXPECT_NE(refusalOf(json).find("/sensor/receiver/threshold_w: is 0; it must be greater than 0"), std::string::npos);
  json = lab::sensor();
  json["emitter"]["peak_power_w"] = std::nan("");
  EXPECT_NE(refusalOf(json).find("/sensor/emitter/peak_power_w: is nan"), std::string::npos);
  json = lab::sensor();
  json["detection"]["min_range_m"] = 2000;
  EXPECT_NE(refusalOf(json).find("/sensor/detection/min_range_m: is not below max_range_m"), std::string::npos);
  json = lab::sensor();
  json["detection"]["output"] = {"range", "intensty"};
  EXPECT_NE(refusalOf(json).find("/sensor/detection/output/1: 'intensty' is no output.\n  Did you mean 'intensity'?"),
            std::string::npos);
}

std::vector<std::string> shippedIds() {
  std::vector<std::string> ids;
  for (const auto& entry : std::filesystem::directory_iterator(test_support::sourceFolder() / "resources/sensors")) {
    ids.push_back(entry.path().stem().string());
  }
  return ids;
}

TEST(SensorProfile, EveryShippedOneIsReadAndNamesItsSource) {
  const auto ids = shippedIds();
  EXPECT_GE(ids.size(), 2u);
  for (const std::string& id : ids) {
    const SensorProfile profile = resolveSensorProfile(id, "m.json", "/sensor");
    EXPECT_EQ(profile.id, id);
    EXPECT_FALSE(profile.title.empty());
    EXPECT_FALSE(profile.source.empty());
    EXPECT_GT(profile.receiver.threshold_w, 3.0 * profile.receiver.noise_w);  // the chain knows no false alarms
  }
}

TEST(SensorProfile, UnknownIdSuggestsTheNearest) {
  EXPECT_NE(refusalOf("ibeo-lux-2011").find("Did you mean 'ibeo-lux-2010'?"), std::string::npos);
}

// EPW of a 50 % diffuse target as the public facts tabulate it: c · 4.5 ns + 0.03 m + 0.65, 0.61 and 0.45 m.
TEST(SensorProfile, LuxHasThePublishedEchoPulseWidths) {
  for (const auto& [range_m, epw_m] : {std::pair{10.0, 2.029}, {15.0, 1.989}, {20.0, 1.829}}) {
    lab::Case setup;
    setup.sensor = sensorProfileJson("ibeo-lux-2010", "m.json", "/sensor");
    setup.sensor["scan"]["layers"] = {{{"elevation_deg", 0}, {"azimuth_deg", {{"from", 0}, {"to", 0}, {"step", 1}}}}};
    setup.scene = {lab::board(range_m)};
    setup.frames = 200;
    EXPECT_NEAR(lab::mean(lab::fire(setup).epw_m), epw_m, 0.1) << range_m;
  }
}

// 202 azimuths of the two lower layers, 193 of the two upper ones (public facts).
TEST(SensorProfile, LuxFires790BeamsAFrame) {
  EXPECT_EQ(beamsOf(resolveSensorProfile("ibeo-lux-2010", "m.json", "/sensor").scan).size(), 790u);
}

}  // namespace
}  // namespace model
