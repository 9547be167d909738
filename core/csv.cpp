#include "core/csv.h"

#include <algorithm>
#include <cmath>
#include <csv.h>
#include <exception>
#include <fmt/format.h>
#include <memory>
#include <set>

#include "core/error.h"
#include "core/file.h"
#include "core/text.h"

namespace core {

namespace {

/// What libcsv's callbacks write into: the fields of the current record, end to end in one buffer.
struct Collector {
  std::string buffer;
  std::vector<std::size_t> ends;

  void add(const void* bytes, std::size_t size) {
    if (bytes) buffer.append(static_cast<const char*>(bytes), size);
    ends.push_back(buffer.size());
  }
};

struct Run {
  Collector collector;
  std::vector<std::string_view> fields;
  const std::function<void(int, std::span<const std::string_view>)>* record = nullptr;
  int line = 1;           // line of the next record
  int record_breaks = 0;  // line breaks inside the fields of this record
  int terminator = 0;     // of the record before
  std::exception_ptr error;

  void endOfRecord() {
    fields.clear();
    std::size_t begin = 0;
    for (const std::size_t end : collector.ends) {
      fields.emplace_back(collector.buffer.data() + begin, end - begin);
      begin = end;
    }
    record_breaks = static_cast<int>(std::count(collector.buffer.begin(), collector.buffer.end(), '\n'));
    const bool blank = fields.empty() || (fields.size() == 1 && fields[0].empty());
    if (!blank && !error) {
      try {
        (*record)(line, fields);
      } catch (...) {
        error = std::current_exception();  // must not pass through C
      }
    }
    collector.buffer.clear();
    collector.ends.clear();
  }
};

void onField(void* bytes, std::size_t size, void* run) { static_cast<Run*>(run)->collector.add(bytes, size); }

void onRecord(int terminator, void* run) {
  auto& r = *static_cast<Run*>(run);
  const bool second_half_of_crlf = terminator == '\n' && r.terminator == '\r' && r.collector.ends.empty();
  r.terminator = terminator;
  if (second_half_of_crlf) return;  // one line break, though libcsv reports both characters
  r.endOfRecord();
  r.line += 1 + r.record_breaks;
}

}  // namespace

void eachCsvRecord(std::string_view text, const std::function<void(int, std::span<const std::string_view>)>& record,
                   char delimiter) {
  if (text.substr(0, 3) == "\xef\xbb\xbf") text.remove_prefix(3);
  csv_parser parser{};
  csv_init(&parser, CSV_REPALL_NL | CSV_APPEND_NULL);
  csv_set_delim(&parser, static_cast<unsigned char>(delimiter));
  const std::unique_ptr<csv_parser, void (*)(csv_parser*)> guard(&parser, csv_free);
  Run run;
  run.record = &record;
  // libcsv keeps the white space that a quoted field holds and trims it around a bare one, as spreadsheets do.
  constexpr std::size_t kChunk = 1 << 20;
  while (!text.empty() && !run.error) {
    const std::size_t size = std::min(kChunk, text.size());
    csv_parse(&parser, text.data(), size, onField, onRecord, &run);
    text.remove_prefix(size);
  }
  if (!run.error) csv_fini(&parser, onField, onRecord, &run);
  if (run.error) std::rethrow_exception(run.error);
}

std::optional<std::size_t> CsvTable::findColumn(std::string_view name) const {
  const auto found = std::find(header.begin(), header.end(), name);
  if (found == header.end()) return std::nullopt;
  return static_cast<std::size_t>(found - header.begin());
}

std::size_t CsvTable::column(const std::string& name) const {
  if (const auto index = findColumn(name)) return *index;
  const std::string nearest = nearestName(name, header);
  throw InputError({.file = file, .line = 1}, "has no column '" + name + "'.",
                   nearest.empty() ? "Its columns are " + join(header) + "." : "Did you mean '" + nearest + "'?");
}

CsvTable readCsvTable(const std::filesystem::path& file) {
  CsvTable table;
  table.file = file;
  const std::string text = readFile(file);
  eachCsvRecord(text, [&](int line, std::span<const std::string_view> fields) {
    if (table.header.empty()) {
      table.header.assign(fields.begin(), fields.end());
      return;
    }
    if (fields.size() != table.header.size()) {
      throw InputError({.file = file, .line = line},
                       fmt::format("has {} fields; the header has {}.", fields.size(), table.header.size()),
                       "Check the quotes and commas of this row.");
    }
    table.rows.emplace_back(fields.begin(), fields.end());
    table.lines.push_back(line);
  });
  if (table.header.empty()) {
    throw InputError({.file = file}, "is empty; a header line was expected.", "Export the file again.");
  }
  std::set<std::string> names;
  for (const std::string& name : table.header) {
    if (!names.insert(name).second) {
      throw InputError({.file = file, .line = 1}, "has two columns named '" + name + "'.", "Rename one of them.");
    }
  }
  return table;
}

std::string csvRecord(std::span<const std::string> fields) {
  std::string record;
  for (std::size_t i = 0; i < fields.size(); ++i) {
    if (i > 0) record += ',';
    const std::string& field = fields[i];
    const bool quoted = field.find_first_of(",\"\r\n") != std::string::npos ||
                        (!field.empty() && (field.front() == ' ' || field.back() == ' ' || field.front() == '\t' ||
                                            field.back() == '\t'));
    if (!quoted) {
      record += field;
      continue;
    }
    record += '"';
    for (const char c : field) {
      if (c == '"') record += '"';
      record += c;
    }
    record += '"';
  }
  return record + "\n";
}

std::vector<std::vector<double>> readNumericColumns(const std::filesystem::path& file,
                                                    std::span<const std::string> names) {
  std::vector<std::vector<double>> columns(names.size());
  std::vector<std::size_t> indices;
  std::size_t width = 0;
  const std::string text = readFile(file);
  eachCsvRecord(text, [&](int line, std::span<const std::string_view> fields) {
    if (width == 0) {
      CsvTable header_only;
      header_only.file = file;
      for (const std::string_view field : fields) header_only.header.push_back(trimmed(field));
      for (const std::string& name : names) indices.push_back(header_only.column(name));
      width = fields.size();
      return;
    }
    for (std::size_t i = 0; i < indices.size(); ++i) {
      double value = 0.0;
      if (indices[i] >= fields.size() || !parseNumber(fields[indices[i]], value) || !std::isfinite(value)) {
        throw InputError({.file = file, .line = line, .item = "column '" + names[i] + "'"},
                         indices[i] >= fields.size() ? "the cell is missing."
                                                     : fmt::format("'{}' is not a finite number.", fields[indices[i]]),
                         "Write a number with a decimal point, or remove the row.");
      }
      columns[i].push_back(value);
    }
  });
  if (width == 0) {
    throw InputError({.file = file}, "is empty; a header line was expected.", "Export the file again.");
  }
  return columns;
}

}  // namespace core
