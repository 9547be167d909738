#include "model/external/external_runs.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/detection_files/detection_file.h"
#include "core/error.h"
#include "core/file.h"
#include "model/external/external_package.h"
#include "model/simulate.h"
#include "tests/model/lab.h"
#include "tests/support/paths.h"

namespace model {
namespace {

using nlohmann::json;
using ::testing::AllOf;
using ::testing::HasSubstr;
namespace fs = std::filesystem;

/// A lidar in awk: one detection a frame, at the value of the sample's last patch step. `measurements` stands before
/// `patch` in the package, because keys are in alphabetical order.
constexpr const char* kAwkLidar = R"(#!/bin/sh
echo started >> "$0.runs"
awk -v out="$2" '
  /"frames":/       { gsub(/[^0-9]/, ""); frames = $0 + 0 }
  /"measurements":/ { split($0, part, "\""); file = out "/" part[4] }
  /"value":/        { sub(/.*:/, ""); gsub(/[ ,]/, ""); value[file] = $0 }
  END { for (file in value) {
          print "frame,layer,azimuth_rad,elevation_rad,range_m" > file
          for (i = 0; i < frames; ++i) print i ",0,0,0," value[file] > file } }
' "$1/experiment.json"
)";

class ExternalModelTest : public ::testing::Test {
 protected:
  void SetUp() override {
    lab::Case setup;
    setup.scene = {lab::board(10)};
    setup.file = folder_ / "in/experiment.json";
    fs::create_directories(folder_ / "in");
    experiment_ = lab::experimentJson(setup);
    experiment_["samples"] = json::array();
    for (const double range_m : {8.0, 12.0}) {
      const std::string id = "r" + std::to_string(static_cast<int>(range_m));
      experiment_["samples"].push_back(
          {{"id", id},
           {"frames", 2},
           {"measurements", "measured/" + id + ".csv"},
           {"patch", {{{"op", "replace"}, {"path", "/scene/0/pose/position_m/0"}, {"value", range_m}}}},
           {"epistemic", {{{"path", "/scene/0/pose/position_m/0"}, {"offset_interval", {-0.25, 0.5}}}}}});
    }
    (void)folder_.write("lidar.sh", kAwkLidar);
  }

  [[nodiscard]] Experiment experiment() const { return parseExperiment(experiment_, folder_ / "in/experiment.json"); }

  [[nodiscard]] LidarModel model(json parts) const {
    parts.update({{"format", "fidelis-model"}, {"version", 1}, {"id", "theirs"}});
    return parseModel(std::move(parts), folder_ / "model.json");
  }
  [[nodiscard]] LidarModel command(const std::string& script) const {
    return model({{"command", {"sh", "-c", script, "sh", "{experiment}", "{out}", "{seed}"}}, {"time_limit_s", 60}});
  }
  [[nodiscard]] LidarModel awkLidar() const { return model({{"command", {"sh", "lidar.sh"}}}); }

  [[nodiscard]] std::vector<WantedRun> allCorners() const {
    std::vector<WantedRun> wanted;
    for (std::size_t i = 0; i < 2; ++i) {
      for (const auto& corner : epistemicCorners(experiment().samples[i])) wanted.push_back({i, corner});
    }
    return wanted;
  }
  [[nodiscard]] std::string errorOf(const LidarModel& theirs) const {
    return lab::refusal([&] { (void)simulate(experiment(), theirs, 0); });
  }

  test_support::TemporaryFolder folder_;
  json experiment_;
  core::SilentProgress nobody_;
};

TEST_F(ExternalModelTest, GetsEachCornerAsASampleInOneRun) {
  ExternalRuns runs;
  const auto answers = runs.run(experiment(), awkLidar(), allCorners(), 1, nobody_);
  ASSERT_EQ(answers.size(), 6u);
  const double expected[] = {8, 7.75, 8.5, 12, 11.75, 12.5};
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(answers[i].detections.range_m, (std::vector<double>{expected[i], expected[i]}));
  }
  EXPECT_EQ(core::readFile(folder_ / "lidar.sh.runs"), "started\n");
  (void)runs.run(experiment(), awkLidar(), allCorners(), 1, nobody_);  // the same question
  EXPECT_EQ(core::readFile(folder_ / "lidar.sh.runs"), "started\n");
  (void)runs.run(experiment(), awkLidar(), allCorners(), 2, nobody_);  // another seed
  EXPECT_EQ(core::readFile(folder_ / "lidar.sh.runs"), "started\nstarted\n");
}

