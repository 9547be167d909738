#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "core/csv.h"
#include "core/file.h"
#include "tests/app/cli_project.h"
#include "tests/support/program.h"

namespace {

using test_support::runFidelis;
using ::testing::HasSubstr;

class CepraCommand : public ::testing::Test {
 protected:
  CepraCommand() { EXPECT_EQ(runFidelis({"import", graph, "--project", project}).status, 0); }

  /// Sets a cell of the exported table, as a spreadsheet would.
  void setCell(const std::string& column, const std::string& value) const {
    core::CsvTable table = core::readCsvTable(csv);
    table.rows.at(0)[table.column(column)] = value;
    std::string text = core::csvRecord(table.header);
    for (const auto& row : table.rows) text += core::csvRecord(row);
    core::writeFile(csv, text);
  }

  test_support::TemporaryFolder folder;
  std::string project = folder / "demo.fidelis";
  std::string graph = folder.write("small.json", test_app::smallRelease());
  std::string csv = folder / "cepra.csv";
};

TEST_F(CepraCommand, ScoresTravelThroughASpreadsheet) {
  ASSERT_EQ(runFidelis({"cepra", "export", "--project", project, "--csv", csv}).status, 0);
  setCell("occurrence", "7");
  setCell("occurrence_rationale", "fog, \"often\"");
  setCell("occurrence_expert", "eve");
  const auto run = runFidelis({"cepra", "import", csv, "--project", project, "--author", "adam"});
  EXPECT_EQ(run.status, 0) << run.messages;
  EXPECT_THAT(run.messages, HasSubstr("1 of 1 rows changed"));
  const auto store = specs::ProjectStore::open(project);
  EXPECT_EQ(store.cepra().rows[0].occurrence, (cepra::Score{7, "fog, \"often\"", "eve"}));
  EXPECT_THAT(store.history(store.cepra().rows[0].key).back().who, "adam");
}

TEST_F(CepraCommand, ABadScoreNamesItsCellAndChangesNothing) {
  ASSERT_EQ(runFidelis({"cepra", "export", "--project", project, "--csv", csv}).status, 0);
  setCell("impact", "11");
  const auto run = runFidelis({"cepra", "import", csv, "--project", project});
  EXPECT_EQ(run.status, 2);
  EXPECT_THAT(run.messages, HasSubstr("column impact (cell J2)"));
  EXPECT_FALSE(specs::ProjectStore::open(project).cepra().rows[0].impact.value);
}

TEST_F(CepraCommand, BuildGivesTheSameTableFromGraphAndProject) {
  const auto from_graph = runFidelis({"cepra", "build", graph, "--csv", "-"});
  const auto from_project = runFidelis({"cepra", "build", "--project", project, "--csv", "-"});
  EXPECT_EQ(from_graph.status, 0) << from_graph.messages;
  EXPECT_EQ(from_graph.out, from_project.out);
  EXPECT_THAT(from_graph.out, HasSubstr("Attenuation by aerosols"));
  EXPECT_EQ(runFidelis({"cepra", "build", "--csv", "-"}).status, 2);
}

TEST_F(CepraCommand, CheckCountsAndReportsAsJson) {
  const auto run = runFidelis({"cepra", "check", "--project", project, "--json", "-"});
  EXPECT_EQ(run.status, 0) << run.messages;
  const auto json = nlohmann::json::parse(run.out);
  EXPECT_EQ(json.at("rows"), 1);
  EXPECT_EQ(json.at("scored"), 0);
  EXPECT_TRUE(json.at("findings").is_array());
}

TEST_F(CepraCommand, AProjectWithoutTableSaysWhatToDo) {
  const std::string empty = folder / "empty.fidelis";
  specs::ProjectStore::create(empty);
  for (const char* step : {"check", "export"}) {
    std::vector<std::string> words = {"cepra", step, "--project", empty};
    if (std::string(step) == "export") words.insert(words.end(), {"--csv", "-"});
    const auto run = runFidelis(words);
    EXPECT_EQ(run.status, 2);
    EXPECT_THAT(run.messages, HasSubstr("Import a graph first"));
  }
}

}  // namespace
