#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "core/file.h"
#include "tests/app/cli_project.h"
#include "tests/support/program.h"

namespace {

using test_support::runFidelis;
using ::testing::HasSubstr;

class SpecCommand : public ::testing::Test {
 protected:
  SpecCommand() {
    EXPECT_EQ(runFidelis({"import", folder.write("small.json", test_app::smallRelease()), "--project", project}).status,
              0);
    test_app::addRequirement(project);
  }
  test_support::TemporaryFolder folder;
  std::string project = folder / "demo.fidelis";
};

TEST_F(SpecCommand, ExportsEveryDocumentThatIsAskedFor) {
  const auto run = runFidelis({"spec", "export", "--project", project, "--html", folder / "s.html", "--xlsx",
                               folder / "s.xlsx", "--csv", folder / "lists", "--json", folder / "s.json"});
  EXPECT_EQ(run.status, 0) << run.messages;
  EXPECT_THAT(core::readFile(folder / "s.html"), HasSubstr("id=\"RangeError_Fog_1\""));
  EXPECT_THAT(core::readFile(folder / "lists/requirements.csv"), HasSubstr("RangeError_Fog_1"));
  EXPECT_TRUE(std::filesystem::exists(folder / "s.xlsx"));
  EXPECT_TRUE(std::filesystem::exists(folder / "s.json"));
  EXPECT_EQ(runFidelis({"spec", "export", "--project", project}).status, 2);
}

TEST_F(SpecCommand, ImportsWhatItExported) {
  const std::string lists = folder / "lists";
  ASSERT_EQ(runFidelis({"spec", "export", "--project", project, "--csv", lists}).status, 0);
  auto run = runFidelis({"spec", "import", lists, "--project", project});
  EXPECT_EQ(run.status, 0) << run.messages;
  EXPECT_THAT(run.messages, HasSubstr("added: 0, changed: 0, removed: 0"));

  core::writeFile(folder / "lists/requirements.csv", "id,status\nRangeError_Fog_1,maybe\n");
  run = runFidelis({"spec", "import", lists, "--project", project});
  EXPECT_EQ(run.status, 2);
  EXPECT_THAT(run.messages, HasSubstr("requirements.csv:2, row 2, column status: 'maybe' is not known"));
}

TEST_F(SpecCommand, PrunesOnlyWhenTold) {
  const std::string lists = folder / "lists";
  ASSERT_EQ(runFidelis({"spec", "export", "--project", project, "--csv", lists}).status, 0);
  core::writeFile(folder / "lists/requirements.csv", "id,status\n");
  core::writeFile(folder / "lists/links.csv", "from,to\n");
  auto run = runFidelis({"spec", "import", lists, "--project", project});
  EXPECT_THAT(run.messages, HasSubstr("RangeError_Fog_1: not in the lists; kept"));
  EXPECT_EQ(specs::ProjectStore::open(project).all<specs::Requirement>().size(), 1u);
  run = runFidelis({"spec", "import", lists, "--project", project, "--prune"});
  EXPECT_EQ(run.status, 0) << run.messages;
  EXPECT_TRUE(specs::ProjectStore::open(project).all<specs::Requirement>().empty());
}

TEST_F(SpecCommand, CheckFailsForErrorsOnly) {
  auto run = runFidelis({"spec", "check", "--project", project});
  EXPECT_EQ(run.status, 1);
  EXPECT_THAT(run.out, HasSubstr("RangeError_Fog_1: error: is accepted, but no test"));
  EXPECT_THAT(run.out, HasSubstr("[requirement-untested]"));

  auto store = specs::ProjectStore::open(project);
  auto requirement = store.find<specs::Requirement>("RangeError_Fog_1").value();
  requirement.status = specs::Status::UnderReview;
  store.update(requirement, {});
  run = runFidelis({"spec", "check", "--project", project, "--json", "-"});
  EXPECT_EQ(run.status, 0) << run.out;
  EXPECT_EQ(nlohmann::json::parse(run.out).at("errors"), 0);
}

TEST_F(SpecCommand, TracesBothWays) {
  const auto run = runFidelis({"spec", "trace", "RangeError_Fog_1", "--project", project});
  EXPECT_EQ(run.status, 0) << run.messages;
  EXPECT_THAT(run.out, HasSubstr("CEPRA row: "));
  EXPECT_THAT(run.out, HasSubstr("leads to: nothing"));
  const auto unknown = runFidelis({"spec", "trace", "RangeError_Fig_1", "--project", project});
  EXPECT_EQ(unknown.status, 2);
  EXPECT_THAT(unknown.messages, HasSubstr("Did you mean 'RangeError_Fog_1'?"));
}

TEST_F(SpecCommand, ReadingLeavesTheProjectAlone) {
  const std::string before = core::readFile(project);
  EXPECT_EQ(runFidelis({"spec", "export", "--project", project, "--html", folder / "s.html"}).status, 0);
  EXPECT_EQ(runFidelis({"spec", "check", "--project", project}).status, 1);
  EXPECT_EQ(runFidelis({"spec", "trace", "RangeError_Fog_1", "--project", project}).status, 0);
  EXPECT_EQ(core::readFile(project), before);
  EXPECT_FALSE(std::filesystem::exists(project + "-wal"));
}

}  // namespace
