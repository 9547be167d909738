#include <gmock/gmock.h>
#include <nlohmann/json.hpp>
#include <set>

#include "core/file.h"
#include "tests/app/cli_project.h"
#include "tests/support/paths.h"
#include "tests/support/program.h"

namespace {

using test_support::runFidelis;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class ImportCommand : public ::testing::Test {
 protected:
  test_support::TemporaryFolder folder;
  std::string project = folder / "demo.fidelis";
  std::string graph = folder.write("small-2024.json", test_app::smallRelease());
};

TEST_F(ImportCommand, CountsWithoutAProject) {
  const auto run = runFidelis({"import", graph, "--json", "-", "--quiet"});
  EXPECT_EQ(run.status, 0) << run.messages;
  const auto json = nlohmann::json::parse(run.out);
  EXPECT_EQ(json.at("nodes"), 3);
  EXPECT_EQ(json.at("edges"), 2);
  EXPECT_EQ(json.at("phenomena"), 1);
  EXPECT_EQ(json.at("chains"), 1);
  EXPECT_EQ(json.at("cepra_rows"), 1);
  EXPECT_TRUE(json.at("warnings").is_array());
  EXPECT_THAT(run.messages, IsEmpty());
}

TEST_F(ImportCommand, MakesAProjectThatHoldsTheGraph) {
  const auto run = runFidelis({"import", graph, "--project", project, "--author", "eve"});
  EXPECT_EQ(run.status, 0) << run.messages;
  EXPECT_THAT(run.out, HasSubstr("3 nodes"));
  const auto store = specs::ProjectStore::open(project);
  EXPECT_EQ(store.graph()->size(), 3u);
  EXPECT_EQ(store.graphImport()->who, "eve");
  EXPECT_FALSE(store.cepra().rows.empty());
}

TEST_F(ImportCommand, ABrokenFileLeavesNoProjectAndChangesNone) {
  const std::string broken = folder.write("broken.json", "[{\"id\": \"0\",\n  \"parentIds\": [");
  auto run = runFidelis({"import", broken, "--project", project});
  EXPECT_EQ(run.status, 2);
  EXPECT_THAT(run.messages, HasSubstr("broken.json:2"));
  EXPECT_FALSE(std::filesystem::exists(project));

  EXPECT_EQ(runFidelis({"import", graph, "--project", project}).status, 0);
  const std::string before = core::readFile(project);
  EXPECT_EQ(runFidelis({"import", broken, "--project", project}).status, 2);
  EXPECT_EQ(core::readFile(project), before);
}

TEST_F(ImportCommand, ANewerReleaseSaysWhatChangedAndWhatIsSuspect) {
  ASSERT_EQ(runFidelis({"import", graph, "--project", project}).status, 0);
  test_app::addRequirement(project);
  auto run = runFidelis({"import", graph, "--project", project});
  EXPECT_THAT(run.out, HasSubstr("holds this release already"));

  const std::string newer = folder.write("small-2025.json", test_app::smallRelease("Attenuation by fog aerosols"));
  run = runFidelis({"import", newer, "--project", project});
  EXPECT_EQ(run.status, 0) << run.messages;
  EXPECT_THAT(run.out, HasSubstr("renamed 1 'Attenuation by fog aerosols'"));
  EXPECT_THAT(run.out, HasSubstr("CEPRA rows: 1 now"));
}

TEST_F(ImportCommand, AProjectThatIsNoneIsAnErrorAndStays) {
  const std::string text = folder.write("notes.txt", "dear diary, today I imported a graph");
  const auto run = runFidelis({"import", graph, "--project", text});
  EXPECT_EQ(run.status, 2);
  EXPECT_THAT(run.messages, HasSubstr("no project file"));
  EXPECT_EQ(core::readFile(text), "dear diary, today I imported a graph");
}

TEST_F(ImportCommand, WithoutPurposeIsBadUsage) {
  const auto run = runFidelis({"import", graph});
  EXPECT_EQ(run.status, 2);
  EXPECT_THAT(run.messages, HasSubstr("--project FILE"));
}

// The counts published with the releases (chains end at leaves, nodes reachable from the phenomena).
TEST_F(ImportCommand, CountsOfThePublishedReleases) {
  FIDELIS_NEEDS_SHARED(shared);
  struct Release {
    const char* path;
    int nodes, edges, phenomena, chains, rows;
  };
  for (const Release& release :
       {Release{"lidarlimbs-2021-xml", 137, 270, 3, 38775, 3925}, Release{"radarrami-2021-xml", 52, 68, 3, 62, 21},
        Release{"json/lidarlimbs-2025.json", 103, 209, 3, 921, 88},
        Release{"json/radarrami-2025.json", 105, 167, 3, 215, 66}}) {
    const auto run =
        runFidelis({"import", shared / "data/percollect" / release.path, "--project",
                    folder / (std::string(std::filesystem::path(release.path).stem()) + ".fidelis"), "--json", "-"});
    ASSERT_EQ(run.status, 0) << run.messages;
    const auto json = nlohmann::json::parse(run.out);
    EXPECT_EQ(json.at("nodes"), release.nodes) << release.path;
    EXPECT_EQ(json.at("edges"), release.edges) << release.path;
    EXPECT_EQ(json.at("phenomena"), release.phenomena) << release.path;
    EXPECT_EQ(json.at("chains"), release.chains) << release.path;
    EXPECT_EQ(json.at("cepra_rows"), release.rows) << release.path;
  }
}

// The two malformed files and the self-including one of the old lidar release: reported with file and line, survived.
TEST_F(ImportCommand, NamesTheBadFilesOfTheOldLidarRelease) {
  FIDELIS_NEEDS_SHARED(shared);
  const auto run = runFidelis({"import", shared / "data/percollect/lidarlimbs-2021-xml", "--json", "-"});
  ASSERT_EQ(run.status, 0) << run.messages;
  std::set<std::string> named;
  const auto json = nlohmann::json::parse(run.out);
  for (const auto& warning : json.at("warnings")) {
    named.insert(std::filesystem::path(warning.at("file").get<std::string>()).filename());
    EXPECT_FALSE(warning.at("text").get<std::string>().empty());
  }
  for (const char* file : {"pp2_node.xml", "pp6_node.xml", "sp80_node.xml"}) EXPECT_TRUE(named.count(file)) << file;
}

}  // namespace
