#include "specs/connection.h"

#include <SQLiteCpp/Backup.h>
#include <SQLiteCpp/SQLiteCpp.h>
#include <fstream>
#include <sqlite3.h>
#include <unistd.h>
#include <unordered_map>

#include "core/error.h"
#include "core/file.h"
#include "core/text.h"
#include "specs/migrations.h"

namespace specs {

namespace {

constexpr int kApplicationId = 0x46444c53;  // "FDLS"
constexpr int kPatience_ms = 5000;
constexpr std::string_view kSqliteHeader = "SQLite format 3";

void bindAll(SQLite::Statement& statement, const std::vector<Value>& values) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    const int place = static_cast<int>(i) + 1;
    std::visit(
        [&](const auto& value) {
          if constexpr (std::is_same_v<std::decay_t<decltype(value)>, std::nullptr_t>) {
            statement.bind(place);
          } else {
            statement.bind(place, value);
          }
        },
        values[i]);
  }
}

/// A file name as SQLite's URI, for a file in a folder where nothing may be written.
std::string immutableUri(const std::filesystem::path& file) {
  std::string uri = "file:";
  for (const char c : std::filesystem::absolute(file).string()) {
    if (c == '%' || c == '?' || c == '#') {
      constexpr char kHex[] = "0123456789abcdef";
      uri += {'%', kHex[(c >> 4) & 15], kHex[c & 15]};
    } else {
      uri += c;
    }
  }
  return uri + "?immutable=1";
}

/// Did somebody who was killed leave changes in the log beside the file?
bool hasLog(const std::filesystem::path& file) {
  std::error_code absent;
  const auto size = std::filesystem::file_size(file.string() + "-wal", absent);
  return !absent && size > 0;
}

}  // namespace

std::string Record::text(int column) const { return statement_.getColumn(column).getString(); }
std::int64_t Record::integer(int column) const { return statement_.getColumn(column).getInt64(); }
std::optional<std::int64_t> Record::optionalInteger(int column) const {
  if (statement_.isColumnNull(column)) return std::nullopt;
  return integer(column);
}
std::optional<double> Record::optionalNumber(int column) const {
  if (statement_.isColumnNull(column)) return std::nullopt;
  return statement_.getColumn(column).getDouble();
}

/// The library's types, kept out of the header.
struct ProjectStore::Connection::Database {
  SQLite::Database sqlite;
  std::unordered_map<std::string, SQLite::Statement> prepared;  ///< of run()
};

ProjectStore::Connection::Connection(std::filesystem::path project_file, Opening opening)
    : file(std::move(project_file)), read_only(opening == Opening::ReadOnly) {
  const bool exists = std::filesystem::exists(file);
  if (opening == Opening::Create) {
    if (exists) fail("", "the file is there already; a new project would replace it.", "Choose another name.");
  } else {
    if (!exists) fail("", "there is no such project file.", "Create it with 'fidelis import GRAPH --project FILE'.");
    std::ifstream stream(file, std::ios::binary);
    std::string begin(kSqliteHeader.size(), '\0');
    stream.read(begin.data(), static_cast<std::streamsize>(begin.size()));
    if (!stream || begin != kSqliteHeader) {
      fail("", "this is no project file (it is not in SQLite's format).", "Give the file made by 'fidelis import'.");
    }
  }
  try {
    guarded([&] { open(opening); });
  } catch (...) {
    database_.reset();
    if (opening == Opening::Create) {
      // Leave nothing half: what was begun here would be taken for a damaged project later.
      for (const char* beside : {"", "-wal", "-shm"}) {
        std::error_code ignored;
        std::filesystem::remove(file.string() + beside, ignored);
      }
    }
    throw;
  }
}

ProjectStore::Connection::~Connection() = default;

