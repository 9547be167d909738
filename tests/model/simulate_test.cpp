#include "model/simulate.h"

#include <cmath>
#include <fstream>
#include <gtest/gtest.h>

#include "core/detection_files/detection_file.h"
#include "core/error.h"
#include "core/file.h"
#include "core/parallel.h"
#include "tests/model/lab.h"
#include "tests/support/paths.h"
#include "tests/support/program.h"

namespace model {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

/// A noisy scan over a wall with a post before it: several echoes, several layers, partial hits.
lab::Case busyCase() {
  lab::Case setup;
  setup.sensor["scan"]["layers"] = {
      {{"elevation_deg", 0.0}, {"azimuth_deg", {{"from", 20}, {"to", -20}, {"step", 0.25}}}},
      {{"elevation_deg", -2.0}, {"azimuth_deg", {{"from", 20}, {"to", -20}, {"step", 0.25}}}}};
  setup.sensor["receiver"]["noise_w"] = 4e-9;
  setup.sensor["detection"]["range_noise_m"] = 0.01;
  setup.sensor["detection"]["epw_noise_m"] = 0.03;
  setup.rays_per_beam = {5, 5};
  setup.effects = {{"beam-divergence", json::object()},
                   {"pulse-broadening", json::object()},
                   {"detection-loss", {{"probability", 0.1}}}};
  setup.scene = {lab::board(30, 60),
                 lab::object("post", {{"type", "cylinder"}, {"radius_m", 0.1}, {"height_m", 4}}, {12, 0.5, 0})};
  setup.frames = 5;
  return setup;
}

std::string bytesOf(const lab::Case& setup, const test_support::TemporaryFolder& folder) {
  core::writeDetections(folder / "d.csv", lab::fire(setup));
  return core::readFile(folder / "d.csv");
}

TEST(Simulate, SameBytesWithOneAndTwoThreads) {
  const test_support::TemporaryFolder folder;
  core::limitThreads(1);
  const std::string one = bytesOf(busyCase(), folder);
  core::limitThreads(2);
  const std::string two = bytesOf(busyCase(), folder);
  core::limitThreads(0);
  EXPECT_GT(one.size(), 10000u);
  EXPECT_EQ(one, two);
}

TEST(Simulate, SeedDecidesAndNothingElse) {
  const test_support::TemporaryFolder folder;
  lab::Case setup = busyCase();
  const std::string first = bytesOf(setup, folder);
  EXPECT_EQ(bytesOf(setup, folder), first);
  setup.seed = 8;
  EXPECT_NE(bytesOf(setup, folder), first);
}

TEST(Simulate, OwnBeamsReplaceTheScan) {
  const test_support::TemporaryFolder folder;
  (void)folder.write("beams.csv", "layer,azimuth_rad,elevation_rad,time_s\n0,0.3,0.1,0.001\n2,-0.2,0,0.002\n");
  lab::Case setup;
  setup.scene = {lab::board(10, 60)};
  setup.file = folder / "experiment.json";
  json value = lab::experimentJson(setup);
  value["samples"][0]["beams"] = "beams.csv";
  const auto detections = simulate(parseExperiment(value, setup.file), lab::modelOf(setup), 0);
  ASSERT_EQ(detections.size(), 2u);
  EXPECT_EQ(detections.layer, (std::vector<std::int32_t>{0, 2}));
  EXPECT_EQ(detections.azimuth_rad[0], 0.3);
  EXPECT_EQ(detections.time_s[1], 0.002);
  EXPECT_NEAR(detections.range_m[0], 10 / std::cos(0.3) / std::cos(0.1), 1e-6);
}

// The gain of the scan over azimuth holds for beams that were listed one by one, too.
TEST(Simulate, OwnBeamsHaveTheGainOfTheScan) {
  const test_support::TemporaryFolder folder;
  (void)folder.write("beams.csv", "layer,azimuth_rad,elevation_rad\n0,0,0\n0,0.1745329252,0\n");
  lab::Case setup;
  setup.scene = {lab::board(10, 60)};
  setup.file = folder / "experiment.json";
  setup.sensor["scan"]["layers"][0]["azimuth_gain"] = {{"azimuth_deg", {0, 10}}, {"gain", {1.0, 0.5}}};
  json value = lab::experimentJson(setup);
  value["samples"][0]["beams"] = "beams.csv";
  const auto detections = simulate(parseExperiment(value, setup.file), lab::modelOf(setup), 0);
  ASSERT_EQ(detections.size(), 2u);
  EXPECT_NEAR(1e-9 * detections.intensity[0] / lab::radarEquation(10), 1.0, 1e-5);
  const double slanted = std::cos(0.1745329252);
  EXPECT_NEAR(1e-9 * detections.intensity[1] / lab::radarEquation(10 / slanted, 0.5, slanted), 0.5, 1e-5);
}

TEST(Simulate, EachSampleHasItsOwnSensor) {
  lab::Case setup;
  setup.scene = {lab::board(10)};
  json experiment = lab::experimentJson(setup), model = lab::modelJson(setup);
  json off = lab::sensor();
  off["detection"]["max_range_m"] = 5;
  experiment["sensors"] = {{"a", lab::sensor()}, {"b", off}};
  experiment.erase("sensor");
  experiment["samples"] = {{{"id", "s1"}, {"frames", 1}, {"sensor", "a"}},
                           {{"id", "s2"}, {"frames", 1}, {"sensor", "b"}}};
  model["sensors"] = experiment["sensors"];
  model.erase("sensor");
  const Experiment parsed = parseExperiment(experiment, "experiment.json");
  const LidarModel lidar = parseModel(model, "model.json");
  EXPECT_EQ(simulate(parsed, lidar, 0).size(), 1u);
  EXPECT_EQ(simulate(parsed, lidar, 1).size(), 0u);
}

TEST(Simulate, EpistemicOffsetsMoveTheTarget) {
  lab::Case setup;
  setup.scene = {lab::board(10)};
  json value = lab::experimentJson(setup);
  value["samples"][0]["epistemic"] = {{{"path", "/scene/0/pose/position_m/0"}, {"offset_interval", {-0.5, 0.5}}}};
  const Experiment experiment = parseExperiment(value, "experiment.json");
  EXPECT_NEAR(simulate(experiment, lab::modelOf(setup), 0, {0.5}).range_m.at(0), 10.5, 1e-5);
}

class SimulatedPackage : public ::testing::Test {
 protected:
  void SetUp() override {
    setup_ = busyCase();
    setup_.file = folder_ / "in/experiment.json";
    json value = lab::experimentJson(setup_);
    value["scene"].push_back(lab::object("mesh", {{"type", "mesh"}, {"file", "meshes/t.obj"}}, {9, -1, 0}));
    value["columns"] = {{"range_m", "Distance"}};
    value["samples"] = {
        {{"id", "s/1"}, {"frames", 2}},
        {{"id", "s2"}, {"frames", 2}, {"measurements", "measurements/two.csv.gz"}, {"beams", "beams.csv"}}};
    (void)folder_.write("in/meshes/t.obj", "v 0 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\n");
    (void)folder_.write("in/beams.csv", "layer,azimuth_rad,elevation_rad\n0,0,0\n");
    core::writeJson(folder_ / "in/experiment.json", value);
    core::writeJson(folder_ / "model.json", lab::modelJson(setup_));
  }
  void simulateInto(const fs::path& out, core::Progress& progress) {
    simulatePackage(readExperiment(folder_ / "in"), readModel(folder_ / "model.json"), out, std::nullopt, progress);
  }
  std::size_t entriesBeside() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_.path()), {}));
  }

  test_support::TemporaryFolder folder_;
  lab::Case setup_;
  core::SilentProgress silent_;
};

