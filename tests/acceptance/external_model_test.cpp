#include <gmock/gmock.h>

#include "acceptance/run.h"
#include "core/file.h"
#include "tests/acceptance/small_project.h"

// Models under test that are not ours, on the wall of small_project.h.
namespace acceptance {
namespace {

using acceptance_test::SmallProject;
using specs::Verdict;
using testing::HasSubstr;

/// Reports the wall 0.1 m too far, once a frame. `measurements` stands before `patch` in the package.
constexpr const char* kLidar = R"(
echo started >> runs
awk -v out="$2" '
  /"frames":/       { gsub(/[^0-9]/, ""); frames = $0 + 0 }
  /"measurements":/ { split($0, part, "\""); file = out "/" part[4] }
  /"value":/        { sub(/.*:/, ""); gsub(/[ ,]/, ""); value[file] = $0 + 0.1 }
  END { for (file in value) {
          print "frame,layer,azimuth_rad,elevation_rad,range_m" > file
          for (i = 0; i < frames; ++i) print i ",0,0,0," value[file] > file } }
' "$1/experiment.json"
)";

RunResult resultOf(const SmallProject& project) {
  core::SilentProgress progress;
  const specs::ProjectStore store = project.open();
  return runTests(store, {}, progress);
}

void useModel(const SmallProject& project, const std::string& keys) {
  (void)project.folder().write("model.json",
                               R"({"format": "fidelis-model", "version": 1, "id": "theirs", )" + keys + "}");
}

// All simulated values lie above all measured ones, so the distance is that of the box's lower side: the wall is 0.1 m
// too far and known to 2 mm, which leaves 98 mm. Exact but for the six digits of awk.
TEST(ExternalModel, IsJudgedAtAllCornersAndStartedOnceForAllTests) {
  const SmallProject project;
  (void)project.folder().write("lidar.sh", kLidar);
  useModel(project, R"("command": ["sh", "lidar.sh"])");
  project.addTest("RangeError_Model_1", "abs(d_bias) <= 0.12");
  project.addTest("RangeError_Model_2", "abs(d_bias) <= 0.05");
  const RunResult result = resultOf(project);
  ASSERT_EQ(result.tests.size(), 2u);
  EXPECT_EQ(result.tests[0].verdict, Verdict::Passed) << result.tests[0].text;
  EXPECT_EQ(result.tests[1].verdict, Verdict::Failed) << result.tests[1].text;
  for (const SampleResult& sample : result.tests[0].samples) {
    EXPECT_EQ(sample.n_sim, (std::vector<std::size_t>{40, 40, 40}));
    EXPECT_NEAR(sample.values.at("d_bias"), 0.098, 1e-4);
  }
  EXPECT_EQ(core::readFile(project.folder() / "runs"), "started\n");
  const auto is_script = [](const auto& used) { return used.path == "lidar.sh"; };
  EXPECT_EQ(std::count_if(result.tests[0].used.begin(), result.tests[0].used.end(), is_script), 1);
}

TEST(ExternalModel, ThatFailsGivesAnErrorWithItsLastWords) {
  const SmallProject project;
  useModel(project, R"("command": ["sh", "-c", "echo no licence >&2; exit 3"])");
  project.addTest("RangeError_Model_1", "abs(d_bias) <= 0.12");
  const RunResult result = resultOf(project);
  EXPECT_EQ(result.tests[0].verdict, Verdict::Error);
  EXPECT_THAT(result.tests[0].text, AllOf(HasSubstr("status 3"), HasSubstr("no licence")));
}

TEST(ExternalModel, RecordedWithoutCornersIsJudgedWithARemark) {
  const SmallProject project;
  std::filesystem::copy(project.folder() / "wall", project.folder() / "recorded",
                        std::filesystem::copy_options::recursive);
  useModel(project, R"("recorded": "recorded")");
  project.addTest("RangeError_Model_1", "abs(d_bias) <= 0.001");
  const RunResult result = resultOf(project);
  EXPECT_EQ(result.tests[0].verdict, Verdict::Passed) << result.tests[0].text;
  EXPECT_EQ(result.tests[0].samples[0].n_sim, std::vector<std::size_t>{40});
  EXPECT_THAT(result.tests[0].samples[0].remarks, testing::Contains(HasSubstr("no corners")));
}

}  // namespace
}  // namespace acceptance
