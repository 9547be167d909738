#include "cepra/csv.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <unordered_map>

#include "core/csv.h"
#include "core/error.h"
#include "core/file.h"
#include "core/text.h"

namespace cepra {

namespace fs = std::filesystem;
using percollect::NodeKind;

namespace {

constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";

/// Spreadsheets take a text that begins with = + - @ for a formula. An apostrophe in front stops that; texts that
/// already look like this get one more, so that the import can take away exactly one.
bool looksLikeFormula(std::string_view text) {
  const std::size_t first = text.find_first_not_of('\'');
  return first != std::string_view::npos && std::string_view("=+-@").find(text[first]) != std::string_view::npos;
}
std::string guarded(const std::string& text) { return looksLikeFormula(text) ? "'" + text : text; }
std::string unguarded(std::string text) {
  if (text.starts_with('\'') && looksLikeFormula(text)) text.erase(0, 1);
  return text;
}

/// Line breaks as the table has them: a spreadsheet may turn LF into CR LF.
std::string withPlainLineBreaks(std::string_view text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\r' && i + 1 < text.size() && text[i + 1] == '\n') continue;
    result += text[i];
  }
  return result;
}

std::string causeTitles(const Row& row, NodeKind kind) {
  std::vector<std::string> titles;
  for (const Cause& cause : row.causesOfKind(kind)) titles.push_back(cause.title);
  return core::join(titles, "; ");
}

template <typename Items, typename Text>
std::string joined(const Items& items, std::string_view separator, Text text) {
  std::vector<std::string> parts;
  for (const auto& item : items) parts.push_back(text(item));
  return core::join(parts, separator);
}

std::string numberText(std::optional<int> number) { return number ? std::to_string(*number) : ""; }

/// One column: its name, what it shows, and where an edited text goes (nullptr: it is only there to be read).
struct Column {
  const char* name;
  std::string (*shown)(const Row&);
  std::string* (*edited)(Row&) = nullptr;
  std::optional<int>* (*score)(Row&) = nullptr;
};

const std::array<Column, 17> kColumns{{
    {"key", [](const Row& r) { return r.key; }},
    {"phenomenon", [](const Row& r) { return r.phenomenon().title; }},
    {"effect_path", [](const Row& r) { return joined(r.effects, " > ", [](const Effect& e) { return e.title; }); }},
    {"effect", [](const Row& r) { return r.lastEffect().title; }},
    {"design_parameters", [](const Row& r) { return causeTitles(r, NodeKind::DesignParameter); }},
    {"system_independent_causes", [](const Row& r) { return causeTitles(r, NodeKind::SystemIndependent); }},
    {"occurrence", [](const Row& r) { return numberText(r.occurrence.value); }, nullptr,
     [](Row& r) { return &r.occurrence.value; }},
    {"occurrence_rationale", [](const Row& r) { return r.occurrence.rationale; },
     [](Row& r) { return &r.occurrence.rationale; }},
    {"occurrence_expert", [](const Row& r) { return r.occurrence.expert; },
     [](Row& r) { return &r.occurrence.expert; }},
    {"impact", [](const Row& r) { return numberText(r.impact.value); }, nullptr,
     [](Row& r) { return &r.impact.value; }},
    {"impact_rationale", [](const Row& r) { return r.impact.rationale; }, [](Row& r) { return &r.impact.rationale; }},
    {"impact_expert", [](const Row& r) { return r.impact.expert; }, [](Row& r) { return &r.impact.expert; }},
    {"relevance", [](const Row& r) { return numberText(r.relevance()); }},
    {"suspect", [](const Row& r) { return r.suspect; }, [](Row& r) { return &r.suspect; }},
    {"notes", [](const Row& r) { return r.notes; }, [](Row& r) { return &r.notes; }},
    {"effect_ids", [](const Row& r) { return joined(r.effects, " > ", [](const Effect& e) { return e.id; }); }},
    {"cause_ids", [](const Row& r) { return joined(r.causes, "; ", [](const Cause& c) { return c.id; }); }},
}};

bool isReadOnly(const Column& column) { return !column.edited && !column.score; }

/// "A", ..., "Z", "AA": the letters above a spreadsheet.
std::string columnLetters(std::size_t index) {
  std::string letters;
  for (std::size_t n = index + 1; n > 0; n = (n - 1) / 26) letters.insert(0, 1, static_cast<char>('A' + (n - 1) % 26));
  return letters;
}

/// The cells of a CSV file with the numbers that a spreadsheet shows beside them.
struct Sheet {
  struct Line {
    std::size_t row = 0;  ///< as the spreadsheet counts; the header is row 1
    int line = 0;         ///< in the file
    std::vector<std::string> cells;
  };
  fs::path file;
  std::vector<std::string> header;
  std::vector<Line> lines;
};

[[noreturn]] void fail(const fs::path& file, int line, const std::string& item, const std::string& problem,
                       const std::string& remedy) {
  throw core::InputError({.file = file, .line = line, .item = item}, problem, remedy);
}

/// Whichever of , ; and tab the header has most of.
char delimiterOf(std::string_view text) {
  const std::string_view header = text.substr(0, text.find_first_of("\r\n"));
  const auto count = [&](char c) { return std::count(header.begin(), header.end(), c); };
  const std::array candidates{',', ';', '\t'};
  return *std::max_element(candidates.begin(), candidates.end(), [&](char a, char b) { return count(a) < count(b); });
}

void checkText(const fs::path& file, const std::string& text) {
  if (const auto offset = core::findInvalidUtf8(text)) {
    fail(file, core::lineAt(text, *offset), "", "is not UTF-8.", "Save it again as 'CSV UTF-8'.");
  }
  if (const auto zero = text.find('\0'); zero != std::string::npos) {
    fail(file, core::lineAt(text, zero), "", "contains a zero byte.", "Save it again as 'CSV UTF-8'.");
  }
  // In a CSV file every quote has a partner; without it all that follows would be swallowed by one cell.
  if (std::count(text.begin(), text.end(), '"') % 2 != 0) {
    fail(file, core::lineAt(text, text.rfind('"')), "", "has a quote without a partner.",
         "Add the missing '\"', or save it again from the spreadsheet.");
  }
}

void addLine(Sheet& sheet, Sheet::Line line) {
  const auto isEmpty = [](const std::string& cell) { return cell.empty(); };
  if (std::all_of(line.cells.begin(), line.cells.end(), isEmpty)) return;
  const std::size_t width = sheet.header.size();
  for (std::size_t i = width; i < line.cells.size(); ++i) {
    if (line.cells[i].empty()) continue;
    fail(sheet.file, line.line,
         "row " + std::to_string(line.row) + " (cell " + columnLetters(i) + std::to_string(line.row) + ")",
         "has more cells than the header.", "Check the quotes and separators of this row.");
  }
  line.cells.resize(width);  // some spreadsheets leave out empty cells at the end of a row
  sheet.lines.push_back(std::move(line));
}

Sheet readSheet(const fs::path& file) {
  const std::string text = core::readFile(file);
  checkText(file, text);
  Sheet sheet;
  sheet.file = file;
  std::size_t row = 0;
  int next_line = 1;
  core::eachCsvRecord(
      text,
      [&](int line, std::span<const std::string_view> fields) {
        row += 1 + static_cast<std::size_t>(line - next_line);  // blank lines are rows too
        next_line = line + 1;
        Sheet::Line record{.row = row, .line = line};
        for (const std::string_view field : fields) {
          next_line += static_cast<int>(std::count(field.begin(), field.end(), '\n'));
          record.cells.push_back(withPlainLineBreaks(field));
        }
        if (sheet.header.empty()) {
          for (const std::string& cell : record.cells) sheet.header.push_back(core::lowerCase(core::trimmed(cell)));
        } else {
          addLine(sheet, std::move(record));
        }
      },
      delimiterOf(text));
  if (sheet.header.empty()) fail(file, 0, "", "is empty; a header line was expected.", "Export the table again.");
  return sheet;
}

class Importer {
 public:
  Importer(const Table& table, const fs::path& file) : before_(table), sheet_(readSheet(file)) {
    result_.table = table;
    for (std::size_t i = 0; i < table.rows.size(); ++i) row_of_key_[table.rows[i].key] = i;
    findColumns();
  }

