// The relevance table in a project file. Each row is an item, so that requirements can follow from it.

#include <algorithm>
#include <set>
#include <unordered_map>

#include "specs/connection.h"

namespace specs {

namespace {

using cepra::Row;

void storeRow(ProjectStore::Connection& connection, const std::string& uid, std::size_t position, const Row& row) {
  connection.run(
      "INSERT INTO item VALUES (?, ?, ?, ?, '', '', '', 'under review') "
      "ON CONFLICT (uid) DO UPDATE SET title = excluded.title",
      {uid, std::string(name(Kind::CepraRow)), row.key, rowTitle(row)});
  connection.run("INSERT OR REPLACE INTO cepra_row VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)",
                 {uid, static_cast<std::int64_t>(position), orNull(row.occurrence.value), row.occurrence.rationale,
                  row.occurrence.expert, orNull(row.impact.value), row.impact.rationale, row.impact.expert, row.suspect,
                  std::int64_t{row.gone}, row.notes});
  std::int64_t place = 0;
  const auto storeNode = [&](const std::string& id, const std::string& title, percollect::NodeKind kind) {
    connection.run("INSERT INTO cepra_node VALUES (?, ?, ?, ?, ?)",
                   {uid, place++, id, title, std::string(percollect::toString(kind))});
  };
  for (const cepra::Effect& effect : row.effects) storeNode(effect.id, effect.title, percollect::NodeKind::Effect);
  for (const cepra::Cause& cause : row.causes) storeNode(cause.id, cause.title, cause.kind);
}

std::string describe(const cepra::Score& score) {
  std::string text = score.value ? std::to_string(*score.value) : "none";
  if (!score.expert.empty()) text += " by " + score.expert;
  return text;
}

/// What the history says of a row, or "" if nothing that a person decides has changed.
std::string describeChange(const Row& before, const Row& after) {
  std::string what;
  const auto say = [&](const std::string& text) { what += (what.empty() ? "" : "; ") + text; };
  const auto compare = [&](const char* which, const cepra::Score& a, const cepra::Score& b) {
    if (describe(a) != describe(b)) say(std::string(which) + ": " + describe(a) + " -> " + describe(b));
    if (a.rationale != b.rationale) say(std::string(which) + " rationale changed");
  };
  compare("occurrence", before.occurrence, after.occurrence);
  compare("impact", before.impact, after.impact);
  if (before.suspect != after.suspect) say(after.suspect.empty() ? "reviewed" : "suspect: " + after.suspect);
  if (before.gone != after.gone) say(after.gone ? "gone from the graph" : "back in the graph");
  if (before.notes != after.notes) say("notes changed");
  return what;
}

/// A row from which a requirement follows may not vanish unnoticed.
void removeRow(ProjectStore::Connection& connection, const std::string& uid, const std::string& key) {
  const auto follower =
      connection.text("SELECT item.id FROM link JOIN item ON item.uid = follower WHERE origin = ?", {uid});
  if (follower) {
    connection.fail(key, "the row is missing from the table, but " + *follower + " follows from it.",
                    "Keep the row (marked as gone), or remove the link first.");
  }
  connection.run("DELETE FROM item WHERE uid = ?", {uid});
}

Row loadRow(const Record& record) {
  const auto number = [&](int column) -> std::optional<int> {
    if (const auto value = record.optionalInteger(column)) return static_cast<int>(*value);
    return std::nullopt;
  };
  Row row;
  row.key = record.text(1);
  row.occurrence = {.value = number(2), .rationale = record.text(3), .expert = record.text(4)};
  row.impact = {.value = number(5), .rationale = record.text(6), .expert = record.text(7)};
  row.suspect = record.text(8);
  row.gone = record.integer(9) != 0;
  row.notes = record.text(10);
  return row;
}

}  // namespace

std::string rowTitle(const Row& row) {
  if (row.effects.empty()) return row.key;
  if (row.effects.size() == 1) return row.lastEffect().title;
  return row.phenomenon().title + " ← " + row.lastEffect().title;
}

void ProjectStore::saveCepra(const cepra::Table& table, const Signature& by) {
  connection_->action([&] {
    const cepra::Table before = cepra();
    if (before == table) return;
    std::unordered_map<std::string, const Row*> old_rows;
    for (const Row& row : before.rows) old_rows[row.key] = &row;
    std::map<std::string, std::string> uids;
    connection_->each("SELECT id, uid FROM item WHERE kind = 'CEPRA row'", {},
                      [&](const Record& record) { uids[record.text(0)] = record.text(1); });
    // The paths are few and their order is the table's: written afresh. The items stay, because links hold them.
    connection_->run("DELETE FROM cepra_row");
    std::set<std::string> kept;
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
      const Row& row = table.rows[i];
      if (!kept.insert(row.key).second) connection_->fail(row.key, "two rows have this key.", "Keep one of them.");
      const auto known = uids.find(row.key);
      const std::string uid = known == uids.end() ? connection_->newUid() : known->second;
      storeRow(*connection_, uid, i, row);
      const auto old_row = old_rows.find(row.key);
      const std::string what = describeChange(old_row == old_rows.end() ? Row{} : *old_row->second, row);
      if (!what.empty()) connection_->record(uid, row.key, by, what);
    }
    for (const auto& [key, uid] : uids) {
      if (!kept.count(key)) removeRow(*connection_, uid, key);
    }
    connection_->run("INSERT OR REPLACE INTO cepra VALUES (1, ?, ?)", {table.tree, table.graph_sha256});
  });
}

cepra::Table ProjectStore::cepra() const {
  cepra::Table table;
  connection_->snapshot([&] {
    connection_->each("SELECT tree, graph_sha256 FROM cepra", {}, [&](const Record& record) {
      table.tree = record.text(0);
      table.graph_sha256 = record.text(1);
    });
    std::unordered_map<std::string, std::size_t> places;
    connection_->each(
        "SELECT uid, item.id, occurrence, occurrence_rationale, occurrence_expert, impact, impact_rationale, "
        "impact_expert, suspect, gone, notes FROM cepra_row JOIN item USING (uid) ORDER BY position",
        {}, [&](const Record& record) {
          places[record.text(0)] = table.rows.size();
          table.rows.push_back(loadRow(record));
        });
    connection_->each("SELECT row_uid, id, title, kind FROM cepra_node ORDER BY row_uid, position", {},
                      [&](const Record& record) {
                        Row& row = table.rows.at(places.at(record.text(0)));
                        const auto kind = percollect::nodeKindOf(record.text(3)).value_or(percollect::NodeKind::Effect);
                        if (kind == percollect::NodeKind::Effect) {
                          row.effects.push_back({record.text(1), record.text(2)});
                        } else {
                          row.causes.push_back({record.text(1), record.text(2), kind});
                        }
                      });
  });
  return table;
}

}  // namespace specs