TEST_F(SimulatedPackage, IsAnExperimentPackageAgain) {
  simulateInto(folder_ / "out/", silent_);
  const Experiment again = readExperiment(folder_ / "out");
  EXPECT_TRUE(again.synthetic());
  EXPECT_TRUE(fs::exists(folder_ / "out/meshes/t.obj"));
  EXPECT_TRUE(fs::exists(folder_ / "out/beams.csv"));
  EXPECT_TRUE(fs::exists(folder_ / "out/measurements/s_1.csv"));
  EXPECT_EQ(readMeasurements(again, again.samples[1]).size(),
            simulate(again, readModel(folder_ / "model.json"), 1).size());
  EXPECT_EQ(entriesBeside(), 3u);  // in, model.json, out
}

TEST_F(SimulatedPackage, FillsAnEmptyFolderAndRefusesAnyOther) {
  fs::create_directories(folder_ / "out");
  simulateInto(folder_ / "out", silent_);
  EXPECT_TRUE(fs::exists(folder_ / "out/experiment.json"));
  EXPECT_NE(lab::refusal([&] { simulateInto(folder_ / "out", silent_); }).find("is not an empty folder"),
            std::string::npos);
  EXPECT_NE(lab::refusal([&] { simulateInto(folder_ / "model.json", silent_); }).find("is not an empty folder"),
            std::string::npos);
  EXPECT_NE(lab::refusal([&] { simulateInto(folder_ / "no/such/parent", silent_); }).find("cannot be written"),
            std::string::npos);
}

