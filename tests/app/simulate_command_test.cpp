#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/csv.h"
#include "core/file.h"
#include "core/json_object.h"
#include "tests/support/paths.h"
#include "tests/support/program.h"

// `fidelis predict` → `fidelis simulate --prediction`, as a user runs them, on the demo's range sweep.
namespace {

namespace fs = std::filesystem;
using test_support::ProgramRun;
using test_support::runFidelis;
using test_support::TemporaryFolder;
using testing::HasSubstr;

class SelfAwareSimulation : public testing::Test {
 protected:
  void SetUp() override {
    // d_bias = 0.02 + 0.001 range without residuals: value and both bounds are the line itself.
    (void)folder_.write("results.csv", "range_m,d_bias\n10,0.03\n14,0.034\n18,0.038\n");
    EXPECT_EQ(save({"--measurand", "epw"}).status, 0);
  }
  ProgramRun save(const std::vector<std::string>& more) {
    std::vector<std::string> words{"predict", path("results.csv"),    "--over", "range_m", "--family", "linear",
                                   "--save",  path("prediction.json")};
    words.insert(words.end(), more.begin(), more.end());
    return runFidelis(words);
  }
  ProgramRun simulate(const std::string& out, const std::vector<std::string>& more) {
    std::vector<std::string> words{
        "simulate", (demo() / "range-sweep").string(), "--model", (demo() / "model.json").string(), "--out", path(out)};
    words.insert(words.end(), more.begin(), more.end());
    return runFidelis(words);
  }
  static fs::path demo() { return test_support::sourceFolder() / "resources/demo"; }
  std::string path(const std::string& name) { return (folder_ / name).string(); }
  core::CsvTable table(const std::string& out, const std::string& sample) {
    return core::readCsvTable(folder_ / out / "measurements" / (sample + ".csv"));
  }

  TemporaryFolder folder_;
};

TEST_F(SelfAwareSimulation, EveryDetectionCarriesTheErrorAtItsSamplesRange) {
  const ProgramRun run = simulate("out", {"--prediction", path("prediction.json")});
  ASSERT_EQ(run.status, 0) << run.messages;
  EXPECT_THAT(run.messages, HasSubstr("predicted errors of epw (epw_m_bias"));
  const auto experiment = core::readJson(folder_ / "out/experiment.json");
  for (const auto& sample : experiment.at("samples")) {
    const double range = sample.at("parameters").at("range_m");
    const core::CsvTable detections = table("out", sample.at("id"));
    ASSERT_FALSE(detections.rows.empty());
    for (const auto& row : detections.rows) {
      EXPECT_NEAR(std::stod(row[detections.column("epw_m_bias")]), 0.02 + 0.001 * range, 1e-6);
      EXPECT_NEAR(std::stod(row[detections.column("epw_m_bias_high")]), 0.02 + 0.001 * range, 1e-6);
      EXPECT_EQ(row[detections.column("epw_m_extrapolated")], range >= 10 && range <= 18 ? "0" : "1");
    }
  }
  EXPECT_EQ(experiment.at("x-prediction").at(0).at("sha256"), core::sha256OfFile(folder_ / "prediction.json"));
}

// The columns are added at the end of each line; nothing else changes, with any number of threads.
TEST_F(SelfAwareSimulation, AddsColumnsToTheVerySameSimulation) {
  ASSERT_EQ(simulate("plain", {}).status, 0);
  ASSERT_EQ(simulate("one", {"--prediction", path("prediction.json"), "--threads", "1"}).status, 0);
  ASSERT_EQ(simulate("two", {"--prediction", path("prediction.json"), "--threads", "2"}).status, 0);
  for (const auto& entry : fs::recursive_directory_iterator(folder_ / "one")) {
    if (!entry.is_regular_file()) continue;
    const fs::path place = fs::relative(entry.path(), folder_ / "one");
    EXPECT_EQ(core::readFile(entry.path()), core::readFile(folder_ / "two" / place)) << place;
  }
  const core::CsvTable plain = table("plain", "r15");
  const core::CsvTable more = table("one", "r15");
  ASSERT_EQ(more.rows.size(), plain.rows.size());
  for (std::size_t i = 0; i < plain.rows.size(); ++i) {
    EXPECT_TRUE(std::equal(plain.rows[i].begin(), plain.rows[i].end(), more.rows[i].begin())) << i;
  }
}

TEST_F(SelfAwareSimulation, LeavesAPackageThatOtherCommandsRead) {
  ASSERT_EQ(simulate("out", {"--prediction", path("prediction.json")}).status, 0);
  const std::string file = path("out/measurements/r15.csv");
  EXPECT_EQ(runFidelis({"metric", file, file, "--column", "epw_m", "--column", "epw_m_bias", "--json", "-"}).status, 0);
  const ProgramRun again =
      runFidelis({"simulate", path("out"), "--model", (demo() / "model.json").string(), "--out", path("again")});
  EXPECT_EQ(again.status, 0) << again.messages;
  EXPECT_FALSE(core::readJson(folder_ / "again/experiment.json").contains("x-prediction"));
}

TEST_F(SelfAwareSimulation, MistakesAreToldBeforeAnythingIsWritten) {
  EXPECT_THAT(save({}).messages, HasSubstr("does not record whose errors it predicts"));
  const ProgramRun unknown = simulate("out", {"--prediction", path("prediction.json")});
  EXPECT_EQ(unknown.status, 2);
  EXPECT_THAT(unknown.messages, HasSubstr("--measurand range"));
  EXPECT_EQ(simulate("out", {"--prediction", path("missing.json")}).status, 2);
  EXPECT_THAT(simulate("out", {"--prediction", path("prediction.json"), "--measurand", "ewp"}).messages,
              HasSubstr("Did you mean 'epw'?"));
  EXPECT_FALSE(fs::exists(folder_ / "out"));
  EXPECT_EQ(simulate("out", {"--prediction", path("prediction.json"), "--measurand", "epw"}).status, 0);
}

TEST_F(SelfAwareSimulation, MeasurandOfASavedPredictionIsRecordedAndChecked) {
  EXPECT_EQ(core::readJson(folder_ / "prediction.json").at("measurand"),
            (nlohmann::json{{"name", "epw"}, {"column", "epw_m"}, {"unit", "m"}}));
  const ProgramRun other = runFidelis(
      {"predict", "--with", path("prediction.json"), "--measurand", "range", "--at", "range_m=12", "--json", "-"});
  EXPECT_EQ(other.status, 2);
  EXPECT_THAT(other.messages, HasSubstr("contradicts the file, whose errors are of epw (epw_m, m)"));
}

}  // namespace
