// The links between the items of a project file. They hold internal ids, so a renamed item keeps them.

#include "specs/connection.h"

namespace specs {

namespace {

/// Is `from` reached from `to`? Then a link from -> to would close a circle.
bool leadsBack(const ProjectStore::Connection& connection, const std::string& from, const std::string& to) {
  return connection
      .integer(
          "WITH RECURSIVE reached (uid) AS (VALUES (?1) UNION "
          "SELECT follower FROM link JOIN reached ON link.origin = reached.uid) "
          "SELECT 1 FROM reached WHERE uid = ?2",
          {to, from})
      .has_value();
}

std::vector<ItemReference> neighbours(const ProjectStore::Connection& connection, const std::string& id,
                                      const char* here, const char* there) {
  std::vector<ItemReference> found;
  connection.each(std::string("SELECT kind, id, title FROM link JOIN item ON item.uid = link.") + there +
                      " WHERE link." + here + " = ? ORDER BY kind, id",
                  {connection.needUid(id)}, [&](const Record& record) {
                    found.push_back({kindNamed(record.text(0)), record.text(1), record.text(2)});
                  });
  return found;
}

}  // namespace

std::vector<Link> ProjectStore::links() const {
  std::vector<Link> found;
  connection_->each(
      "SELECT a.id, b.id, suspect FROM link JOIN item a ON a.uid = origin JOIN item b ON b.uid = follower "
      "ORDER BY a.id, b.id",
      {}, [&](const Record& record) {
        found.push_back({record.text(0), record.text(1), record.integer(2) != 0});
      });
  return found;
}

std::vector<ItemReference> ProjectStore::originsOf(const std::string& id) const {
  return neighbours(*connection_, id, "follower", "origin");
}

std::vector<ItemReference> ProjectStore::followersOf(const std::string& id) const {
  return neighbours(*connection_, id, "origin", "follower");
}

void ProjectStore::link(const Link& link, const Signature& by) {
  connection_->action([&] {
    const std::string from = connection_->needUid(link.from);
    const std::string to = connection_->needUid(link.to);
    const Kind from_kind = reference(link.from)->kind;
    const Kind to_kind = reference(link.to)->kind;
    if (!mayLink(from_kind, to_kind)) {
      connection_->fail(
          link.from + " -> " + link.to,
          "no link may lead from " + std::string(name(from_kind)) + " to " + std::string(name(to_kind)) + ".",
          "Links lead from a CEPRA row to a requirement, from it to an acceptance test, and from that to "
          "experiment and reference data.");
    }
    if (leadsBack(*connection_, from, to)) {
      connection_->fail(link.from + " -> " + link.to, "the link would close a circle.",
                        link.from + " follows from " + link.to + " already; remove a link of that way first.");
    }
    const auto before = connection_->integer("SELECT suspect FROM link WHERE origin = ? AND follower = ?", {from, to});
    if (before && (*before != 0) == link.suspect) return;
    connection_->run(
        "INSERT INTO link VALUES (?, ?, ?) ON CONFLICT (origin, follower) DO UPDATE SET suspect = excluded.suspect",
        {from, to, std::int64_t{link.suspect}});
    const char* what = !before ? "linked to " : link.suspect ? "link now suspect: to " : "link reviewed: to ";
    connection_->record(from, link.from, by, what + link.to);
  });
}

void ProjectStore::unlink(const std::string& from, const std::string& to, const Signature& by) {
  connection_->action([&] {
    const std::string origin = connection_->needUid(from);
    const std::string follower = connection_->needUid(to);
    if (!connection_->integer("SELECT 1 FROM link WHERE origin = ? AND follower = ?", {origin, follower})) {
      connection_->fail(from + " -> " + to, "there is no such link.", "Read the project again.");
    }
    connection_->run("DELETE FROM link WHERE origin = ? AND follower = ?", {origin, follower});
    connection_->record(origin, from, by, "link removed: to " + to);
  });
}

}  // namespace specs
