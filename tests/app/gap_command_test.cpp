#include <gmock/gmock.h>

#include "core/csv.h"
#include "tests/support/paths.h"
#include "tests/support/program.h"

// `fidelis gap` as scripts see it. What it finds is the business of tests/gap and of the demo.
namespace {

using test_support::ProgramRun;
using test_support::runFidelis;
using testing::HasSubstr;

class GapCommand : public testing::Test {
 protected:
  /// Few effects, so that it takes seconds.
  ProgramRun gap(std::vector<std::string> options) const {
    std::vector<std::string> words{
        "gap", demo("foggy-sweep"), "--model", demo("model.json"), "--library", "atmospheric-attenuation,range-offset"};
    words.insert(words.end(), options.begin(), options.end());
    return runFidelis(words);
  }
  static std::string demo(const std::string& name) { return test_support::sourceFolder() / "resources/demo" / name; }
  [[nodiscard]] std::size_t filesLeft() const {
    return static_cast<std::size_t>(std::distance(std::filesystem::recursive_directory_iterator(folder_.path()),
                                                  std::filesystem::recursive_directory_iterator()));
  }

  test_support::TemporaryFolder folder_;
};

TEST_F(GapCommand, ListsEveryHypothesisThatWasTried) {
  const std::string file = folder_ / "tried.csv";
  const ProgramRun run = gap({"--candidates", file});
  ASSERT_EQ(run.status, 0) << run.messages;
  const core::CsvTable table = core::readCsvTable(file);
  EXPECT_EQ(table.header, (std::vector<std::string>{"rank", "kind", "name", "variant", "sensors", "free_numbers",
                                                    "values", "explained", "discrepancy", "bic", "similarity"}));
  ASSERT_GE(table.rows.size(), 3U);
  EXPECT_EQ(table.rows[0][table.column("kind")], "none");
  EXPECT_EQ(table.rows[1][table.column("rank")], "1");
  EXPECT_EQ(table.rows[1][table.column("name")], "atmospheric-attenuation");
  EXPECT_THAT(table.rows[1][table.column("values")], HasSubstr("visibility_m="));
}

TEST_F(GapCommand, AListThatCannotBeWrittenIsAnErrorAndLeavesNothing) {
  const ProgramRun run = gap({"--candidates", folder_ / "no/such/tried.csv", "--json", folder_ / "report.json"});
  EXPECT_EQ(run.status, 2);
  EXPECT_EQ(run.out, "");
  EXPECT_THAT(run.messages, HasSubstr("tried.csv: cannot be written"));
  EXPECT_EQ(filesLeft(), 0U);
}

TEST_F(GapCommand, SaysWhatCanBeLeftOutAndThatNobodyMayRelyOnTheRest) {
  const ProgramRun known = gap({"--without", "parameters,references"});
  EXPECT_EQ(known.status, 0) << known.messages;
  EXPECT_THAT(known.out, HasSubstr("note: Made without references, parameters"));
  EXPECT_THAT(known.out, testing::Not(HasSubstr("peak_power_w")));
  const ProgramRun unknown = gap({"--without", "reference"});
  EXPECT_EQ(unknown.status, 2);
  EXPECT_THAT(unknown.messages, HasSubstr("'reference' is no part that can be left out"));
  EXPECT_THAT(unknown.messages, HasSubstr("references, parameters, hold-out"));
}

}  // namespace
