#include "cepra/csv.h"

#include <algorithm>
#include <fstream>
#include <gmock/gmock.h>

#include "core/csv.h"
#include "core/file.h"
#include "core/random.h"
#include "percollect/read_graph.h"
#include "tests/percollect/small_graph.h"
#include "tests/support/paths.h"
#include "tests/support/thrown_message.h"

using cepra::buildTable;
using cepra::importCsv;
using cepra::Row;
using cepra::Table;
using test_support::TemporaryFolder;
using test_support::thrownMessage;
using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;

namespace {

/// Three rows: p, p > a, p > b.
Table unscored() {
  return buildTable(test_support::smallGraph({"e:p", "e:a", "e:b", "d:x", "s:y"},
                                             {{"p", "x"}, {"p", "a"}, {"a", "y"}, {"a", "x"}, {"p", "b"}, {"b", "y"}}));
}

/// With everything that spreadsheets and CSV readers are known to spoil.
Table scored() {
  Table table = unscored();
  table.rows[0].occurrence = {7, "He said: \"often\",\nthen left; really\t.", "J\xc3\xb6rg M\xc3\xbcller"};
  table.rows[0].impact = {10, "=SUM(A1)", "+49 6151 16-0"};
  table.rows[0].notes = " blanks around ";
  table.rows[1].occurrence = {1, "- a list\n- of dashes\n", "@home"};
  table.rows[1].impact = {std::nullopt, "'quoted'", "'=not a formula"};
  table.rows[1].suspect = "look again";
  table.rows[2].impact = {5, "\"", ","};
  table.rows[2].notes = "\xe2\x80\x9c\xf0\x9f\x9a\x97\xe2\x80\x9d \xce\xb1 \xef\xbb\xbf";
  return table;
}

using Cells = std::vector<std::vector<std::string>>;

/// What a spreadsheet does with the file: read the cells, let somebody edit them, and write them again.
Cells cellsOf(const Table& table) {
  Cells cells;
  core::eachCsvRecord(cepra::toCsv(table), [&](int, std::span<const std::string_view> fields) {
    cells.emplace_back(fields.begin(), fields.end());
  });
  return cells;
}

std::string csvOf(const Cells& cells, const std::string& separator = ",", const std::string& line_end = "\n") {
  std::string text;
  for (const auto& row : cells) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      std::string quoted;
      for (const char c : row[i]) quoted += c == '"' ? "\"\"" : std::string(1, c);
      text += (i > 0 ? separator : "") + "\"" + quoted + "\"";
    }
    text += line_end;
  }
  return text;
}

std::size_t columnOf(const Cells& cells, const std::string& name) {
  return static_cast<std::size_t>(std::find(cells[0].begin(), cells[0].end(), name) - cells[0].begin());
}

class Csv : public testing::Test {
 protected:
  cepra::CsvImport import(const Table& table, const std::string& text) {
    return importCsv(table, folder_.write("table.csv", text));
  }
  /// The message after one cell of the exported table was overwritten. `row` as the spreadsheet counts.
  std::string errorAfter(std::size_t row, const std::string& column, const std::string& content) {
    Cells cells = cellsOf(unscored());
    cells[row - 1][columnOf(cells, column)] = content;
    return thrownMessage([&] { (void)import(unscored(), csvOf(cells)); });
  }
  std::vector<std::string> findingsOf(const cepra::CsvImport& import) {
    std::vector<std::string> texts;
    for (const auto& finding : import.findings) texts.push_back(toString(finding));
    return texts;
  }
  TemporaryFolder folder_;
};

}  // namespace

TEST_F(Csv, ExportAndImportLoseNothing) {
  exportCsv(scored(), folder_ / "table.csv");
  EXPECT_EQ(importCsv(scored(), folder_ / "table.csv").table, scored());
  const auto into_empty = importCsv(unscored(), folder_ / "table.csv");
  EXPECT_EQ(into_empty.table, scored());
  EXPECT_EQ(into_empty.changed, 3u);
}

TEST_F(Csv, SameTableGivesSameBytesWithAByteOrderMark) {
  EXPECT_EQ(cepra::toCsv(scored()), cepra::toCsv(scored()));
  EXPECT_TRUE(cepra::toCsv(scored()).starts_with("\xef\xbb\xbfkey,phenomenon,"));
}

