#include "specs/lists.h"

#include <algorithm>
#include <set>

#include "cepra/csv.h"
#include "core/csv.h"
#include "core/error.h"
#include "core/file.h"
#include "core/text.h"
#include "specs/fields.h"

namespace specs {

namespace {

constexpr const char* kByteOrderMark = "\xEF\xBB\xBF";

/// Name of a kind's list, and where it stands in a specification.
template <class T>
struct List;
template <>
struct List<Requirement> {
  static constexpr const char* kFile = "requirements.csv";
  static constexpr auto kItems = &Specification::requirements;
};
template <>
struct List<AcceptanceTest> {
  static constexpr const char* kFile = "acceptance_tests.csv";
  static constexpr auto kItems = &Specification::tests;
};
template <>
struct List<ExperimentData> {
  static constexpr const char* kFile = "experiment_data.csv";
  static constexpr auto kItems = &Specification::experiment_data;
};
template <>
struct List<ReferenceData> {
  static constexpr const char* kFile = "reference_data.csv";
  static constexpr auto kItems = &Specification::reference_data;
};
constexpr const char* kLinksFile = "links.csv";
constexpr const char* kCepraFile = "cepra.csv";

std::string csvText(const std::vector<std::vector<std::string>>& records) {
  std::string text = kByteOrderMark;
  for (std::vector<std::string> record : records) {
    for (std::string& cell : record) cell = guardedCell(cell);
    text += core::csvRecord(record);
  }
  return text;
}

template <class T>
void writeList(const std::vector<T>& items, const std::filesystem::path& folder) {
  std::vector<std::vector<std::string>> records(1);
  for (const Field<T>& field : fieldsOf<T>()) records[0].emplace_back(field.name);
  for (const T& item : items) {
    std::vector<std::string>& record = records.emplace_back();
    for (const Field<T>& field : fieldsOf<T>()) record.push_back(field.get(item));
  }
  core::writeFile(folder / List<T>::kFile, csvText(records));
}

void writeLinks(const std::vector<Link>& links, const std::filesystem::path& folder) {
  std::vector<std::vector<std::string>> records = {{"from", "to", "suspect"}};
  for (const Link& link : links) records.push_back({link.from, link.to, link.suspect ? "yes" : ""});
  core::writeFile(folder / kLinksFile, csvText(records));
}

[[noreturn]] void failAt(const core::CsvTable& table, std::size_t row, std::size_t column, const std::string& problem,
                         const std::string& remedy) {
  throw core::InputError({.file = table.file,
                          .line = table.lines[row],
                          .item = "row " + std::to_string(row + 2) + ", column " + table.header[column]},
                         problem, remedy);
}

/// For every column of the file the field that it fills. Throws if one is unknown.
template <class T>
std::vector<const Field<T>*> fieldsOfColumns(const core::CsvTable& table) {
  std::vector<std::string> known;
  for (const Field<T>& field : fieldsOf<T>()) known.emplace_back(field.name);
  std::vector<const Field<T>*> fields;
  for (const std::string& column : table.header) {
    const auto found = std::find(known.begin(), known.end(), core::trimmed(column));
    if (found == known.end()) {
      const std::string nearest = core::nearestName(column, known);
      throw core::InputError(
          {.file = table.file, .line = 1, .item = "column " + column}, "this column is not known.",
          nearest.empty() ? "Known columns: " + core::join(known) + "." : "Did you mean '" + nearest + "'?");
    }
    fields.push_back(&fieldsOf<T>()[static_cast<std::size_t>(found - known.begin())]);
  }
  return fields;
}

/// The item that a row of the file is about, as it was before; a new one if there is none.
template <class T>
T itemBefore(const std::vector<T>& items, const std::string& uid, const std::string& id) {
  const auto by = [&](std::string Item::*member, const std::string& value) {
    return std::find_if(items.begin(), items.end(), [&](const T& item) { return item.*member == value; });
  };
  auto found = uid.empty() ? items.end() : by(&Item::uid, uid);
  if (found == items.end()) found = by(&Item::id, id);
  return found == items.end() ? T() : *found;
}

template <class T>
void readList(const std::filesystem::path& folder, ReadLists& lists) {
  const std::filesystem::path file = folder / List<T>::kFile;
  if (!std::filesystem::exists(file)) return;
  lists.files.emplace_back(List<T>::kFile);
  const core::CsvTable table = core::readCsvTable(file);
  const auto fields = fieldsOfColumns<T>(table);
  const std::size_t id_column = table.column("id");
  const auto uid_column = table.findColumn("uid");
  std::vector<T>& items = lists.specification.*List<T>::kItems;
  std::vector<T> read;
  std::set<std::string> seen;
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    const std::string id = unguardedCell(table.rows[row][id_column]);
    const std::string uid = uid_column ? table.rows[row][*uid_column] : "";
    T item = itemBefore(items, uid, id);
    const std::string known_uid = item.uid;
    for (std::size_t column = 0; column < fields.size(); ++column) {
      const std::string problem = fields[column]->set(item, unguardedCell(table.rows[row][column]));
      if (!problem.empty()) {
        failAt(table, row, column, problem + ".",
               "Status is one of under review, accepted, rejected; level of general, object-model, detection-model; "
               "frames a whole number; options name=value.");
      }
    }
    if (!known_uid.empty()) item.uid = known_uid;
    if (!seen.insert(item.id).second) failAt(table, row, id_column, "'" + id + "' is listed twice.", "Keep one.");
    read.push_back(std::move(item));
  }
  for (const T& item : items) {
    const bool kept = std::any_of(read.begin(), read.end(), [&](const T& other) { return other.uid == item.uid; });
    if (!kept) lists.missing.push_back(item.id);
  }
  items = std::move(read);
}

void readLinks(const std::filesystem::path& folder, ReadLists& lists) {
  const std::filesystem::path file = folder / kLinksFile;
  if (!std::filesystem::exists(file)) return;
  lists.files.emplace_back(kLinksFile);
  const core::CsvTable table = core::readCsvTable(file);
  const std::size_t from = table.column("from");
  const std::size_t to = table.column("to");
  const auto suspect = table.findColumn("suspect");
  std::vector<Link> read;
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    Link link{unguardedCell(table.rows[row][from]), unguardedCell(table.rows[row][to])};
    if (suspect) {
      const std::string word = core::lowerCase(core::trimmed(table.rows[row][*suspect]));
      if (!word.empty() && word != "yes" && word != "no") {
        failAt(table, row, *suspect, "'" + word + "' is neither yes nor no.", "Write yes, or leave it empty.");
      }
      link.suspect = word == "yes";
    }
    read.push_back(link);
  }
  for (const Link& link : lists.specification.links) {
    const bool kept = std::any_of(read.begin(), read.end(),
                                  [&](const Link& other) { return other.from == link.from && other.to == link.to; });
    if (!kept) lists.missing.push_back(link.from + " -> " + link.to);
  }
  lists.specification.links = std::move(read);
}

