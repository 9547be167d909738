#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "specs/project_store.h"

namespace SQLite {
class Statement;
}

namespace specs {

/// One column of the current record.
class Record {
 public:
  explicit Record(SQLite::Statement& statement) : statement_(statement) {}
  [[nodiscard]] std::string text(int column) const;
  [[nodiscard]] std::int64_t integer(int column) const;
  [[nodiscard]] std::optional<std::int64_t> optionalInteger(int column) const;
  [[nodiscard]] std::optional<double> optionalNumber(int column) const;

 private:
  SQLite::Statement& statement_;
};

/// What is bound to a `?`.
using Value = std::variant<std::nullptr_t, std::int64_t, double, std::string>;
[[nodiscard]] inline Value orNull(const std::optional<int>& value) {
  return value ? Value(static_cast<std::int64_t>(*value)) : Value(nullptr);
}
[[nodiscard]] inline Value orNull(const std::optional<double>& value) { return value ? Value(*value) : Value(nullptr); }

/// How a project file is opened.
enum class Opening { Create, ReadWrite, ReadOnly };

/// What the source files of ProjectStore share: statements, actions, uids and the history. The only place that talks to
/// SQLite; every error comes out as InputError with the project file as its place. Not for others.
struct ProjectStore::Connection {
  Connection(std::filesystem::path project_file, Opening opening);
  ~Connection();

  /// Prepares, binds and runs a statement that returns nothing.
  void run(const std::string& sql, const std::vector<Value>& values = {});
  /// Calls `read` for every record of the answer.
  void each(const std::string& sql, const std::vector<Value>& values,
            const std::function<void(const Record&)>& read) const;
  [[nodiscard]] std::optional<std::string> text(const std::string& sql, const std::vector<Value>& values) const;
  [[nodiscard]] std::optional<std::int64_t> integer(const std::string& sql, const std::vector<Value>& values) const;
  [[nodiscard]] std::int64_t lastRowId() const;

  /// One transaction, or part of the one that is under way; nothing has happened if `changes` throws.
  void action(const std::function<void()>& changes);
  /// Everything that `reads` reads is of the same moment.
  void snapshot(const std::function<void()>& reads) const;
  void setPatience(std::chrono::milliseconds patience);

  /// The next internal id: looks like a UUID (version 8) and follows from the project's own and a counter, so that the
  /// same actions give the same ids.
  [[nodiscard]] std::string newUid();
  void record(const std::string& uid, const std::string& id, const Signature& by, const std::string& what);
  [[nodiscard]] std::optional<std::string> uidOf(const std::string& id) const;
  /// Throws InputError that names the nearest id.
  [[nodiscard]] std::string needUid(const std::string& id) const;

  [[noreturn]] void fail(const std::string& item, const std::string& problem, const std::string& remedy) const;

  std::filesystem::path file;
  bool read_only = false;

 private:
  struct Database;
  void open(Opening opening);
  void openReadOnly();
  void checkContent() const;
  void guarded(const std::function<void()>& work) const;
  std::unique_ptr<Database> database_;
  mutable int depth_ = 0;  ///< of actions and snapshots within each other
};

}  // namespace specs