TEST_F(Csv, NoCellLooksLikeAFormulaOrANumberedKey) {
  for (const auto& row : cellsOf(scored())) {
    for (const std::string& cell : row) EXPECT_EQ(cell.find_first_of("=+-@"), cell.find_first_of("=+-@", 1)) << cell;
    EXPECT_FALSE(row[0].empty() || (row[0][0] >= '0' && row[0][0] <= '9'));
  }
}

TEST_F(Csv, OtherSpreadsheetsSeparatorsLineEndsAndOrdersAreUnderstood) {
  Cells cells = cellsOf(scored());
  std::reverse(cells.begin() + 1, cells.end());
  for (auto& row : cells) std::reverse(row.begin(), row.end());
  for (const std::string separator : {",", ";", "\t"}) {
    for (const std::string line_end : {"\n", "\r\n"}) {
      EXPECT_EQ(import(unscored(), csvOf(cells, separator, line_end)).table, scored()) << separator;
    }
  }
}

TEST_F(Csv, LineBreaksInsideCellsMayBecomeCrLf) {
  std::string text = csvOf(cellsOf(scored()));
  for (std::size_t at = text.find('\n'); at != std::string::npos; at = text.find('\n', at + 2)) text.insert(at, "\r");
  EXPECT_EQ(import(unscored(), text).table, scored());
}

TEST_F(Csv, EmptyRowsEmptyColumnsAndCutRowsAreNoHarm) {
  Cells cells = cellsOf(scored());
  cells.insert(cells.begin() + 2, std::vector<std::string>(cells[0].size()));
  for (auto& row : cells) row.insert(row.end(), 2, "");
  cells.back().resize(columnOf(cells, "notes"));
  Table expected = scored();
  expected.rows[2].notes.clear();
  EXPECT_EQ(import(unscored(), csvOf(cells)).table, expected);
}

TEST_F(Csv, EditsOfScoresArriveAndEmptyCellsTakeThemBack) {
  Cells cells = cellsOf(scored());
  cells[1][columnOf(cells, "occurrence")] = " 3.0 ";
  cells[3][columnOf(cells, "impact")] = "";
  cells[2][columnOf(cells, "suspect")] = "";
  const auto result = import(scored(), csvOf(cells));
  EXPECT_EQ(result.table.rows[0].occurrence.value, 3);
  EXPECT_EQ(result.table.rows[2].impact.value, std::nullopt);
  EXPECT_FALSE(result.table.rows[1].isSuspect());
  EXPECT_EQ(result.changed, 3u);
}

TEST_F(Csv, ABadScoreNamesItsCell) {
  for (const std::string bad : {"0", "11", "4.5", "high", "-3", "nan", "1e1000", "7,0"}) {
    EXPECT_THAT(errorAfter(3, "occurrence", bad),
                AllOf(HasSubstr("table.csv:3, row 3, column occurrence (cell G3): '" + bad + "' is no score"),
                      HasSubstr("whole number from 1 to 10")));
  }
  EXPECT_THAT(errorAfter(4, "impact", "0"), HasSubstr("row 4, column impact (cell J4)"));
}

TEST_F(Csv, RowsAreCountedAsTheSpreadsheetShowsThem) {
  Cells cells = cellsOf(scored());  // row 2 spans several lines
  cells[3][columnOf(cells, "occurrence")] = "high";
  std::string text = csvOf(cells, ",", "\r\n");
  EXPECT_THAT(thrownMessage([&] { (void)import(unscored(), text); }), HasSubstr("row 4, column occurrence (cell G4)"));
  text.insert(text.find("\r\n") + 2, "\r\n\r\n");  // two blank rows under the header
  EXPECT_THAT(thrownMessage([&] { (void)import(unscored(), text); }), HasSubstr("row 6, column occurrence (cell G6)"));
}