  CsvImport run() {
    for (const Sheet::Line& line : sheet_.lines) readLine(line);
    reportEditedReadOnlyColumns();
    reportMissingRows();
    for (std::size_t i = 0; i < before_.rows.size(); ++i) {
      if (before_.rows[i] != result_.table.rows[i]) ++result_.changed;
    }
    reportChecks();
    return std::move(result_);
  }

 private:
  void warn(int line, const std::string& column, const std::string& text, const std::string& remedy) {
    result_.findings.push_back({Severity::Warning, sheet_.file, line, "", column, text, remedy});
  }

  void findColumns() {
    position_.assign(kColumns.size(), std::nullopt);
    for (std::size_t i = 0; i < sheet_.header.size(); ++i) {
      const std::string& name = sheet_.header[i];
      const auto known =
          std::find_if(kColumns.begin(), kColumns.end(), [&](const Column& c) { return name == c.name; });
      if (known == kColumns.end()) {
        reportUnknownColumn(i);
        continue;
      }
      auto& position = position_[static_cast<std::size_t>(known - kColumns.begin())];
      if (position) fail(sheet_.file, 1, "column " + name, "stands twice in the header.", "Remove one of the two.");
      position = i;
    }
    if (!position_[0]) {
      fail(sheet_.file, 1, "", "has no column 'key', so no row can be told from another.",
           "Keep the column 'key' of the export; only its place may change.");
    }
    for (std::size_t c = 0; c < kColumns.size(); ++c) {
      if (position_[c] || isReadOnly(kColumns[c])) continue;
      warn(1, kColumns[c].name, "the file has no such column; what the table has there was kept.",
           "Export again if the column is to be edited.");
    }
  }

