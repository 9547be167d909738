#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/file.h"
#include "tests/support/paths.h"
#include "tests/support/program.h"

namespace {

using test_support::runFidelis;
using ::testing::HasSubstr;

/// The demo's range sweep and a model file with these keys.
class ExternalModelCommand : public ::testing::Test {
 protected:
  std::filesystem::path model(const std::string& keys) const {
    return folder_.write("model.json", R"({"format": "fidelis-model", "version": 1, "id": "theirs", )" + keys + "}");
  }
  std::filesystem::path sweep_ = test_support::sourceFolder() / "resources/demo/range-sweep";
  test_support::TemporaryFolder folder_;
};

TEST_F(ExternalModelCommand, SimulateWritesWhatTheProgramReported) {
  const auto lidar = model(
      R"("command": ["sh", "-c", "sed -n 's/.*\"measurements\": \"\\(.*\\)\".*/\\1/p' \"$1/experiment.json\" | while read -r file; do printf 'frame,range_m\\n0,7.5\\n' > \"$2/$file\"; done", "sh"])");
  const auto run = runFidelis({"simulate", sweep_, "--model", lidar, "--out", folder_ / "out"});
  EXPECT_EQ(run.status, 0) << run.messages;
  EXPECT_EQ(core::readFile(folder_ / "out/measurements/r10.csv"), "frame,echo,range_m\n0,1,7.5000\n");
}

TEST_F(ExternalModelCommand, NothingIsWrittenIfTheProgramFails) {
  const auto run =
      runFidelis({"simulate", sweep_, "--model", model(R"("command": ["sh", "-c", "echo no licence; exit 3"])"),
                  "--out", folder_ / "out"});
  EXPECT_EQ(run.status, 2);
  EXPECT_THAT(run.messages, AllOf(HasSubstr("status 3"), HasSubstr("no licence")));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out"));
}

TEST_F(ExternalModelCommand, NothingIsDiagnosedIfTheProgramReportsNothing) {
  const auto lidar = model(R"("command": ["true"])");
  const auto gap = runFidelis({"gap", sweep_, "--model", lidar, "--json", "-"});
  EXPECT_EQ(gap.status, 2);
  EXPECT_EQ(gap.out, "");
  EXPECT_THAT(gap.messages, HasSubstr("'true' ended well, but did not write measurements/r10.csv"));
}

}  // namespace
