#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/detection_files/detection_file.h"
#include "core/file.h"
#include "core/json_object.h"
#include "tests/support/paths.h"
#include "tests/support/program.h"

// Reflections out (fidelis simulate --reflections) and in (fidelis detect, fidelis simulate --from-reflections).
namespace {

namespace fs = std::filesystem;
using test_support::ProgramRun;
using test_support::runFidelis;
using testing::AllOf;
using testing::HasSubstr;

class ReflectionCommands : public testing::Test {
 protected:
  ProgramRun simulate(const std::string& out, const std::vector<std::string>& more) {
    const fs::path demo = test_support::sourceFolder() / "resources/demo";
    std::vector<std::string> words{
        "simulate", (demo / "range-sweep").string(), "--model", (demo / "model.json").string(), "--out", path(out)};
    words.insert(words.end(), more.begin(), more.end());
    return runFidelis(words);
  }
  ProgramRun detect(const std::string& trace, const std::string& out) {
    const nlohmann::json sensor = nlohmann::json::parse(R"({
      "format": "fidelis-sensor", "version": 1, "id": "three-beams",
      "emitter": {"wavelength_nm": 905, "peak_power_w": 75, "pulse_fwhm_ns": 5,
                  "divergence_rad": {"horizontal": 0.003, "vertical": 0.003}},
      "receiver": {"aperture_diameter_m": 0.02, "efficiency": 0.5, "noise_w": 0, "threshold_w": 20e-9},
      "scan": {"frame_rate_hz": 10, "layers": [{"elevation_deg": 0, "azimuth_deg": {"from": 1, "to": -1, "step": 1}}]},
      "detection": {"max_echoes": 3, "echo_separation_m": 1, "range_mode": "peak", "max_range_m": 200,
                    "output": ["range", "epw", "intensity"]}})");
    nlohmann::json model = {
        {"format", "fidelis-model"}, {"version", 1}, {"id", "three-beams"}, {"rays_per_beam", {1, 1}}};
    model["sensor"] = sensor;
    model["effects"] = {{"pulse-broadening", nlohmann::json::object()},
                        {"atmospheric-attenuation", {{"visibility_m", 200}}}};
    core::writeJson(folder_ / "model.json", model);
    return runFidelis({"detect", trace, "--model", path("model.json"), "--out", path(out)});
  }
  std::string path(const std::string& name) { return (folder_ / name).string(); }

  test_support::TemporaryFolder folder_;
};

TEST_F(ReflectionCommands, OutAndInAgainGivesTheSameMeasurements) {
  ASSERT_EQ(simulate("plain", {}).status, 0);
  const ProgramRun out = simulate("out", {"--reflections"});
  ASSERT_EQ(out.status, 0) << out.messages;
  const ProgramRun in = simulate("in", {"--from-reflections", path("out")});
  ASSERT_EQ(in.status, 0) << in.messages;
  const auto experiment = core::readJson(folder_ / "out/experiment.json");
  for (const auto& sample : experiment.at("samples")) {
    EXPECT_TRUE(fs::is_regular_file(folder_ / "out" / sample.at("x-reflections").get<std::string>()));
    const std::string file = sample.at("measurements");
    EXPECT_EQ(core::readFile(folder_ / "in" / file), core::readFile(folder_ / "plain" / file)) << file;
    EXPECT_EQ(core::readFile(folder_ / "out" / file), core::readFile(folder_ / "plain" / file)) << file;
  }
  EXPECT_THAT(core::readJson(folder_ / "in/experiment.json").at("source"), HasSubstr("from the reflections of"));
}

// The trace was written byte by byte from the standard's field numbers (tests/data/detection_files/write_files.py).
TEST_F(ReflectionCommands, ATraceFromElsewhereBecomesDetections) {
  const ProgramRun run = detect(test_support::testData("detection_files/fan.osi").string(), "d.csv");
  ASSERT_EQ(run.status, 0) << run.messages;
  EXPECT_THAT(run.messages, AllOf(HasSubstr("received 5 detections in 2 frames"),
                                  HasSubstr("taken to be in the reflections already: atmospheric-attenuation")));
  const core::Detections d = core::readDetections(folder_ / "d.csv");
  EXPECT_EQ(d.frame, (std::vector<std::int32_t>{0, 0, 0, 1, 1}));
  EXPECT_EQ(d.range_m, (std::vector<double>{40, 30, 20, 41, 21}));
  for (const double intensity_nw : d.intensity) EXPECT_NEAR(intensity_nw, 100.0, 1e-3);
}

TEST_F(ReflectionCommands, BrokenTracesAreSaidAndNothingIsWritten) {
  const std::string whole = core::readFile(test_support::testData("detection_files/fan.osi"));
  const auto messagesOf = [&](const std::string& bytes) {
    core::writeFile(folder_ / "broken.osi", bytes);
    const ProgramRun run = detect(path("broken.osi"), "d.csv");
    EXPECT_EQ(run.status, 2);
    EXPECT_FALSE(fs::exists(folder_ / "d.csv"));
    return run.messages;
  };
  EXPECT_THAT(messagesOf(whole.substr(0, whole.size() - 3)),
              AllOf(HasSubstr("broken.osi"), HasSubstr("message 2"), HasSubstr("cut off")));
  EXPECT_THAT(messagesOf(core::readFile(test_support::testData("detection_files/detections.osi"))),
              HasSubstr("holds detections"));
  std::string backwards = whole;  // the sign of the first time of flight, behind its tag
  backwards.at(backwards.find("\x11", backwards.find("\x12\x12\x09")) + 8) ^= static_cast<char>(0x80);
  EXPECT_THAT(messagesOf(backwards),
              AllOf(HasSubstr("message 1"), HasSubstr("ray 1"), HasSubstr("time of flight of -")));
}

TEST_F(ReflectionCommands, MistakesAreTold) {
  EXPECT_EQ(simulate("out", {"--reflections", "--from-reflections", path("x")}).status, 2);
  const ProgramRun one = simulate("out", {"--from-reflections", test_support::testData("detection_files/fan.osi")});
  EXPECT_EQ(one.status, 2);
  EXPECT_THAT(one.messages, HasSubstr("is one trace of reflections, but the experiment has"));
  const ProgramRun missing = simulate("out", {"--from-reflections", folder_.path().string()});
  EXPECT_EQ(missing.status, 2);
  EXPECT_THAT(missing.messages, HasSubstr(".osi"));
  EXPECT_FALSE(fs::exists(folder_ / "out"));
}

}  // namespace