template <class T>
void apply(ProjectStore& store, const std::vector<T>& items, bool remove_missing, const Signature& by,
           ListChanges& changes) {
  std::map<std::string, T> before;
  for (T& item : store.all<T>()) before.emplace(item.uid, std::move(item));
  std::set<std::string> kept;
  for (const T& item : items) kept.insert(item.uid);
  for (const auto& [uid, item] : before) {  // first: a removed item may leave its id to another
    if (remove_missing && !kept.count(uid)) {
      store.remove(item.id, by);
      ++changes.removed;
    }
  }
  for (const T& item : items) {
    const auto known = before.find(item.uid);
    if (known == before.end()) {
      store.add(item, by);
      ++changes.added;
    } else if (known->second != item) {
      store.update(item, by);
      ++changes.changed;
    }
  }
}

void applyLinks(ProjectStore& store, const std::vector<Link>& links, bool remove_missing, const Signature& by,
                ListChanges& changes) {
  std::map<std::pair<std::string, std::string>, bool> before;
  for (const Link& link : store.links()) before[{link.from, link.to}] = link.suspect;
  for (const Link& link : links) {
    const auto known = before.find({link.from, link.to});
    if (known == before.end() || known->second != link.suspect) {
      store.link(link, by);
      ++(known == before.end() ? changes.added : changes.changed);
    }
    if (known != before.end()) before.erase(known);
  }
  if (!remove_missing) return;
  for (const auto& [ends, suspect] : before) {
    store.unlink(ends.first, ends.second, by);
    ++changes.removed;
  }
}

}  // namespace