// The package that a command reads must describe the same situations that the built-in lidar would be given.
TEST_F(ExternalModelTest, ThePackageDescribesTheSameSituations) {
  const Experiment original = experiment();
  const auto wanted = allCorners();
  const Experiment package = parseExperiment(externalPackage(original, wanted, 5), folder_ / "in/experiment.json");
  ASSERT_EQ(package.samples.size(), wanted.size());
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    const Situation theirs = situationOf(package, package.samples[i]);
    const Situation ours = situationOf(original, original.samples[wanted[i].sample], wanted[i].offsets);
    EXPECT_EQ(theirs.scene.objects[0].pose.toWorld({0, 0, 0}), ours.scene.objects[0].pose.toWorld({0, 0, 0})) << i;
    EXPECT_TRUE(package.samples[i].epistemic.empty());
  }
  EXPECT_EQ(package.samples[0].id, "r8");
  EXPECT_EQ(package.samples[2].id, "r8@2");
  EXPECT_EQ(package.json.at("x-seed"), 5);
}

TEST_F(ExternalModelTest, SimulateTakesOneRunAtAnyOffset) {
  EXPECT_EQ(simulate(experiment(), awkLidar(), 1).range_m, (std::vector<double>{12, 12}));
  EXPECT_EQ(simulate(experiment(), awkLidar(), 1, {0.125}).range_m, (std::vector<double>{12.125, 12.125}));
}

TEST_F(ExternalModelTest, SimulatePackageStartsTheCommandOnceAndWritesAPackage) {
  simulatePackage(experiment(), awkLidar(), folder_ / "out", std::nullopt, nobody_);
  const Experiment out = readExperiment(folder_ / "out");
  EXPECT_EQ(readMeasurements(out, out.samples[0]).range_m, (std::vector<double>{8, 8}));
  EXPECT_EQ(readMeasurements(out, out.samples[1]).range_m, (std::vector<double>{12, 12}));
  EXPECT_TRUE(out.synthetic());
  EXPECT_EQ(core::readFile(folder_ / "lidar.sh.runs"), "started\n");
}

TEST_F(ExternalModelTest, SeesNoMeasurementAndKnowsTheSeed) {
  fs::create_directories(folder_ / "in/measured");
  (void)folder_.write("in/measured/r8.csv", "frame,range_m\n0,1\n");
  const LidarModel theirs = command(
      "find \"$1\" -name '*.csv' | grep -q . && exit 9; printf 'frame,range_m\\n0,%s\\n' $3 > "
      "\"$2/measurements/r8.csv\"");
  EXPECT_EQ(simulate(experiment(), theirs, 0, {}, 42).range_m, std::vector<double>{42});
}

TEST_F(ExternalModelTest, MayWriteAnyFormatAndLayersAreFilledIn) {
  core::Detections points;
  points.frame = {0, 1};
  points.echo = {1, 1};
  points.range_m = {8, 8.5};
  points.azimuth_rad = {0.0, 0.0};
  points.elevation_rad = {0.0, 0.0};
  core::writeDetections(folder_ / "cloud.osi", points);
  const core::Detections answer = simulate(experiment(), command("cp cloud.osi \"$2/measurements/r8.osi\""), 0);
  EXPECT_EQ(answer.range_m, points.range_m);
  EXPECT_EQ(answer.layer, (std::vector<std::int32_t>{0, 0}));
}

TEST_F(ExternalModelTest, ErrorsSayWhatHappenedAndTheLastWords) {
  EXPECT_THAT(errorOf(command("echo no licence >&2; exit 3")),
              AllOf(HasSubstr("model.json"), HasSubstr("status 3"), HasSubstr("no licence")));
  EXPECT_THAT(errorOf(command("kill -SEGV $$")), HasSubstr("signal 11"));
  EXPECT_THAT(errorOf(command("echo done")),
              AllOf(HasSubstr("did not write measurements/r8.csv"), HasSubstr("Its last words:\ndone")));
  EXPECT_THAT(errorOf(command("printf 'frame,range_m\\n0,far\\n' > \"$2/measurements/r8.csv\"")),
              AllOf(HasSubstr("output measurements/r8.csv:2"), HasSubstr("'far'")));
  EXPECT_THAT(errorOf(command("printf 'frame,range_m\\n2,8\\n' > \"$2/measurements/r8.csv\"")), HasSubstr("frame 2"));
  EXPECT_THAT(errorOf(model({{"command", {"no-such-lidar"}}})),
              AllOf(HasSubstr("'no-such-lidar' cannot be started"), HasSubstr("PATH")));
  EXPECT_THAT(errorOf(model({{"command", {"sleep", "600", "{experiment}{out}"}}, {"time_limit_s", 0.2}})),
              HasSubstr("sleep"));
  EXPECT_THAT(errorOf(model({{"command", {"sh", "-c", "echo waiting; sleep 600"}}, {"time_limit_s", 0.3}})),
              AllOf(HasSubstr("time limit of 0.3 s"), HasSubstr("waiting"), HasSubstr("time_limit_s")));
}

