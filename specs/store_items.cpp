// Requirements, acceptance tests and data requirements of a project file. Their tables follow the field lists of
// fields.h: the first fields stand in `item`, the others in the table of the kind.

#include <algorithm>

#include "core/error.h"
#include "specs/connection.h"
#include "specs/fields.h"
#include "specs/shown_id.h"

namespace specs {

namespace {

template <class T>
constexpr std::string_view kTable;
template <>
constexpr std::string_view kTable<Requirement> = "requirement";
template <>
constexpr std::string_view kTable<AcceptanceTest> = "acceptance_test";
template <>
constexpr std::string_view kTable<ExperimentData> = "experiment_data";
template <>
constexpr std::string_view kTable<ReferenceData> = "reference_data";

template <class T>
std::span<const Field<T>> commonFields() {
  return fieldsOf<T>().first(kCommonFields);
}
template <class T>
std::span<const Field<T>> ownFields() {
  return fieldsOf<T>().subspan(kCommonFields);
}

/// "uid, id, title" with `pattern` for each: "%" stands for the name.
template <class T>
std::string columns(std::span<const Field<T>> fields, const std::string& pattern = "%") {
  std::string list;
  for (const Field<T>& field : fields) {
    std::string one = pattern;
    if (const auto at = one.find('%'); at != std::string::npos) one.replace(at, 1, field.name);
    list += (list.empty() ? "" : ", ") + one;
  }
  return list;
}

template <class T>
std::vector<Value> valuesOf(std::span<const Field<T>> fields, const T& item) {
  std::vector<Value> values;
  for (const Field<T>& field : fields) values.emplace_back(field.get(item));
  return values;
}

/// The items that fulfil `condition` (SQL, with one value if it has a "?").
template <class T>
std::vector<T> select(const ProjectStore::Connection& connection, const std::string& condition,
                      const std::vector<Value>& values) {
  std::vector<T> items;
  const std::string sql = "SELECT " + columns<T>(commonFields<T>(), "item.%") + ", " +
                          columns<T>(ownFields<T>(), "own.%") + " FROM item JOIN " + std::string(kTable<T>) +
                          " AS own USING (uid) " + condition;
  connection.each(sql, values, [&](const Record& record) {
    T item;
    int column = 0;
    for (const Field<T>& field : fieldsOf<T>()) {
      const std::string problem = field.set(item, record.text(column++));
      if (!problem.empty()) connection.fail(item.id, problem + ".", "Restore a copy: somebody else wrote to the file.");
    }
    items.push_back(std::move(item));
  });
  std::sort(items.begin(), items.end(), [](const T& a, const T& b) { return naturallyLess(a.id, b.id); });
  return items;
}

void checkId(const ProjectStore::Connection& connection, const Item& item) {
  if (!isShownId(item.id)) {
    connection.fail(item.id, "this is no valid id.",
                    "Use <Phenomenon>_<Causes>_<No.> with letters and digits: "
                    "FalseNegativeDetection_AttenuationByAerosols_1.");
  }
  const auto holder = connection.uidOf(item.id);
  if (holder && *holder != item.uid) {
    connection.fail(item.id, "the id is taken already.", "Use the next number.");
  }
}

template <class T>
void insert(ProjectStore::Connection& connection, const T& item) {
  std::vector<Value> common = valuesOf<T>(commonFields<T>(), item);
  common.emplace_back(std::string(name(kindOf<T>())));
  connection.run("INSERT INTO item (" + columns<T>(commonFields<T>()) + ", kind) VALUES (" +
                     columns<T>(commonFields<T>(), "?") + ", ?)",
                 common);
  std::vector<Value> own = valuesOf<T>(ownFields<T>(), item);
  own.emplace_back(item.uid);
  connection.run("INSERT INTO " + std::string(kTable<T>) + " (" + columns<T>(ownFields<T>()) + ", uid) VALUES (" +
                     columns<T>(ownFields<T>(), "?") + ", ?)",
                 own);
}

/// "status: under review -> accepted; text changed", or "" if nothing differs.
template <class T>
std::string describeChange(const T& before, const T& after) {
  constexpr std::size_t kLongest = 80;  // longer texts are only said to have changed
  std::string what;
  for (const Field<T>& field : fieldsOf<T>()) {
    const std::string old_text = field.get(before);
    const std::string new_text = field.get(after);
    if (old_text == new_text) continue;
    if (!what.empty()) what += "; ";
    what += std::string(field.name);
    if (old_text.size() + new_text.size() > kLongest || field.name == "text" || field.name == "rationale") {
      what += " changed";
    } else {
      what += ": " + (old_text.empty() ? "(empty)" : old_text) + " -> " + (new_text.empty() ? "(empty)" : new_text);
    }
  }
  return what;
}

}  // namespace

template <class T>
std::vector<T> ProjectStore::all() const {
  return select<T>(*connection_, "", {});
}

template <class T>
std::optional<T> ProjectStore::find(const std::string& id) const {
  std::vector<T> found = select<T>(*connection_, "WHERE item.id = ?", {id});
  if (found.empty()) return std::nullopt;
  return std::move(found.front());
}

template <class T>
T ProjectStore::add(const T& item, const Signature& by) {
  T stored = item;
  connection_->action([&] {
    checkId(*connection_, item);
    if (stored.uid.empty() || connection_->text("SELECT uid FROM item WHERE uid = ?", {stored.uid})) {
      stored.uid = connection_->newUid();
    }
    insert(*connection_, stored);
    connection_->record(stored.uid, stored.id, by, "added");
  });
  return stored;
}

template <class T>
void ProjectStore::update(const T& item, const Signature& by) {
  connection_->action([&] {
    const std::vector<T> before = select<T>(*connection_, "WHERE item.uid = ?", {item.uid});
    if (before.empty()) {
      connection_->fail(item.id, "there is no such " + std::string(name(kindOf<T>())) + " any more.",
                        "Somebody may have removed it; read the project again.");
    }
    checkId(*connection_, item);
    const std::string what = describeChange(before.front(), item);
    if (what.empty()) return;
    std::vector<Value> common = valuesOf<T>(commonFields<T>(), item);
    common.emplace_back(item.uid);
    connection_->run("UPDATE item SET " + columns<T>(commonFields<T>(), "% = ?") + " WHERE uid = ?", common);
    std::vector<Value> own = valuesOf<T>(ownFields<T>(), item);
    own.emplace_back(item.uid);
    connection_->run(
        "UPDATE " + std::string(kTable<T>) + " SET " + columns<T>(ownFields<T>(), "% = ?") + " WHERE uid = ?", own);
    connection_->record(item.uid, item.id, by, what);
  });
}

void ProjectStore::remove(const std::string& id, const Signature& by) {
  connection_->action([&] {
    const std::string uid = connection_->needUid(id);
    if (connection_->text("SELECT kind FROM item WHERE uid = ?", {uid}) == name(Kind::CepraRow)) {
      connection_->fail(id, "a CEPRA row cannot be removed by itself.", "Save a table without it.");
    }
    connection_->run("DELETE FROM item WHERE uid = ?", {uid});
    connection_->record(uid, id, by, "removed");
  });
}

std::optional<ItemReference> ProjectStore::reference(const std::string& id) const {
  std::optional<ItemReference> found;
  connection_->each("SELECT kind, title FROM item WHERE id = ?", {id}, [&](const Record& record) {
    found = ItemReference{.kind = kindNamed(record.text(0)), .id = id, .title = record.text(1)};
  });
  return found;
}

std::vector<Change> ProjectStore::history(const std::string& id) const {
  std::vector<Change> changes;
  // Also of an item that is no more: then by the id that it had.
  connection_->each(
      "SELECT id, who, changed, what FROM change WHERE uid IN "
      "(SELECT uid FROM item WHERE id = ?1 UNION SELECT uid FROM change WHERE id = ?1) ORDER BY number",
      {id}, [&](const Record& record) {
        changes.push_back({record.text(0), record.text(1), record.text(2), record.text(3)});
      });
  return changes;
}

#define FIDELIS_STORES(T)                                                       \
  template std::vector<T> ProjectStore::all<T>() const;                         \
  template std::optional<T> ProjectStore::find<T>(const std::string& id) const; \
  template T ProjectStore::add<T>(const T& item, const Signature& by);          \
  template void ProjectStore::update<T>(const T& item, const Signature& by);
FIDELIS_STORES(Requirement)
FIDELIS_STORES(AcceptanceTest)
FIDELIS_STORES(ExperimentData)
FIDELIS_STORES(ReferenceData)
#undef FIDELIS_STORES

}  // namespace specs