std::string guardedCell(const std::string& text) {
  constexpr std::string_view kFormula = "=+-@'\t";
  return !text.empty() && kFormula.find(text[0]) != std::string_view::npos ? "'" + text : text;
}

std::string unguardedCell(const std::string& cell) {
  // Only an apostrophe that guards something: one that a person wrote before a letter stays.
  if (cell.size() > 1 && cell[0] == '\'' && guardedCell(cell.substr(1)) == cell) return cell.substr(1);
  return cell;
}

void writeLists(const Specification& specification, const std::filesystem::path& folder) {
  std::error_code failed;
  std::filesystem::create_directories(folder, failed);
  if (failed) {
    throw core::InputError({.file = folder}, "the folder cannot be made: " + failed.message() + ".",
                           "Choose another folder, or ask for the right to write there.");
  }
  writeList(specification.requirements, folder);
  writeList(specification.tests, folder);
  writeList(specification.experiment_data, folder);
  writeList(specification.reference_data, folder);
  writeLinks(specification.links, folder);
  cepra::exportCsv(specification.cepra, folder / kCepraFile);
}

ReadLists readLists(const std::filesystem::path& folder, const Specification& before) {
  ReadLists lists{.specification = before};
  readList<Requirement>(folder, lists);
  readList<AcceptanceTest>(folder, lists);
  readList<ExperimentData>(folder, lists);
  readList<ReferenceData>(folder, lists);
  readLinks(folder, lists);
  if (std::filesystem::exists(folder / kCepraFile)) {
    lists.files.emplace_back(kCepraFile);
    if (before.cepra.rows.empty()) {
      throw core::InputError({.file = folder / kCepraFile}, "the project has no relevance table that this could fill.",
                             "Import the graph first: fidelis import GRAPH --project FILE.");
    }
    lists.specification.cepra = cepra::importCsv(before.cepra, folder / kCepraFile).table;
  }
  if (lists.files.empty()) {
    throw core::InputError({.file = folder}, "the folder holds none of the lists.",
                           "Expected are requirements.csv, acceptance_tests.csv, experiment_data.csv, "
                           "reference_data.csv, links.csv or cepra.csv, as 'fidelis spec export --csv' writes them.");
  }
  return lists;
}

ListChanges applyLists(ProjectStore& store, const ReadLists& lists, bool remove_missing, const Signature& by) {
  ListChanges changes;
  store.inOneAction([&] {
    const Specification& now = lists.specification;
    apply(store, now.requirements, remove_missing, by, changes);
    apply(store, now.tests, remove_missing, by, changes);
    apply(store, now.experiment_data, remove_missing, by, changes);
    apply(store, now.reference_data, remove_missing, by, changes);
    const cepra::Table before = store.cepra();
    for (const cepra::Row& row : now.cepra.rows) {
      const cepra::Row* old_row = before.find(row.key);
      changes.changed += old_row && *old_row != row;
    }
    store.saveCepra(now.cepra, by);
    applyLinks(store, now.links, remove_missing, by, changes);
  });
  return changes;
}

}  // namespace specs
