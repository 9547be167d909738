#include "model/experiment.h"

#include <cmath>
#include <gtest/gtest.h>
#include <set>

#include "core/file.h"
#include "tests/model/lab.h"
#include "tests/support/paths.h"

namespace model {
namespace {

using nlohmann::json;

json package() {
  lab::Case setup;
  setup.scene = {lab::board(10)};
  setup.environment = {{"temperature_degC", 20}, {"visibility_m", nullptr}};
  return lab::experimentJson(setup);
}

std::string refusalOf(const json& value) {
  return lab::refusal([&] { (void)parseExperiment(value, "pkg/experiment.json"); });
}

TEST(Experiment, DefaultsAreThoseOfTheFormat) {
  const Experiment experiment = parseExperiment(package(), "pkg/experiment.json");
  EXPECT_EQ(experiment.samples[0].role, Role::kValidation);
  EXPECT_EQ(experiment.samples[0].setup, "s");  // every sample its own set-up
  EXPECT_TRUE(experiment.sensors.empty());
  EXPECT_FALSE(experiment.synthetic());
  const Situation situation = situationOf(experiment, experiment.samples[0]);
  EXPECT_EQ(situation.environment.temperature_degC, 20.0);
  EXPECT_FALSE(situation.environment.visibility_m.has_value());  // null: nobody recorded it
}

TEST(Experiment, PatchChangesOneSampleOnly) {
  json value = package();
  value["samples"].push_back(
      {{"id", "far"},
       {"frames", 1},
       {"patch",
        {{{"op", "replace"}, {"path", "/scene/0/pose/position_m/0"}, {"value", 25}},
         {{"op", "add"}, {"path", "/environment/rain_rate_mm_h"}, {"value", 4}},
         {{"op", "add"}, {"path", "/scene/-"}, {"value", lab::board(30, 1, "grey", "second")}}}}});
  const Experiment experiment = parseExperiment(value, "pkg/experiment.json");
  EXPECT_EQ(situationOf(experiment, experiment.samples[0]).scene.objects[0].pose.position_m[0], 10.0);
  const Situation patched = situationOf(experiment, experiment.samples[1]);
  EXPECT_EQ(patched.scene.objects[0].pose.position_m[0], 25.0);
  EXPECT_EQ(patched.scene.objects.size(), 2u);
  EXPECT_EQ(patched.environment.rain_rate_mm_h, 4.0);
}

TEST(Experiment, FaultyPatchNamesItsSample) {
  json value = package();
  value["samples"][0]["patch"] = {{{"op", "replace"}, {"path", "/scene/7/pose"}, {"value", 1}}};
  EXPECT_NE(refusalOf(value).find("sample 's', patch: cannot be applied"), std::string::npos);
  value["samples"][0]["patch"] = {{{"op", "add"}, {"path", "/enviroment"}, {"value", json::object()}}};
  EXPECT_NE(refusalOf(value).find("Did you mean '/environment'?"), std::string::npos);
  value["samples"][0]["patch"] = {{{"op", "add"}, {"path", "/scene/0/material"}, {"value", "gray"}}};
  EXPECT_NE(refusalOf(value).find("Did you mean 'grey'?"), std::string::npos);
}

TEST(Experiment, EpistemicCornersAreCentreAndAllCombinations) {
  json value = package();
  value["samples"][0]["epistemic"] = {{{"path", "/scene/0/pose/position_m/0"}, {"offset_interval", {-0.002, 0.003}}},
                                      {{"path", "/scene/0/pose/yaw_pitch_roll_deg/0"}, {"offset_interval", {-1, 1}}}};
  const Experiment experiment = parseExperiment(value, "pkg/experiment.json");
  const auto corners = epistemicCorners(experiment.samples[0]);
  ASSERT_EQ(corners.size(), 5u);
  EXPECT_EQ(corners[0], (EpistemicOffsets{0.0, 0.0}));
  EXPECT_EQ(std::set<EpistemicOffsets>(corners.begin(), corners.end()).size(), 5u);
  const Situation corner = situationOf(experiment, experiment.samples[0], {-0.002, 1.0});
  EXPECT_NEAR(corner.scene.objects[0].pose.position_m[0], 9.998, 1e-12);
  EXPECT_EQ(corner.scene.objects[0].pose.yaw_deg, 1.0);
  EXPECT_EQ(epistemicCorners(Sample{}).size(), 1u);
}

TEST(Experiment, FaultyEpistemicQuantitiesAreRefused) {
  json value = package();
  value["samples"][0]["epistemic"] = {{{"path", "/scene/0/pose/position_m/9"}, {"offset_interval", {-1, 1}}}};
  EXPECT_NE(refusalOf(value).find("does not lead anywhere"), std::string::npos);
  value["samples"][0]["epistemic"] = {{{"path", "/scene/0/id"}, {"offset_interval", {-1, 1}}}};
  EXPECT_NE(refusalOf(value).find("does not point to a number"), std::string::npos);
  value["samples"][0]["epistemic"] = {{{"path", "/scene/0/pose/position_m/0"}, {"offset_interval", {1, -1}}}};
  EXPECT_NE(refusalOf(value).find("wrong order"), std::string::npos);
}

TEST(Experiment, UnknownKeysAreNamedWithTheNearestOne) {
  json value = package();
  value["enviroment"] = value["environment"];
  value.erase("environment");
  EXPECT_EQ(refusalOf(value),
            "pkg/experiment.json, /enviroment: is an unknown key.\n  Did you mean 'environment'? Keys of your own "
            "begin with 'x-'.");
  value = package();
  value["samples"][0]["fames"] = 3;
  EXPECT_NE(refusalOf(value).find("/samples/0/fames: is an unknown key.\n  Did you mean 'frames'?"), std::string::npos);
  value = package();
  value["environment"]["visibilty_m"] = 3;
  EXPECT_NE(refusalOf(value).find("/environment/visibilty_m"), std::string::npos);
  value = package();
  value["columns"] = {{"rage_m", "Distance"}};
  EXPECT_NE(refusalOf(value).find("/columns/rage_m: is an unknown key.\n  Did you mean 'range_m'?"), std::string::npos);
}

TEST(Experiment, MissingAndDoubledPartsAreRefused) {
  json value = package();
  value.erase("samples");
  EXPECT_NE(refusalOf(value).find("/samples"), std::string::npos);
  value = package();
  value["samples"].push_back(value["samples"][0]);
  EXPECT_NE(refusalOf(value).find("/samples/1/id: 's' stands twice"), std::string::npos);
  value = package();
  value["measurands"] = json::array();
  EXPECT_NE(refusalOf(value).find("/measurands"), std::string::npos);
  value = package();
  value["samples"][0]["frames"] = 0;
  EXPECT_NE(refusalOf(value).find("/samples/0/frames"), std::string::npos);
  value = package();
  value["version"] = 2;
  EXPECT_NE(refusalOf(value).find("Use a newer Fidelis."), std::string::npos);
}

TEST(Experiment, MissingSensorProfileIsNamed) {
  json value = package();
  value["sensor"] = "no-such-scanner";
  EXPECT_NE(refusalOf(value).find("pkg/experiment.json, /sensor: there is no sensor profile 'no-such-scanner'."),
            std::string::npos);
}

TEST(Experiment, SamplesOfSeveralSensorsNameTheirs) {
  json value = package();
  value["sensors"] = {{"left", value["sensor"]}, {"right", value["sensor"]}};
  value.erase("sensor");
  EXPECT_NE(refusalOf(value).find("/samples/0/sensor: is missing"), std::string::npos);
  value["samples"][0]["sensor"] = "rigth";
  EXPECT_NE(refusalOf(value).find("Did you mean 'right'?"), std::string::npos);
  value["samples"][0]["sensor"] = "right";
  const Experiment experiment = parseExperiment(value, "pkg/experiment.json");
  EXPECT_EQ(experiment.samples[0].sensor, "right");
  EXPECT_EQ(experiment.sensors, (std::vector<std::string>{"left", "right"}));
}

TEST(Experiment, FilesOutsideThePackageAreRefused) {
  for (const std::string path : {"../x.csv", "/tmp/x.csv", "a/../../x.csv", "", "sub/", "."}) {
    for (const std::string key : {"measurements", "beams"}) {
      json value = package();
      value["samples"][0][key] = path;
      EXPECT_NE(
          refusalOf(value).find("/samples/0/" + key + ": '" + path + "' does not name a file inside the package."),
          std::string::npos)
          << key << " " << path;
    }
  }
  json value = package();
  value["samples"][0]["measurements"] = "a/../b/x.csv";
  EXPECT_EQ(refusalOf(value), "");
}

TEST(Experiment, UnknownSampleOrMeasurandSuggestsTheNearest) {
  const Experiment experiment = parseExperiment(package(), "pkg/experiment.json");
  EXPECT_EQ(experiment.measurand("range").column, "range_m");
  EXPECT_NE(lab::refusal([&] { (void)experiment.measurand("rnage"); }).find("Did you mean 'range'?"),
            std::string::npos);
  EXPECT_NE(lab::refusal([&] { (void)experiment.sampleIndex("S1"); }).find("has no sample 'S1'"), std::string::npos);
}

core::Detections detectionsAt(const std::vector<Vector3>& points) {
  core::Detections detections;
  for (const Vector3& p : points) {
    detections.frame.push_back(0);
    detections.layer.push_back(0);
    detections.echo.push_back(1);
    detections.range_m.push_back(std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]));
    detections.azimuth_rad.push_back(std::atan2(p[1], p[0]));
    detections.elevation_rad.push_back(std::atan2(p[2], std::hypot(p[0], p[1])));
  }
  return detections;
}