class CancelledAtTheSecondSample final : public core::Progress {
 public:
  void report(double, std::string_view) override { ++reports_; }
  [[nodiscard]] bool cancelled() const override { return reports_ >= 1; }

 private:
  int reports_ = 0;
};

TEST_F(SimulatedPackage, LeavesNothingBehindWhenCancelled) {
  CancelledAtTheSecondSample progress;
  EXPECT_THROW(simulateInto(folder_ / "out", progress), core::Cancelled);
  EXPECT_EQ(entriesBeside(), 2u);
}

TEST_F(SimulatedPackage, LeavesNothingBehindWhenAFileIsMissing) {
  fs::remove(folder_ / "in/meshes/t.obj");
  EXPECT_THROW(simulateInto(folder_ / "out", silent_), core::InputError);
  EXPECT_EQ(entriesBeside(), 2u);
}

TEST_F(SimulatedPackage, TakesNoFilesFromOutside) {
  json value = core::readJson(folder_ / "in/experiment.json");
  value["scene"].back()["shape"]["file"] = "../t.obj";
  (void)folder_.write("t.obj", "v 0 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\n");
  core::writeJson(folder_ / "in/experiment.json", value);
  EXPECT_NE(lab::refusal([&] { simulateInto(folder_ / "out", silent_); }).find("lies outside the package"),
            std::string::npos);
}

TEST_F(SimulatedPackage, WritesNoFileTwice) {
  json value = core::readJson(folder_ / "in/experiment.json");
  value["samples"][0]["measurements"] = "measurements/../measurements/two.csv.gz";
  core::writeJson(folder_ / "in/experiment.json", value);
  EXPECT_NE(lab::refusal([&] {
              simulateInto(folder_ / "out", silent_);
            }).find("/samples/1/measurements: 'measurements/two.csv.gz' would be written twice"),
            std::string::npos);
}

TEST_F(SimulatedPackage, OfTheProgramHasTheSameBytesWithAnyNumberOfThreads) {
  for (const std::string threads : {"1", "2"}) {
    const auto run =
        test_support::runFidelis({"simulate", (folder_ / "in").string(), "--model", (folder_ / "model.json").string(),
                                  "--out", (folder_ / ("out" + threads)).string(), "--threads", threads});
    ASSERT_EQ(run.status, 0) << run.messages;
  }
  for (const std::string file : {"experiment.json", "measurements/s_1.csv", "measurements/two.csv.gz"}) {
    std::ifstream one(folder_ / ("out1/" + file), std::ios::binary), two(folder_ / ("out2/" + file), std::ios::binary);
    const std::string a{std::istreambuf_iterator<char>(one), {}}, b{std::istreambuf_iterator<char>(two), {}};
    EXPECT_GT(a.size(), 0u);
    EXPECT_EQ(a, b) << file;
  }
}

// A measurement of a foreign, independent generator with nothing withheld. The means of n detections of either side
// scatter by σ·sqrt(2/n); σ of the generator's set-up and rounding adds nothing systematic. Tolerance: a fifth of a
// step plus five standard errors.
TEST(Simulate, BaselineAgreesWithAnIndependentGenerator) {
  FIDELIS_NEEDS_SHARED(shared);
  const Experiment experiment = readExperiment(shared / "experiments/v02");
  const LidarModel model = readModel(shared / "experiments/v02/model.json");
  for (std::size_t i = 0; i < experiment.samples.size(); ++i) {
    const core::Detections measured = readMeasurements(experiment, experiment.samples[i]);
    const core::Detections simulated = simulate(experiment, model, i);
    EXPECT_EQ(measured.size(), simulated.size()) << experiment.samples[i].id;
    for (const Measurand& measurand : experiment.measurands) {
      const auto &real = *measured.values(measurand.column), &ours = *simulated.values(measurand.column);
      // Scatter within a beam, not over the scene: from differences between paired detections.
      std::vector<double> differences;
      for (std::size_t k = 0; k < std::min(real.size(), ours.size()); ++k) differences.push_back(ours[k] - real[k]);
      const double error = lab::deviation(differences) / std::sqrt(static_cast<double>(differences.size()));
      EXPECT_LT(std::abs(lab::mean(ours) - lab::mean(real)), measurand.resolution / 5.0 + 5.0 * error)
          << experiment.samples[i].id << " " << measurand.name;
      EXPECT_LT(5.0 * error, measurand.resolution) << "the tolerance means something";
    }
  }
}

}  // namespace
}  // namespace model