void ProjectStore::Connection::open(Opening opening) {
  if (opening == Opening::ReadOnly) return openReadOnly();
  const int flags = SQLite::OPEN_READWRITE | (opening == Opening::Create ? SQLite::OPEN_CREATE : 0);
  if (opening == Opening::ReadWrite && ::access(file.c_str(), W_OK) != 0) {
    fail("", "the project file is write-protected.", "Allow writing, or work on a copy.");
  }
  database_ = std::make_unique<Database>(Database{SQLite::Database(file.string(), flags, kPatience_ms), {}});
  SQLite::Database& sqlite = database_->sqlite;
  if (opening == Opening::ReadWrite) checkContent();
  // WAL keeps readers and a writer out of each other's way; FULL survives a power cut, not only a killed process.
  sqlite.exec("PRAGMA journal_mode = WAL; PRAGMA synchronous = FULL; PRAGMA trusted_schema = OFF");
  if (opening == Opening::Create) {
    SQLite::Transaction transaction(sqlite, SQLite::TransactionBehavior::IMMEDIATE);
    sqlite.exec("PRAGMA application_id = " + std::to_string(kApplicationId));
    for (const std::string_view step : migrationSteps()) sqlite.exec(std::string(step));
    sqlite.exec("PRAGMA user_version = " + std::to_string(schemaVersion()));
    SQLite::Statement project(sqlite, "INSERT INTO project VALUES (1, ?, 1)");
    project.bind(1, core::sha256("fidelis project " + file.stem().string()));
    project.exec();
    transaction.commit();
  } else {
    migrate(sqlite, migrationSteps());
  }
  sqlite.exec("PRAGMA foreign_keys = ON");
}

void ProjectStore::Connection::openReadOnly() {
  // A database in WAL mode has files beside it even for reading, and only who may write can tidy them up. Where writing
  // is forbidden nobody else writes either, so that the file may be taken as immutable, unless its log was left behind.
  const bool may_write =
      ::access(file.c_str(), W_OK) == 0 && ::access(std::filesystem::absolute(file).parent_path().c_str(), W_OK) == 0;
  database_ = std::make_unique<Database>(
      Database{may_write ? SQLite::Database(file.string(), SQLite::OPEN_READWRITE, kPatience_ms)
                         : SQLite::Database(hasLog(file) ? file.string() : immutableUri(file),
                                            SQLite::OPEN_READONLY | SQLite::OPEN_URI, kPatience_ms),
               {}});
  database_->sqlite.exec("PRAGMA query_only = ON");
  checkContent();
  if (database_->sqlite.execAndGet("PRAGMA user_version").getInt() < schemaVersion()) {
    // The file itself must not change, so a copy in memory is migrated.
    auto copy = std::make_unique<Database>(
        Database{SQLite::Database(":memory:", SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE), {}});
    SQLite::Backup(copy->sqlite, database_->sqlite).executeStep(-1);  // gone before the file is closed
    migrate(copy->sqlite, migrationSteps());
    database_ = std::move(copy);
  }
}

void ProjectStore::Connection::checkContent() const {
  SQLite::Database& sqlite = database_->sqlite;
  if (sqlite.execAndGet("PRAGMA application_id").getInt() != kApplicationId) {
    fail("", "this is an SQLite file, but no Fidelis project.", "Give the file made by 'fidelis import'.");
  }
  const int version = sqlite.execAndGet("PRAGMA user_version").getInt();
  if (version > schemaVersion()) {
    fail("",
         "the project was written by a newer program (version " + std::to_string(version) +
             " of the tables; this program knows up to " + std::to_string(schemaVersion()) + ").",
         "Use the newer program. The file was not changed.");
  }
  const std::string verdict = sqlite.execAndGet("PRAGMA quick_check(1)").getString();
  if (verdict != "ok") {
    fail("", "the project file is damaged: " + verdict + ".",
         "Restore a copy, or save what can be saved with \"sqlite3 FILE .recover\".");
  }
}

void ProjectStore::Connection::guarded(const std::function<void()>& work) const {
  try {
    work();
  } catch (const SQLite::Exception& error) {
    const std::string detail = std::string(" (SQLite: ") + error.what() + ").";
    switch (error.getErrorCode() & 0xff) {
      case SQLITE_BUSY:
      case SQLITE_LOCKED:
        fail("", "another program is writing to the project and did not finish in time" + detail,
             "Wait until it is done, then try again. Nothing was changed.");
      case SQLITE_FULL:
      case SQLITE_IOERR:
        fail("", "the project file could not be written or read: disk full or failing" + detail,
             "Make room, then try again. The file holds everything up to the last completed action.");
      case SQLITE_CORRUPT:
      case SQLITE_NOTADB:
        fail("", "the project file is damaged" + detail,
             "Restore a copy, or save what can be saved with \"sqlite3 FILE .recover\".");
      case SQLITE_READONLY:
      case SQLITE_PERM:
      case SQLITE_CANTOPEN:
        fail("", "the project file or its folder does not allow this" + detail,
             "Check that the folder exists and that you may write there, or work on a copy.");
      default:
        throw;  // a fault of ours
    }
  }
}