TEST(Experiment, GateSelectsWhatLiesInTheWidenedBox) {
  json value = package();
  value["scene"] = {lab::object("car", {{"type", "box"}, {"size_m", {4, 2, 1}}}, {10, 0, 0}, {90, 0, 0})};
  value["gates"] = {{{"id", "g"}, {"object", "car"}, {"margin_m", 0.1}}};
  const Experiment experiment = parseExperiment(value, "pkg/experiment.json");
  const Situation situation = situationOf(experiment, experiment.samples[0]);
  // Turned by 90°: 2 m along x, 4 m along y.
  const auto inside =
      insideGate(detectionsAt({{8.95, 0, 0}, {8.85, 0, 0}, {10, 2.05, 0}, {10, 2.15, 0}, {10, 0, 0.59}, {10, 0, 0.61}}),
                 situation, experiment.gates[0]);
  EXPECT_EQ(inside.size(), 3u);
  value["gates"][0]["object"] = "van";
  EXPECT_NE(refusalOf(value).find("/gates/0/object: 'van' is not in the scene."), std::string::npos);
}

TEST(Experiment, GateOfAMeshIsTheMeshsOwnBox) {
  const test_support::TemporaryFolder folder;
  (void)folder.write("t.obj", "v 0 0 0\nv 1 0 0\nv 0 2 0\nv 0 0 3\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
  json value = package();
  value["scene"] = {lab::object("t", {{"type", "mesh"}, {"file", "t.obj"}}, {10, 0, 0})};
  value["gates"] = {{{"id", "g"}, {"object", "t"}, {"margin_m", 0.1}}};
  const Experiment experiment = parseExperiment(value, folder / "experiment.json");
  const auto inside =
      insideGate(detectionsAt({{10.5, 1, 1}, {9.95, 0, 0}, {9.8, 0, 0}, {10, -0.2, 0}, {11.05, 1, 2.9}}),
                 situationOf(experiment, experiment.samples[0]), experiment.gates[0]);
  EXPECT_EQ(inside.size(), 3u);
}

TEST(Experiment, MeasurementsAreReadWithMappedColumnsAndGzip) {
  const test_support::TemporaryFolder folder;
  std::filesystem::create_directories(folder / "measurements");
  core::writeFile(folder / "measurements/s.csv.gz",
                  "frame,layer,azimuth_rad,elevation_rad,Distance,w,other\r\n3,1,0.1,-0.2,9.5,2.25,7\r\n");
  json value = package();
  value["columns"] = {{"range_m", "Distance"}, {"epw_m", "w"}};
  value["samples"][0]["measurements"] = "measurements/s.csv.gz";
  const Experiment experiment = parseExperiment(value, folder / "experiment.json");
  const core::Detections detections = readMeasurements(experiment, experiment.samples[0]);
  ASSERT_EQ(detections.size(), 1u);
  EXPECT_EQ(detections.frame[0], 3);
  EXPECT_EQ(detections.echo[0], 1);  // no such column: every detection is echo 1
  EXPECT_EQ(detections.range_m[0], 9.5);
  EXPECT_EQ(detections.epw_m[0], 2.25);
  EXPECT_TRUE(detections.hasDirections());
  EXPECT_TRUE(detections.intensity.empty());
}

TEST(Experiment, PointCloudsGetTheLayersOfTheBeamsFired) {
  const test_support::TemporaryFolder folder;
  (void)folder.write("beams.csv", "layer,azimuth_rad,elevation_rad\n4,0.1,0\n6,0.1,0.02\n");
  (void)folder.write("s.pcd",
                     "VERSION 0.7\nFIELDS x y z w\nSIZE 4 4 4 4\nTYPE F F F F\nCOUNT 1 1 1 1\nWIDTH 2\nHEIGHT 1\n"
                     "POINTS 2\nDATA ascii\n10 1 0.3 2.5\n10 1 -0.1 2.25\n");
  json value = package();
  value["columns"] = {{"epw_m", "w"}};
  value["samples"][0]["measurements"] = "s.pcd";
  value["samples"][0]["beams"] = "beams.csv";
  const Experiment experiment = parseExperiment(value, folder / "experiment.json");
  const core::Detections detections = readMeasurements(experiment, experiment.samples[0]);
  EXPECT_EQ(detections.layer, (std::vector<std::int32_t>{6, 4}));
  EXPECT_EQ(detections.epw_m, (std::vector<double>{2.5, 2.25}));
  value["samples"][0].erase("beams");
  const Experiment scanned = parseExperiment(value, folder / "experiment.json");
  EXPECT_EQ(readMeasurements(scanned, scanned.samples[0]).layer.size(), 2u);
}

TEST(Experiment, DirectionsMayBeUnrecorded) {
  const test_support::TemporaryFolder folder;
  (void)folder.write("s.csv", "frame,range_m\n0,9.5\n1,9.6\n");
  (void)folder.write("half.csv", "frame,azimuth_rad,range_m\n0,0,9.5\n");
  json value = package();
  value["samples"][0]["measurements"] = "s.csv";
  const Experiment experiment = parseExperiment(value, folder / "experiment.json");
  EXPECT_FALSE(readMeasurements(experiment, experiment.samples[0]).hasDirections());
  value["samples"][0]["measurements"] = "half.csv";
  const Experiment half = parseExperiment(value, folder / "experiment.json");
  EXPECT_NE(lab::refusal([&] { (void)readMeasurements(half, half.samples[0]); }).find("only some of the columns"),
            std::string::npos);
}

TEST(Experiment, FilesOfASampleAreAllItDependsOn) {
  json value = package();
  value["scene"].push_back(lab::object("m", {{"type", "mesh"}, {"file", "meshes/m.obj"}}, {5, 0, 0}));
  value["samples"][0]["measurements"] = "s.csv";
  value["samples"][0]["beams"] = "beams.csv";
  const Experiment experiment = parseExperiment(value, "pkg/experiment.json");
  EXPECT_EQ(
      filesOf(experiment, experiment.samples[0]),
      (std::vector<std::filesystem::path>{"pkg/experiment.json", "pkg/s.csv", "pkg/beams.csv", "pkg/meshes/m.obj"}));
}

}  // namespace
}  // namespace model
