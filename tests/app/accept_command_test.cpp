#include <fstream>
#include <gmock/gmock.h>

#include "core/file.h"
#include "core/json_object.h"
#include "tests/acceptance/small_project.h"
#include "tests/support/program.h"

namespace {

using acceptance_test::SmallProject;
using test_support::ProgramRun;
using test_support::runFidelis;
using testing::HasSubstr;

std::string inFolder(const SmallProject& project, const std::string& name) {
  return (project.folder() / name).string();
}

TEST(AcceptCommand, EndsWithZeroAndWritesAllReportsIfAllPass) {
  const SmallProject project;
  project.addTest("RangeError_Offset_1", "abs(d_bias) <= 0.005 * range_m");
  const ProgramRun run =
      runFidelis({"accept", project.file().string(), "--junit", inFolder(project, "out.xml"), "--json",
                  inFolder(project, "out.json"), "--html", inFolder(project, "out.html"), "--quiet"});
  EXPECT_EQ(run.status, 0) << run.messages;
  EXPECT_THAT(run.out, HasSubstr("PASSED   RangeError_Offset_1  all 2 samples hold"));
  EXPECT_EQ(run.messages, "");
  EXPECT_EQ(core::readJson(project.folder() / "out.json").at("counts").at("passed"), 1);
  EXPECT_THAT(core::readFile(project.folder() / "out.xml"), HasSubstr("<testsuites"));
  EXPECT_THAT(core::readFile(project.folder() / "out.html"), HasSubstr("Synthetic data."));
  EXPECT_EQ(project.open().latestVerdicts().at("RangeError_Offset_1").report, "out.html");
}

TEST(AcceptCommand, EndsWithOneIfATestFailsAndStoresIt) {
  const SmallProject project({.offset_m = 0.3});
  project.addTest("RangeError_Offset_1", "abs(d_bias) <= 0.005 * range_m");
  project.addTest("RangeError_Offset_2", "n_real >= 1");
  const ProgramRun run = runFidelis({"accept", project.file().string(), "--json", "-"});
  EXPECT_EQ(run.status, 1);
  EXPECT_THAT(run.messages, HasSubstr("FAILED   RangeError_Offset_1"));
  EXPECT_EQ(nlohmann::json::parse(run.out).at("tests").at(0).at("verdict"), "failed");
  EXPECT_EQ(project.open().latestVerdicts().at("RangeError_Offset_1").verdict, specs::Verdict::Failed);
}

TEST(AcceptCommand, EndsWithTwoIfATestCannotBeDecided) {
  const SmallProject project;
  project.addTest("RangeError_Offset_1", "abs(d_bais) <= 1");
  const ProgramRun run = runFidelis({"accept", project.file().string()});
  EXPECT_EQ(run.status, 2);
  EXPECT_THAT(run.out, HasSubstr("ERROR"));
  EXPECT_THAT(run.out, HasSubstr("Did you mean 'd_bias'?"));
}

TEST(AcceptCommand, EndsWithTwoForWhatDoesNotExist) {
  const SmallProject project;
  EXPECT_EQ(runFidelis({"accept", inFolder(project, "absent.fidelis")}).status, 2);
  const ProgramRun none = runFidelis({"accept", project.file().string()});
  EXPECT_EQ(none.status, 2);
  EXPECT_THAT(none.messages, HasSubstr("has no acceptance tests"));
  project.addTest("RangeError_Offset_1", "n_real >= 1");
  const ProgramRun unknown = runFidelis({"accept", project.file().string(), "--test", "RangeError_Ofset_1"});
  EXPECT_EQ(unknown.status, 2);
  EXPECT_THAT(unknown.messages, HasSubstr("Did you mean 'RangeError_Offset_1'?"));
  const ProgramRun nowhere =
      runFidelis({"accept", project.file().string(), "--html", inFolder(project, "absent/out.html")});
  EXPECT_EQ(nowhere.status, 2);
  EXPECT_TRUE(project.open().latestRuns().empty());
}

TEST(AcceptCommand, NothingDecidedIsNoSuccess) {
  const SmallProject project;
  specs::ProjectStore store = project.open();
  specs::AcceptanceTest inspection = SmallProject::rangeTest("RangeError_Offset_1", "");
  inspection.experiment = "";
  store.add(inspection, acceptance_test::kSomebody);
  const ProgramRun run = runFidelis({"accept", project.file().string()});
  EXPECT_EQ(run.status, 2);
  EXPECT_THAT(run.out, HasSubstr("SKIPPED"));
  EXPECT_THAT(run.messages, HasSubstr("no test was run"));
}

TEST(AcceptCommand, WritesTheSameBytesWithOneAndTwoThreads) {
  const SmallProject project({.offset_m = 0.02});
  project.addTest("RangeError_Offset_1", "abs(d_bias) <= 0.005 * range_m && d_cavm <= 0.05");
  for (const std::string threads : {"1", "2"}) {
    (void)runFidelis({"accept", project.file().string(), "--threads", threads, "--json",
                      inFolder(project, threads + ".json"), "--html", inFolder(project, threads + ".html")});
  }
  EXPECT_EQ(core::readFile(project.folder() / "1.json"), core::readFile(project.folder() / "2.json"));
  EXPECT_EQ(core::readFile(project.folder() / "1.html"), core::readFile(project.folder() / "2.html"));
}

}  // namespace
