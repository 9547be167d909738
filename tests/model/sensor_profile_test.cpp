#include "model/sensor_profile.h"

#include <gtest/gtest.h>

#include "tests/model/lab.h"

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
  EXPECT_NE(refusalOf(json).find("m.json, /sensor/receiver/treshold_w: is an unknown key.\n  Did you mean 'threshold_w'?"),
            std::string::npos);
  json = lab::sensor();
  json["scan"]["layers"][0]["azimuth_deg"]["step"] = 0;
  EXPECT_NE(refusalOf(json).find("/sensor/scan/layers/0/azimuth_deg/step: is 0; it must be greater than 0"), std::string::npos);
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
}

}  // namespace
}  // namespace model