TEST_F(Csv, UnknownDoubledAndMissingKeysAreNamed) {
  const std::string key = unscored().rows[0].key;
  EXPECT_THAT(errorAfter(2, "key", key.substr(0, 12) + "z"),
              AllOf(HasSubstr("row 2, column key (cell A2): the table has no row"), HasSubstr("mean '" + key + "'")));
  EXPECT_THAT(errorAfter(3, "key", key), AllOf(HasSubstr("(cell A3)"), HasSubstr("stands in row 2 already")));
  EXPECT_THAT(errorAfter(3, "key", ""), AllOf(HasSubstr("(cell A3)"), HasSubstr("the key is missing")));
  EXPECT_THAT(errorAfter(1, "key", "keys"), HasSubstr("has no column 'key'"));
  EXPECT_THAT(errorAfter(1, "notes", "impact"), HasSubstr("column impact: stands twice"));
}

TEST_F(Csv, WhatIsNoCsvOfOursIsRefused) {
  const auto errorOf = [&](const std::string& text) { return thrownMessage([&] { (void)import(unscored(), text); }); };
  EXPECT_THAT(errorOf(""), HasSubstr("is empty"));
  EXPECT_THAT(errorOf("key,notes\nr1,M\xfcller\n"), AllOf(HasSubstr(":2: is not UTF-8"), HasSubstr("CSV UTF-8")));
  EXPECT_THAT(errorOf("key,notes\nr1,\"open\n"), AllOf(HasSubstr(":2: has a quote without a partner")));
  EXPECT_THAT(errorOf("key\n" + unscored().rows[0].key + ",7\n"), HasSubstr("row 2 (cell B2): has more cells"));
}

TEST_F(Csv, IgnoredColumnsAndRowsAreReported) {
  Cells cells = cellsOf(scored());
  cells.pop_back();
  cells[1][columnOf(cells, "effect")] = "something else";
  cells[0][columnOf(cells, "notes")] = "note";
  cells[0].push_back("my colour");
  cells[1].push_back("red");
  const auto result = import(scored(), csvOf(cells));
  EXPECT_EQ(result.table, scored());
  const auto texts = findingsOf(result);
  EXPECT_THAT(texts, Contains(AllOf(HasSubstr("column my colour"), HasSubstr("ignored"))));
  EXPECT_THAT(texts, Contains(AllOf(HasSubstr("column note:"), HasSubstr("Did you mean 'notes'?"))));
  EXPECT_THAT(texts, Contains(AllOf(HasSubstr("column effect:"), HasSubstr("edited in 1 row(s), first in row 2"))));
  EXPECT_THAT(texts, Contains(AllOf(HasSubstr("column notes:"), HasSubstr("no such column"))));
  EXPECT_THAT(texts, Contains(HasSubstr("1 row(s) of the table are not in the file")));
}

TEST_F(Csv, AScoreWithoutRationaleOrExpertIsReportedWithItsLine) {
  Cells cells = cellsOf(unscored());
  cells[2][columnOf(cells, "occurrence")] = "5";
  const auto texts = findingsOf(import(unscored(), csvOf(cells)));
  EXPECT_THAT(texts, Contains(AllOf(HasSubstr("table.csv:3, row " + unscored().rows[1].key),
                                    HasSubstr("the score has no rationale"))));
  EXPECT_THAT(texts, Contains(HasSubstr("the score has no expert")));
}

TEST_F(Csv, DamagedFilesAreReadOrRefused) {
  const std::string whole = cepra::toCsv(scored());
  core::Random random({.seed = 3});
  for (int round = 0; round < 2000; ++round) {
    std::string text = whole;
    const std::size_t at = random.below(static_cast<std::uint32_t>(text.size()));
    if (round % 3 == 0) text.resize(at);
    if (round % 3 == 1) text[at] = static_cast<char>(random.below(256));
    if (round % 3 == 2) text.erase(at, random.below(40));
    std::ofstream(folder_ / "damaged.csv", std::ios::binary) << text;
    try {
      const auto result = importCsv(unscored(), folder_ / "damaged.csv");
      EXPECT_EQ(result.table.rows.size(), 3u);
    } catch (const core::InputError& error) {
      EXPECT_FALSE(error.remedy().empty());
    }
  }
}

TEST_F(Csv, ThousandsOfRowsComeBackEqual) {
  FIDELIS_NEEDS_SHARED(shared);
  const Table table =
      buildTable(percollect::readGraph(shared / "data/percollect/json/lidarlimbs-2022-10-14.json").graph);
  exportCsv(table, folder_ / "table.csv");
  EXPECT_EQ(importCsv(table, folder_ / "table.csv").table, table);
}
