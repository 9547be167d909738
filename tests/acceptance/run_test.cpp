#include "acceptance/run.h"

#include <fstream>
#include <gmock/gmock.h>

#include "core/error.h"
#include "tests/acceptance/small_project.h"

namespace acceptance {
namespace {

using acceptance_test::kSomebody;
using acceptance_test::SmallProject;
using specs::Verdict;
using testing::HasSubstr;

const RunRecord kRecord = {.started_at = "2024-05-06T07:08:09Z", .report = {}};

/// Cancels once it has been asked a number of times.
class CancelAfter final : public core::Progress {
 public:
  explicit CancelAfter(int questions) : questions_(questions) {}
  void report(double fraction, std::string_view) override { last_ = fraction; }
  [[nodiscard]] bool cancelled() const override { return --questions_ < 0; }
  [[nodiscard]] double last() const { return last_; }

 private:
  mutable int questions_;
  double last_ = 0.0;
};

std::string errorOf(const SmallProject& project, const RunOptions& options) {
  core::SilentProgress progress;
  const specs::ProjectStore store = project.open();
  try {
    (void)runTests(store, options, progress);
  } catch (const core::InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(RunTests, RunsAllTestsThatAreNotRejectedAndStoresWhatTheyFound) {
  const SmallProject project({.offset_m = 0.1});
  project.addTest("RangeError_Offset_1", "abs(d_bias) <= 1");
  project.addTest("RangeError_Offset_2", "abs(d_bias) <= 0.01");
  specs::ProjectStore store = project.open();
  specs::AcceptanceTest rejected = SmallProject::rangeTest("RangeError_Offset_3", "abs(d_bias) <= 1");
  rejected.status = specs::Status::Rejected;
  store.add(rejected, kSomebody);

  core::SilentProgress progress;
  const RunResult result = runTests(store, {}, progress);
  ASSERT_EQ(result.tests.size(), 3u);
  EXPECT_EQ(result.tests[0].verdict, Verdict::Passed);
  EXPECT_EQ(result.tests[1].verdict, Verdict::Failed);
  EXPECT_EQ(result.tests[2].verdict, Verdict::Skipped);
  ASSERT_EQ(result.tests[0].requirements.size(), 1u);

  const std::string id =
      storeRun(store, result, {.started_at = "2024-05-06T07:08:09Z", .report = project.folder() / "report.html"});
  const specs::TestRun stored = store.findRun(id).value();
  EXPECT_EQ(stored.started_at, "2024-05-06T07:08:09Z");
  EXPECT_FALSE(stored.program_version.empty());
  ASSERT_EQ(stored.verdicts.size(), 3u);
  EXPECT_EQ(stored.verdicts[1].verdict, Verdict::Failed);
  EXPECT_EQ(stored.verdicts[1].report, "report.html");
  EXPECT_EQ(stored.verdicts[1].used.size(), 4u);
  const specs::SampleVerdict& sample = stored.verdicts[1].samples.at(0);
  EXPECT_EQ(sample.sample, "r8");
  EXPECT_DOUBLE_EQ(sample.limit.value(), 0.01);
  EXPECT_NEAR(sample.value.value(), 0.1, 0.01);
  EXPECT_DOUBLE_EQ(sample.values.at("range_m"), 8.0);
  EXPECT_THAT(stored.verdicts[1].evaluation, HasSubstr("<svg"));
  EXPECT_EQ(store.latestVerdicts().at("RangeError_Offset_1").verdict, Verdict::Passed);
}

TEST(RunTests, ARejectedTestRunsIfItIsNamed) {
  const SmallProject project;
  specs::ProjectStore store = project.open();
  specs::AcceptanceTest rejected = SmallProject::rangeTest("RangeError_Offset_3", "n_real >= 1");
  rejected.status = specs::Status::Rejected;
  store.add(rejected, kSomebody);
  core::SilentProgress progress;
  EXPECT_EQ(runTests(store, {.tests = {"RangeError_Offset_3"}}, progress).tests[0].verdict, Verdict::Passed);
}

TEST(RunTests, AnUnreadablePackageIsAnErrorOfItsTestOnly) {
  const SmallProject project;
  project.addTest("RangeError_Offset_1", "n_real >= 1");
  specs::ProjectStore store = project.open();
  specs::AcceptanceTest broken = SmallProject::rangeTest("RangeError_Offset_2", "n_real >= 1");
  broken.experiment = "broken";
  store.add(broken, kSomebody);
  project.folder().write("broken/experiment.json", "{\"format\": \"fidelis-experiment\",");
  core::SilentProgress progress;
  const RunResult result = runTests(store, {}, progress);
  EXPECT_EQ(result.tests[0].verdict, Verdict::Passed);
  EXPECT_EQ(result.tests[1].verdict, Verdict::Error);
  EXPECT_THAT(result.tests[1].text, HasSubstr("experiment.json"));
}

TEST(RunTests, AModelMayBePutInPlaceOfTheTestsOwn) {
  const SmallProject project({.offset_m = 0.3});
  project.addTest("RangeError_Offset_1", "abs(d_bias) <= 0.02");
  std::filesystem::path better = project.folder().write("better.json", [&] {
    std::ifstream stream(project.folder() / "model.json");
    std::string model(std::istreambuf_iterator<char>(stream), {});
    const std::string none = "\"effects\": {}";
    return model.replace(model.find(none), none.size(), R"("effects": {"range-offset": {"offset_m": 0.3}})");
  }());
  specs::ProjectStore store = project.open();
  core::SilentProgress progress;
  const RunResult own = runTests(store, {}, progress);
  EXPECT_EQ(own.tests[0].verdict, Verdict::Failed);
  storeRun(store, own, kRecord);
  EXPECT_EQ(store.latestVerdicts().at("RangeError_Offset_1").text, own.tests[0].text);

  const RunResult run = runTests(store, {.tests = {}, .model = better, .seed = {}}, progress);
  EXPECT_EQ(run.tests[0].verdict, Verdict::Passed) << run.tests[0].text;
  EXPECT_EQ(run.tests[0].model_file, "better.json");
  storeRun(store, run, kRecord);
  EXPECT_THAT(store.latestVerdicts().at("RangeError_Offset_1").text, HasSubstr("(judged with better.json)"));
}

TEST(RunTests, AnotherSeedGivesOtherNumbersAndIsNoted) {
  const SmallProject project;
  project.addTest("RangeError_Offset_1", "n_real >= 1");
  const specs::ProjectStore store = project.open();
  core::SilentProgress progress;
  const RunResult seven = runTests(store, {}, progress);
  const RunResult eight = runTests(store, {.tests = {}, .model = {}, .seed = 8}, progress);
  EXPECT_EQ(seven.tests[0].seed, 7u);
  EXPECT_EQ(eight.tests[0].seed, 8u);
  EXPECT_NE(seven.tests[0].samples[0].values.at("d_avm"), eight.tests[0].samples[0].values.at("d_avm"));
}

TEST(RunTests, AnUnknownTestIsRefusedWithTheNearest) {
  const SmallProject project;
  project.addTest("RangeError_Offset_1", "n_real >= 1");
  EXPECT_THAT(errorOf(project, {.tests = {"RangeEror_Offset_1"}}), HasSubstr("Did you mean 'RangeError_Offset_1'?"));
}

TEST(RunTests, AProjectWithoutTestsSaysSo) {
  const SmallProject project;
  EXPECT_THAT(errorOf(project, {}), HasSubstr("has no acceptance tests."));
}

TEST(RunTests, ACancelledRunStoresNothing) {
  const SmallProject project;
  project.addTest("RangeError_Offset_1", "n_real >= 1");
  for (int questions = 0; questions < 8; ++questions) {
    specs::ProjectStore store = project.open();
    CancelAfter progress(questions);
    EXPECT_THROW(storeRun(store, runTests(store, {}, progress), kRecord), core::Cancelled) << questions;
    EXPECT_TRUE(store.latestRuns().empty());
  }
}

TEST(RunTests, ProgressEndsAtTheWhole) {
  const SmallProject project;
  project.addTest("RangeError_Offset_1", "n_real >= 1");
  project.addTest("RangeError_Offset_2", "n_real >= 1");
  const specs::ProjectStore store = project.open();
  CancelAfter progress(1'000'000);
  (void)runTests(store, {}, progress);
  EXPECT_DOUBLE_EQ(progress.last(), 1.0);
}

}  // namespace
}  // namespace acceptance
