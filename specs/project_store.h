#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "specs/items.h"
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
  /// Refuses a file that exists.
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
  /// The item with the same uid becomes `item`; its links stay. Links to what follows from it become suspect if its
  /// text, status or (test) decision changed.
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

  /// Returns the id of the run.
  std::string storeRun(const TestRun& run);
  /// Newest first; at most `count` (0: all). Without `evaluation` texts: they are large, see findRun.
  [[nodiscard]] std::vector<TestRun> latestRuns(int count = 0) const;
  [[nodiscard]] std::optional<TestRun> findRun(const std::string& id) const;
  /// The newest verdict of every test that has one, by shown id.
  [[nodiscard]] std::map<std::string, TestVerdict> latestVerdicts() const;

  /// Makes everything that `changes` does one transaction: one user action. If it throws, nothing has happened.
  void inOneAction(const std::function<void()>& changes);

 private:
  struct Connection;
  explicit ProjectStore(std::unique_ptr<Connection> connection);
  std::unique_ptr<Connection> connection_;
};

}  // namespace specs
