#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cepra/table.h"
#include "percollect/graph.h"
#include "specs/items.h"
#include "specs/proposals.h"
#include "specs/results.h"

namespace specs {

/// Who changes something, and when (ISO 8601, from the caller's clock: the store has none). Kept in the history.
struct Signature {
  std::string who;
  std::string when;
};

/// One line of an item's history.
struct Change {
  std::string item;  ///< shown id (after the change)
  std::string who;
  std::string when;
  std::string what;  ///< "added", "status: under review -> accepted", …
  bool operator==(const Change&) const = default;
};

/// What stands at one end of a link.
struct ItemReference {
  Kind kind = Kind::Requirement;
  std::string id;
  std::string title;
  bool operator==(const ItemReference&) const = default;
};

/// Where the graph of a project comes from.
struct GraphImport {
  std::string tree;
  std::string source;  ///< file or folder that was read
  std::string sha256;
  std::string who;
  std::string when;
};

/// Everything that people wrote down, as one value: what is listed, checked, traced and printed.
struct Specification {
  std::string project;  ///< name of the project: the file's, without its ending
  std::vector<Requirement> requirements;
  std::vector<AcceptanceTest> tests;
  std::vector<ExperimentData> experiment_data;
  std::vector<ReferenceData> reference_data;
  std::vector<Link> links;  ///< by from, then to
  cepra::Table cepra;
  std::optional<GraphImport> graph;
  std::map<std::string, TestVerdict> verdicts;  ///< the newest of each test, by shown id
  std::vector<Proposal> proposals;              ///< in the order in which they were made
};

/// What stands for a CEPRA row in a trace: "Range error ← Attenuation", phenomenon and last effect.
[[nodiscard]] std::string rowTitle(const cepra::Row& row);

enum class Access { ReadWrite, ReadOnly };

/// A project in one SQLite file (tables: schema.sql). WAL, foreign keys, a busy timeout; every change is one
/// transaction, so the file holds all of it or nothing, also if the process is killed or the disk is full.
/// One store is one connection: use it from one thread. Other processes may read and write meanwhile (dataVersion()).
/// Everything throws core::InputError with the project file as place.
///
///   auto store = ProjectStore::open("demo.fidelis");
///   for (const AcceptanceTest& test : store.all<AcceptanceTest>()) …
///   auto requirement = store.find<Requirement>("RangeError_Offset_1").value();
///   requirement.status = Status::Accepted;
///   store.update(requirement, {.who = "eve", .when = now});
class ProjectStore {
 public:
  struct Connection;  ///< connection.h: not for others

  /// Refuses a file that exists. The name of the file is the name of the project.
  static ProjectStore create(const std::filesystem::path& file);
  /// Migrates an older file (unless ReadOnly: then it is read through the migrated copy in memory). Refuses a file that
  /// is absent, no project, damaged, or written by a newer program.
  static ProjectStore open(const std::filesystem::path& file, Access access = Access::ReadWrite);

  ProjectStore(ProjectStore&&) noexcept;
  ProjectStore& operator=(ProjectStore&&) noexcept;
  ~ProjectStore();

  [[nodiscard]] const std::filesystem::path& file() const noexcept;
  /// Where the relative paths of tests begin.
  [[nodiscard]] std::filesystem::path folder() const;
  [[nodiscard]] bool readOnly() const noexcept;
  /// How long a write waits for another process before it gives up. Default: 5 s.
  void setPatience(std::chrono::milliseconds patience);
  /// Changes whenever another connection has written: time to read again.
  [[nodiscard]] int dataVersion() const;

  /// T is Requirement, AcceptanceTest, ExperimentData or ReferenceData. In natural order of the shown ids.
  template <class T>
  [[nodiscard]] std::vector<T> all() const;
  template <class T>
  [[nodiscard]] std::optional<T> find(const std::string& id) const;
  /// Returns the item as stored (with its uid). Keeps a uid that is given and free, so an undone removal comes back as
  /// itself. Refuses a shown id that is taken or malformed.
  template <class T>
  T add(const T& item, const Signature& by);
  /// The item with the same uid becomes `item`; its links stay. Nothing to change: nothing is written.
  template <class T>
  void update(const T& item, const Signature& by);
  /// Of any kind but a CEPRA row. Its links go with it; its history and verdicts stay.
  void remove(const std::string& id, const Signature& by);

  [[nodiscard]] std::optional<ItemReference> reference(const std::string& id) const;
  [[nodiscard]] std::vector<Change> history(const std::string& id) const;

  [[nodiscard]] std::vector<Link> links() const;
  [[nodiscard]] std::vector<ItemReference> originsOf(const std::string& id) const;    ///< one step back
  [[nodiscard]] std::vector<ItemReference> followersOf(const std::string& id) const;  ///< one step on
  /// Refuses ends that do not exist, kinds that may not follow each other, and cycles. Linking again sets `suspect`.
  void link(const Link& link, const Signature& by);
  void unlink(const std::string& from, const std::string& to, const Signature& by);

  /// The imported graph; empty if none was. Saving replaces it, whatever release it was of; the CEPRA table stays.
  void saveGraph(const percollect::Graph& graph, const Signature& by);
  [[nodiscard]] std::optional<percollect::Graph> graph() const;
  [[nodiscard]] std::optional<GraphImport> graphImport() const;

  /// The relevance table; without rows if none was saved. Saving takes the whole table; rows are told apart by their
  /// keys. Refuses to drop a row from which a requirement follows (cepra::merge keeps such rows as gone).
  void saveCepra(const cepra::Table& table, const Signature& by);
  [[nodiscard]] cepra::Table cepra() const;

  /// Returns those that are new, with their ids; one of the same evidence for the same row (or for a test) is known
  /// already and left as it is, whatever became of it.
  std::vector<Proposal> addProposals(const std::vector<Proposal>& proposals, const Signature& by);
  /// All, in the order in which they were made.
  [[nodiscard]] std::vector<Proposal> proposals() const;
  /// State, person, time and reason become those of `decided`; the history of its row (or requirements) says so. What
  /// acceptance does to the row is proposals/decide.h.
  void decide(const Proposal& decided, const Signature& by);

  /// Returns the id of the run.
  std::string storeRun(const TestRun& run);
  /// Newest first; at most `count` (0: all). Without `evaluation` texts: they are large, see findRun.
  [[nodiscard]] std::vector<TestRun> latestRuns(int count = 0) const;
  [[nodiscard]] std::optional<TestRun> findRun(const std::string& id) const;
  /// The newest verdict of every test that has one, by shown id.
  [[nodiscard]] std::map<std::string, TestVerdict> latestVerdicts() const;

  /// All of it, read at one moment.
  [[nodiscard]] Specification specification() const;

  /// Makes everything that `changes` does one transaction: one user action. If it throws, nothing has happened.
  void inOneAction(const std::function<void()>& changes);

 private:
  explicit ProjectStore(std::unique_ptr<Connection> connection);
  std::unique_ptr<Connection> connection_;
};

}  // namespace specs
