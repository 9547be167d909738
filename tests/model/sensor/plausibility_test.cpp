#include "model/sensor/plausibility.h"

#include <algorithm>
#include <gtest/gtest.h>

#include "core/physics.h"
#include "tests/model/lab.h"
#include "tests/support/paths.h"
#include "tests/support/program.h"

namespace model {
namespace {

using nlohmann::json;

/// The bench's sensor with noise, so that only what a test adds is remarkable.
json sound() {
  json sensor = lab::sensor();
  sensor["receiver"]["noise_w"] = 2e-9;
  sensor["detection"]["range_noise_m"] = 0.01;
  sensor["detection"]["max_range_m"] = 150;
  sensor["detection"]["echo_separation_m"] = 1.0;
  sensor["scan"]["layers"][0]["azimuth_deg"] = {{"from", 1}, {"to", -1}, {"step", 0.15}};
  return sensor;
}

std::vector<Finding> check(const json& sensor) { return plausibilityOf(resolveSensorProfile(sensor, "m.json", "")); }

/// "severity pointer: problem" of the finding at a pointer; "" if there is none.
std::string found(const json& sensor, const std::string& pointer) {
  for (const Finding& finding : check(sensor)) {
    EXPECT_FALSE(finding.reason.empty());
    EXPECT_FALSE(finding.remedy.empty());
    if (finding.pointer == pointer) return toString(finding.severity) + ": " + finding.problem;
  }
  return "";
}

std::string all(const json& sensor) {
  std::string text;
  for (const Finding& finding : check(sensor)) text += finding.pointer + ": " + finding.problem + "\n";
  return text;
}

#define EXPECT_FOUND(sensor, pointer, text) \
  EXPECT_NE(found(sensor, pointer).find(text), std::string::npos) << all(sensor)

TEST(Plausibility, SaysNothingOfASoundProfile) { EXPECT_EQ(all(sound()), ""); }

TEST(Plausibility, PutsTheWorstFirst) {
  json sensor = sound();
  sensor["detection"]["range_noise_m"] = 0;
  sensor["receiver"]["noise_w"] = 1;
  const auto findings = check(sensor);
  ASSERT_GE(findings.size(), 2u);
  EXPECT_EQ(findings.front().severity, Severity::kError);
  EXPECT_EQ(findings.back().severity, Severity::kNote);
}

TEST(Plausibility, FindsLayersThatLookTheSameWay) {
  json sensor = sound();
  sensor["scan"]["layers"].push_back(sensor["scan"]["layers"][0]);
  EXPECT_FOUND(sensor, "/scan/layers/1", "warning: layers 0 and 1 look into the same directions at the same time");
  sensor["scan"]["layers"][1]["time_offset_s"] = 1e-3;
  EXPECT_FOUND(sensor, "/scan/layers/1", "note: layers 0 and 1 look into the same directions, one after the other");
  sensor["scan"]["layers"][1]["azimuth_deg"] = {{"from", 10}, {"to", 8}, {"step", 0.15}};  // side by side
  EXPECT_EQ(found(sensor, "/scan/layers/1"), "");
}

TEST(Plausibility, FindsLayersThatCross) {
  json sensor = sound();
  sensor["scan"]["layers"].push_back(sensor["scan"]["layers"][0]);
  sensor["scan"]["layers"][1]["elevation_curve_deg"] = {0, 0.1};
  EXPECT_FOUND(sensor, "/scan/layers/1", "warning: layers 0 and 1 cross each other.");
}

TEST(Plausibility, FindsCurvesThatLeaveTheSphere) {
  json sensor = sound();
  sensor["scan"]["layers"][0]["elevation_curve_deg"] = {0, 0, 100};
  EXPECT_FOUND(sensor, "/scan/layers/0/elevation_curve_deg", "error: leads to an elevation of 100°");
}

TEST(Plausibility, FindsAStepThatLeadsOutOfItsLayer) {
  json sensor = sound();
  sensor["scan"]["layers"][0]["azimuth_deg"]["step"] = 3;
  EXPECT_FOUND(sensor, "/scan/layers/0/azimuth_deg/step", "warning: is 3°, but 'to' is only 2° away");
}

TEST(Plausibility, FindsATurnThatIsFiredTwice) {
  json sensor = sound();
  sensor["scan"]["layers"][0]["azimuth_deg"] = {{"from", 180}, {"to", -180}, {"step", 0.15}};
  EXPECT_FOUND(sensor, "/scan/layers/0/azimuth_deg", "warning: spans 360°");
}

// Step 0.5°, beam 3 mrad: 50 m · (0.5° - 3 mrad) = 0.286 m.
TEST(Plausibility, TellsGapsBetweenBeams) {
  json sensor = sound();
  sensor["scan"]["layers"][0]["azimuth_deg"]["step"] = 0.5;
  EXPECT_FOUND(sensor, "/scan/layers/0/azimuth_deg/step", "gaps of 0.29 m at 50 m");
  sensor = sound();
  sensor["scan"]["layers"].push_back(sensor["scan"]["layers"][0]);
  sensor["scan"]["layers"][1]["elevation_deg"] = 2.0;
  EXPECT_FOUND(sensor, "/scan/layers", "layers lie up to 2° apart");
}

TEST(Plausibility, TellsBeamsThatOverlap) {
  json sensor = sound();
  sensor["scan"]["layers"][0]["azimuth_deg"]["step"] = 0.05;
  EXPECT_FOUND(sensor, "/emitter/divergence_rad/horizontal", "note: is 3.4 azimuth steps wide");
}

TEST(Plausibility, FindsAFieldOfViewThatCutsTheBeam) {
  json sensor = sound();
  sensor["receiver"]["field_of_view_rad"] = {{"horizontal", 0.01}, {"vertical", 0.002}};
  EXPECT_FOUND(sensor, "/receiver/field_of_view_rad/vertical", "warning: is 0.002 rad, the beam 0.003 rad");
  EXPECT_EQ(found(sensor, "/receiver/field_of_view_rad/horizontal"), "");
}

// Axes 30 mm apart, aperture 20 mm: 20 mm to bridge with half of 6 + 3 mrad (first light) and half of 6 - 3 mrad (all).
TEST(Plausibility, TellsWhereABistaticReceiverBeginsToSee) {
  json sensor = sound();
  sensor["receiver"]["field_of_view_rad"] = {{"horizontal", 0.006}, {"vertical", 0.006}};
  sensor["receiver"]["axis_offset_m"] = 0.03;
  EXPECT_FOUND(sensor, "/receiver/axis_offset_m", "from 4.44 m on, wholly from 13.3 m on; min_range_m is 0.01 m");
}

// 12 columns within a frame of 10 µs: 0.83 µs a column, 125 m.
TEST(Plausibility, FindsShotsThatDoNotWaitForTheLastEcho) {
  json sensor = sound();
  sensor["scan"]["layers"][0]["azimuth_deg"] = {{"from", 11}, {"to", 0}, {"step", 1}};
  sensor["scan"]["frame_rate_hz"] = 1e5;
  sensor["scan"]["duty"] = 1.0;
  EXPECT_FOUND(sensor, "/detection/max_range_m", "warning: light needs 1 µs for it and back, but a row fires again");
  sensor["detection"]["max_range_m"] = 124;
  EXPECT_EQ(found(sensor, "/detection/max_range_m"), "");
  sensor["detection"]["max_range_m"] = 126;
  EXPECT_NE(found(sensor, "/detection/max_range_m"), "");
  sensor["scan"]["firing"] = "at-once";  // the next shot is the next frame
  EXPECT_EQ(found(sensor, "/detection/max_range_m"), "");
}

TEST(Plausibility, FindsALayerThatBelongsToTheNextFrame) {
  json sensor = sound();
  sensor["scan"]["layers"][0]["time_offset_s"] = 100;
  EXPECT_FOUND(sensor, "/scan/layers/0/time_offset_s", "error: is 100 s");
}

TEST(Plausibility, FindsThresholdsInTheNoise) {
  json sensor = sound();
  sensor["receiver"]["noise_w"] = 20e-9;
  EXPECT_FOUND(sensor, "/receiver/threshold_w", "error: is 2e-08 W, not above the noise");
  sensor["receiver"]["noise_w"] = 6e-9;
  EXPECT_FOUND(sensor, "/receiver/threshold_w", "warning: is 3.3 times the noise");
  sensor["receiver"]["noise_w"] = 0;
  EXPECT_FOUND(sensor, "/receiver/noise_w", "note: is 0.");
}

TEST(Plausibility, FindsASaturationThatLeavesNothing) {
  json sensor = sound();
  sensor["receiver"]["saturation_w"] = 1e-9;
  EXPECT_FOUND(sensor, "/receiver/saturation_w", "error: is 1e-09 W, not above the threshold");
  sensor["receiver"]["saturation_w"] = 5e-8;
  EXPECT_FOUND(sensor, "/receiver/saturation_w", "warning: is reached by a target of 10 % already");
}

TEST(Plausibility, FindsASensorThatDoesNotReachItsWindow) {
  json sensor = sound();
  sensor["emitter"]["peak_power_w"] = 1.0;
  EXPECT_FOUND(sensor, "/detection/max_range_m", "warning: is 150 m, but a target of 80 % is seen up to");
  sensor["receiver"]["efficiency"] = 0.0;
  EXPECT_FOUND(sensor, "/receiver/threshold_w", "error: a target of 80 % is seen up to 0 m");
  sensor = sound();
  sensor["emitter"]["peak_power_w"] = 5e4;
  EXPECT_FOUND(sensor, "/receiver/threshold_w", "note: would show a target of 10 %");
}

TEST(Plausibility, FindsDegreesInPlaceOfRadians) {
  json sensor = sound();
  sensor["emitter"]["divergence_rad"]["vertical"] = 0.784;
  EXPECT_FOUND(sensor, "/emitter/divergence_rad", "warning: is 0.784 rad (44.9°) wide");
}

TEST(Plausibility, ComparesPulseSeparationAndSteps) {
  json sensor = sound();
  sensor["detection"]["echo_separation_m"] = 0.5;  // the pulse is 0.75 m long
  EXPECT_FOUND(sensor, "/detection/echo_separation_m", "note: is 0.5 m, shorter than the pulse (0.75 m)");
  sensor["detection"]["echo_separation_m"] = 9;
  EXPECT_FOUND(sensor, "/detection/echo_separation_m", "note: is 9 m, 12 pulse lengths");
  sensor["detection"]["range_resolution_m"] = 0.8;
  EXPECT_FOUND(sensor, "/detection/range_resolution_m", "warning: is 0.8 m, longer than the pulse");
  sensor["emitter"]["pulse_fwhm_ns"] = 4500;
  EXPECT_FOUND(sensor, "/emitter/pulse_fwhm_ns", "warning: is 4500 ns");
}

TEST(Plausibility, CountsBeamsThatSendNothing) {
  json sensor = sound();
  sensor["scan"]["layers"][0]["azimuth_gain"] = {{"azimuth_deg", {0.2, 0.3}}, {"gain", {0, 1}}};
  EXPECT_FOUND(sensor, "/scan/layers", "note: 8 of 14 beams have an azimuth_gain of 0");
  sensor["scan"]["layers"][0]["azimuth_gain"]["gain"] = {0, 0};
  EXPECT_FOUND(sensor, "/scan/layers", "error: 14 of 14");
}

TEST(Sensors, OneIsDescribedWithCheckAndBudget) {
  const auto text = test_support::runFidelis({"sensors", "valeo-scala-1"});
  EXPECT_EQ(text.status, 0) << text.messages;
  EXPECT_NE(text.out.find("3486 a frame in 6 layers"), std::string::npos) << text.out;
  EXPECT_NE(text.out.find("visibility 500 m"), std::string::npos);
  EXPECT_NE(text.out.find("one after the other"), std::string::npos);
  const auto run = test_support::runFidelis({"sensors", "valeo-scala-1", "--json", "-"});
  const json described = json::parse(run.out);
  EXPECT_EQ(described["sensor"]["id"], "valeo-scala-1");
  ASSERT_EQ(described["link_budget"].size(), 9u);
  EXPECT_NEAR(described["link_budget"][3]["range_half_m"].get<double>(), 200.0, 1.0);
  EXPECT_TRUE(described["link_budget"][3]["visibility_m"].is_null());
  EXPECT_FALSE(described["findings"].empty());
}

TEST(Sensors, AFileIsCheckedAndAnErrorIsTheExitStatus) {
  const test_support::TemporaryFolder folder;
  EXPECT_EQ(test_support::runFidelis({"sensors", folder.write("good.json", sound().dump()).string()}).status, 0);
  json bad = sound();
  bad["receiver"]["noise_w"] = 1;
  const auto run = test_support::runFidelis({"sensors", folder.write("bad.json", bad.dump()).string()});
  EXPECT_EQ(run.status, 1);
  EXPECT_NE(run.out.find("error: /receiver/threshold_w"), std::string::npos) << run.out;
  const auto absent = test_support::runFidelis({"sensors", (folder / "absent.json").string()});
  EXPECT_EQ(absent.status, 2);
  const auto typo = test_support::runFidelis({"sensors", "valeo-skala-1"});
  EXPECT_EQ(typo.status, 2);
  EXPECT_NE(typo.messages.find("Did you mean 'valeo-scala-1'?"), std::string::npos) << typo.messages;
  const auto not_a_number = test_support::runFidelis({"sensors", folder.write("nan.json", R"({"id": NaN})").string()});
  EXPECT_EQ(not_a_number.status, 2);
  EXPECT_NE(not_a_number.messages.find("not valid JSON"), std::string::npos);
  EXPECT_EQ(test_support::runFidelis({"sensors", "--svg", "-"}).status, 2);
}

TEST(Sensors, APictureIsDrawnOfEveryShippedOne) {
  for (const auto& entry : std::filesystem::directory_iterator(test_support::sourceFolder() / "resources/sensors")) {
    const auto run = test_support::runFidelis({"sensors", entry.path().stem().string(), "--svg", "-"});
    EXPECT_EQ(run.status, 0) << run.messages;
    EXPECT_EQ(run.out.rfind("<svg", 0), 0u);
    EXPECT_LT(run.out.size(), 400'000u) << entry.path();
  }
}

}  // namespace
}  // namespace model