  void reportUnknownColumn(std::size_t index) {
    const bool is_used = std::any_of(sheet_.lines.begin(), sheet_.lines.end(),
                                     [&](const Sheet::Line& line) { return !line.cells[index].empty(); });
    if (sheet_.header[index].empty() && !is_used) return;
    std::vector<std::string> names;
    for (const Column& column : kColumns) names.emplace_back(column.name);
    const std::string nearest = core::nearestName(sheet_.header[index], names);
    warn(1, sheet_.header[index].empty() ? columnLetters(index) : sheet_.header[index],
         "the column is not known and was ignored.",
         nearest.empty() ? "Move what is to be kept to 'notes'." : "Did you mean '" + nearest + "'?");
  }

  [[nodiscard]] std::string nameOfCell(const Sheet::Line& line, std::size_t column) const {
    return "row " + std::to_string(line.row) + ", column " + kColumns[column].name + " (cell " +
           columnLetters(*position_[column]) + std::to_string(line.row) + ")";
  }

  std::size_t rowOf(const Sheet::Line& line) {
    const std::string key = core::trimmed(line.cells[*position_[0]]);
    const std::string cell = nameOfCell(line, 0);
    if (key.empty()) {
      fail(sheet_.file, line.line, cell, "the key is missing.",
           "Copy it from the export, or empty the whole row; rows come from the graph, not from the spreadsheet.");
    }
    const auto found = row_of_key_.find(key);
    if (found == row_of_key_.end()) failUnknownKey(line, key);
    const auto [first, is_new] = line_of_row_.emplace(found->second, &line);
    if (!is_new) {
      fail(sheet_.file, line.line, cell,
           "the key '" + key + "' stands in row " + std::to_string(first->second->row) + " already.",
           "Remove one of the two rows.");
    }
    return found->second;
  }

