// The demo project of resources/demo, told by the real program as scripts/demo tells it.

#include <gtest/gtest.h>
#include <map>
#include <nlohmann/json.hpp>

#include "core/file.h"
#include "core/json_object.h"
#include "percollect/read_graph.h"
#include "tests/support/paths.h"
#include "tests/support/program.h"

namespace {

using nlohmann::json;
using test_support::runFidelis;

std::filesystem::path demo(const std::string& name) { return test_support::sourceFolder() / "resources/demo" / name; }

/// The project as a user has it before the first acceptance run, beside copies of the packages and the model.
class Demo : public ::testing::Test {
 protected:
  Demo() {
    for (const char* package : {"range-sweep", "foggy-sweep"}) {
      std::filesystem::copy(demo(package), folder / package, std::filesystem::copy_options::recursive);
    }
    std::filesystem::copy(demo("model.json"), folder / "model.json");
    mustRun({"import", demo("lidar-excerpt.json"), "--project", project});
    mustRun({"cepra", "import", demo("cepra.csv"), "--project", project});
    mustRun({"spec", "import", demo("specification"), "--project", project});
  }

  static void mustRun(const std::vector<std::string>& words) {
    const auto run = runFidelis(words);
    EXPECT_EQ(run.status, 0) << run.messages;
  }

  /// Verdict of each test.
  std::map<std::string, std::string> verdicts(const std::string& model, int status) {
    const std::string result = folder / "accept.json";
    const auto run = runFidelis({"accept", project, "--model", model, "--json", result});
    EXPECT_EQ(run.status, status) << run.messages;
    std::map<std::string, std::string> found;
    const json tests = core::readJson(result).at("tests");
    for (const json& test : tests) found[test.at("id")] = test.at("verdict");
    return found;
  }

  test_support::TemporaryFolder folder;
  std::string project = folder / "demo.fidelis";
};

TEST(DemoGraph, IsTheSameInBothFileFormats) {
  const auto from_json = percollect::readGraph(demo("lidar-excerpt.json"));
  const auto from_xml = percollect::readGraph(demo("lidar-excerpt-2021-xml"));
  EXPECT_EQ(from_json.graph.size(), 35u);
  EXPECT_TRUE(percollect::sameContent(from_json.graph, from_xml.graph));
}

TEST(DemoGraph, HasThreePhenomenaAndNoWarnings) {
  const auto run = runFidelis({"import", demo("lidar-excerpt.json"), "--json", "-"});
  ASSERT_EQ(run.status, 0) << run.messages;
  const json counts = json::parse(run.out);
  EXPECT_EQ(counts.at("phenomena"), 3);
  EXPECT_EQ(counts.at("cepra_rows"), 24);
  EXPECT_TRUE(counts.at("warnings").empty());
}

TEST_F(Demo, RelevanceTableIsScoredWhole) {
  const auto run = runFidelis({"cepra", "check", "--project", project, "--json", "-"});
  EXPECT_EQ(run.status, 0) << run.messages;
  const json found = json::parse(run.out);
  EXPECT_EQ(found.at("scored"), found.at("rows"));
  EXPECT_TRUE(found.at("findings").empty()) << found;
}

TEST_F(Demo, SpecificationHoldsTogether) {
  const auto run = runFidelis({"spec", "check", "--project", project, "--json", "-"});
  EXPECT_EQ(run.status, 0) << run.out;
  EXPECT_TRUE(json::parse(run.out).at("findings").empty()) << run.out;
}

TEST_F(Demo, ModelWithoutFogPassesInClearAirAndFailsInFog) {
  const auto verdict = verdicts(folder / "model.json", 1);
  EXPECT_EQ(verdict.at("RangeError_SignalPath_4"), "passed");
  EXPECT_EQ(verdict.at("EchoPulseWidthError_WeakEcho_3"), "passed");
  EXPECT_EQ(verdict.at("RangeError_Fog_1"), "passed");  // fog weakens echoes, it does not move their peak
  EXPECT_EQ(verdict.at("EchoPulseWidthError_Fog_2"), "failed");
  EXPECT_EQ(verdict.at("FalseNegativeDetection_Fog_2"), "failed");
}

// The measurements were made with a visibility of 200 m, by a script that shares no code with the simulation.
TEST_F(Demo, DiagnosisNamesTheFogAndItsModelPassesEveryTest) {
  const std::string report = folder / "gap.json";
  const std::string better = folder / "better.json";
  mustRun({"gap", folder / "foggy-sweep", "--model", folder / "model.json", "--json", report, "--write-model", better});
  const json gap = core::readJson(report);
  EXPECT_EQ(gap.at("verdict").at("kind"), "effect");
  EXPECT_EQ(gap.at("verdict").at("names"), json({"atmospheric-attenuation"}));
  EXPECT_NEAR(gap.at("causes").at(0).at("parameters").at("visibility_m").at("value").get<double>(), 200.0, 10.0);
  EXPECT_GT(gap.at("shrink").at("fraction").get<double>(), 0.8);
  for (const auto& [id, verdict] : verdicts(better, 0)) EXPECT_EQ(verdict, "passed") << id;
}

TEST_F(Demo, DiagnosisFindsNothingMissingInClearAir) {
  const std::string report = folder / "gap.json";
  mustRun({"gap", folder / "range-sweep", "--model", folder / "model.json", "--json", report});
  EXPECT_EQ(core::readJson(report).at("verdict").at("kind"), "none");
}

}  // namespace