TEST_F(ExternalModelTest, NothingIsLeftInTheTemporaryFolder) {
  const fs::path place = folder_ / "tmp";
  fs::create_directories(place);
  ::setenv("TMPDIR", place.c_str(), 1);
  const std::string worked = lab::refusal([&] { (void)simulate(experiment(), awkLidar(), 0); });
  const std::string failed = errorOf(command("exit 1"));
  ::unsetenv("TMPDIR");
  EXPECT_EQ(worked, "");
  EXPECT_NE(failed, "");
  EXPECT_TRUE(fs::is_empty(place));
}

TEST_F(ExternalModelTest, ModelFilesAreChecked) {
  const auto refusal = [&](const json& parts) { return lab::refusal([&] { (void)model(parts); }); };
  EXPECT_THAT(refusal({{"command", json::array()}}), HasSubstr("/command"));
  EXPECT_THAT(refusal({{"command", {"x", "{out}"}}}), HasSubstr("lacks {experiment}"));
  EXPECT_THAT(refusal({{"command", {"x"}}, {"recorded", "y"}}), HasSubstr("stands beside"));
  EXPECT_THAT(refusal({{"command", {"x"}}, {"time_limit_s", 0}}), HasSubstr("time_limit_s"));
  EXPECT_THAT(refusal({{"command", {"x"}}, {"effects", json::object()}}), HasSubstr("built-in lidar"));
  EXPECT_THAT(refusal({{"command", {"x"}}, {"timelimit_s", 3}}), HasSubstr("Did you mean"));
  EXPECT_TRUE(model({{"model", {{"command", {"x"}}, {"time_limit_s", 3}}}}).external.has_value());
  EXPECT_THAT(lab::refusal([&] { requireBuiltIn(awkLidar(), "the diagnosis"); }), HasSubstr("the diagnosis"));
}

class RecordedModelTest : public ExternalModelTest {
 protected:
  /// A package with one detection a frame at `range_m` for each id.
  void record(const std::vector<std::pair<std::string, double>>& samples, int frames) {
    json package = experiment_;
    package["samples"] = json::array();
    fs::create_directories(folder_ / "recorded/m");
    for (const auto& [id, range_m] : samples) {
      std::string csv = "frame,range_m\n";
      for (int f = 0; f < frames; ++f) csv += std::to_string(f) + "," + std::to_string(range_m) + "\n";
      (void)folder_.write("recorded/m/" + id + ".csv", csv);
      package["samples"].push_back({{"id", id}, {"frames", frames}, {"measurements", "m/" + id + ".csv"}});
    }
    (void)folder_.write("recorded/experiment.json", package.dump());
  }
  [[nodiscard]] LidarModel recorded() const { return model({{"recorded", "recorded"}}); }
};

TEST_F(RecordedModelTest, RunsAreFoundByTheIdsOfSamplesAndCorners) {
  record({{"r8", 8.0}, {"r8@1", 7.5}, {"r8@2", 8.75}, {"r12", 12.0}}, 3);
  EXPECT_EQ(simulate(experiment(), recorded(), 0, {0.5}).range_m, (std::vector<double>{8.75, 8.75}));  // 2 of 3 frames
  EXPECT_EQ(cornersOf(recorded(), experiment().samples[0]).size(), 3u);
  EXPECT_EQ(cornersOf(recorded(), experiment().samples[1]).size(), 1u);
  EXPECT_EQ(filesOf(recorded()).size(), 5u);
}

TEST_F(RecordedModelTest, WhatIsMissingIsSaid) {
  record({{"r8", 8.0}, {"r8@1", 7.5}}, 1);
  EXPECT_THAT(lab::refusal([&] { (void)cornersOf(recorded(), experiment().samples[0]); }), HasSubstr("lacks r8@2"));
  EXPECT_THAT(errorOf(recorded()), AllOf(HasSubstr("1 frames recorded"), HasSubstr("2 are asked for")));
  EXPECT_THAT(lab::refusal([&] { (void)simulate(experiment(), recorded(), 1); }), HasSubstr("no sample 'r12'"));
  EXPECT_THAT(lab::refusal([&] {
                (void)simulate(experiment(), model({{"recorded", "nowhere"}}), 1);
              }),
              HasSubstr("nowhere"));
}

}  // namespace
}  // namespace model