  [[noreturn]] void failUnknownKey(const Sheet::Line& line, const std::string& key) const {
    std::vector<std::string> keys;
    for (const Row& row : before_.rows) keys.push_back(row.key);
    const std::string nearest = core::nearestName(key, keys);
    fail(sheet_.file, line.line, nameOfCell(line, 0), "the table has no row with the key '" + key + "'.",
         nearest.empty() ? "Remove the row, or import the file into the project that it was exported from."
                         : "Did you mean '" + nearest + "'?");
  }

  void readLine(const Sheet::Line& line) {
    const std::size_t index = rowOf(line);
    Row& row = result_.table.rows[index];
    for (std::size_t c = 1; c < kColumns.size(); ++c) {
      if (!position_[c]) continue;
      const Column& column = kColumns[c];
      const std::string& cell = line.cells[*position_[c]];
      if (column.score) {
        *column.score(row) = readScore(line, c, cell);
      } else if (column.edited) {
        *column.edited(row) = unguarded(cell);
      } else if (std::string_view(column.name) != "relevance" &&  // stale as soon as a score is edited
                 core::trimmed(unguarded(cell)) !=
                     core::trimmed(withPlainLineBreaks(column.shown(before_.rows[index])))) {
        edited_[c].push_back(line.row);
      }
    }
  }

  [[nodiscard]] std::optional<int> readScore(const Sheet::Line& line, std::size_t column,
                                             const std::string& cell) const {
    const std::string text = core::trimmed(cell);
    if (text.empty()) return std::nullopt;
    double value = 0.0;
    if (!core::parseNumber(text, value) || !(value >= 1.0 && value <= 10.0) || value != std::floor(value)) {
      fail(sheet_.file, line.line, nameOfCell(line, column), "'" + text + "' is no score.",
           "Write a whole number from 1 to 10, or leave the cell empty.");
    }
    return static_cast<int>(value);
  }

  void reportEditedReadOnlyColumns() {
    for (const auto& [column, rows] : edited_) {
      warn(0, kColumns[column].name,
           "the column was edited in " + std::to_string(rows.size()) + " row(s), first in row " +
               std::to_string(rows.front()) + "; that was ignored.",
           "It shows the graph; change the graph instead.");
    }
  }

  void reportMissingRows() {
    const std::size_t missing = before_.rows.size() - line_of_row_.size();
    if (missing == 0) return;
    warn(0, "key", std::to_string(missing) + " row(s) of the table are not in the file; they were kept as they are.",
         "To take back a score, empty its cell.");
  }

  void reportChecks() {
    for (Finding finding : check(result_.table)) {
      finding.file = sheet_.file;
      const auto row = row_of_key_.find(finding.row);
      const auto line = row == row_of_key_.end() ? line_of_row_.end() : line_of_row_.find(row->second);
      if (line != line_of_row_.end()) finding.line = line->second->line;
      result_.findings.push_back(std::move(finding));
    }
  }

  const Table& before_;
  Sheet sheet_;
  CsvImport result_;
  std::unordered_map<std::string, std::size_t> row_of_key_;
  std::unordered_map<std::size_t, const Sheet::Line*> line_of_row_;
  std::vector<std::optional<std::size_t>> position_;        ///< of each known column in the file
  std::map<std::size_t, std::vector<std::size_t>> edited_;  ///< rows by read-only column
};

}  // namespace

std::string toCsv(const Table& table) {
  std::vector<std::string> cells;
  for (const Column& column : kColumns) cells.emplace_back(column.name);
  std::string text = std::string(kByteOrderMark) + core::csvRecord(cells);
  for (const Row& row : table.rows) {
    cells.clear();
    for (const Column& column : kColumns) cells.push_back(guarded(column.shown(row)));
    text += core::csvRecord(cells);
  }
  return text;
}

void exportCsv(const Table& table, const fs::path& file) { core::writeFile(file, toCsv(table)); }

CsvImport importCsv(const Table& table, const fs::path& file) { return Importer(table, file).run(); }

}  // namespace cepra