void ProjectStore::Connection::fail(const std::string& item, const std::string& problem,
                                    const std::string& remedy) const {
  throw core::InputError({.file = file, .item = item}, problem, remedy);
}

void ProjectStore::Connection::run(const std::string& sql, const std::vector<Value>& values) {
  guarded([&] {
    auto found = database_->prepared.find(sql);
    if (found == database_->prepared.end()) {
      found = database_->prepared.emplace(sql, SQLite::Statement(database_->sqlite, sql)).first;
    }
    SQLite::Statement& statement = found->second;
    statement.reset();
    bindAll(statement, values);
    statement.exec();
    statement.reset();
  });
}

void ProjectStore::Connection::each(const std::string& sql, const std::vector<Value>& values,
                                    const std::function<void(const Record&)>& read) const {
  guarded([&] {
    SQLite::Statement statement(database_->sqlite, sql);
    bindAll(statement, values);
    const Record current(statement);
    while (statement.executeStep()) read(current);
  });
}

std::optional<std::string> ProjectStore::Connection::text(const std::string& sql,
                                                          const std::vector<Value>& values) const {
  std::optional<std::string> result;
  each(sql, values, [&](const Record& found) { result = found.text(0); });
  return result;
}

std::optional<std::int64_t> ProjectStore::Connection::integer(const std::string& sql,
                                                              const std::vector<Value>& values) const {
  std::optional<std::int64_t> result;
  each(sql, values, [&](const Record& found) { result = found.integer(0); });
  return result;
}

std::int64_t ProjectStore::Connection::lastRowId() const { return database_->sqlite.getLastInsertRowid(); }

void ProjectStore::Connection::action(const std::function<void()>& changes) {
  if (read_only) {
    fail("", "the project is open for reading only.", "Open it for writing, or work on a copy.");
  }
  guarded([&] {
    // The outermost action takes the write lock at once: waiting for it later could end in a deadlock.
    const bool outermost = depth_ == 0;
    const std::string name = "action" + std::to_string(depth_);
    database_->sqlite.exec(outermost ? "BEGIN IMMEDIATE" : "SAVEPOINT " + name);
    ++depth_;
    try {
      changes();
      database_->sqlite.exec(outermost ? "COMMIT" : "RELEASE " + name);
      --depth_;
    } catch (...) {
      --depth_;
      // After a full disk SQLite may have rolled back by itself; then there is nothing left to undo.
      database_->sqlite.tryExec(outermost ? "ROLLBACK" : "ROLLBACK TO " + name + "; RELEASE " + name);
      throw;
    }
  });
}

void ProjectStore::Connection::snapshot(const std::function<void()>& reads) const {
  if (depth_ > 0) return reads();
  guarded([&] {
    SQLite::Transaction transaction(database_->sqlite);  // ends with the scope; nothing was written
    ++depth_;
    try {
      reads();
    } catch (...) {
      --depth_;
      throw;
    }
    --depth_;
  });
}

void ProjectStore::Connection::setPatience(std::chrono::milliseconds patience) {
  guarded([&] { database_->sqlite.setBusyTimeout(static_cast<int>(patience.count())); });
}

std::string ProjectStore::Connection::newUid() {
  run("UPDATE project SET next_number = next_number + 1", {});
  const std::string hash = core::sha256(text("SELECT uid || ' ' || next_number FROM project", {}).value());
  return hash.substr(0, 8) + "-" + hash.substr(8, 4) + "-8" + hash.substr(13, 3) + "-a" + hash.substr(17, 3) + "-" +
         hash.substr(20, 12);
}

void ProjectStore::Connection::record(const std::string& uid, const std::string& id, const Signature& by,
                                      const std::string& what) {
  run("INSERT INTO change (uid, id, who, changed, what) VALUES (?, ?, ?, ?, ?)", {uid, id, by.who, by.when, what});
}

std::optional<std::string> ProjectStore::Connection::uidOf(const std::string& id) const {
  return text("SELECT uid FROM item WHERE id = ?", {id});
}

std::string ProjectStore::Connection::needUid(const std::string& id) const {
  if (const auto uid = uidOf(id)) return *uid;
  std::vector<std::string> ids;
  each("SELECT id FROM item ORDER BY id", {}, [&](const Record& found) { ids.push_back(found.text(0)); });
  const std::string nearest = core::nearestName(id, ids);
  fail(id, "there is no such item in the project.",
       nearest.empty() ? "'fidelis spec export' lists what there is." : "Did you mean '" + nearest + "'?");
}

}  // namespace specs
