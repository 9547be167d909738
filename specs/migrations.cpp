#include "specs/migrations.h"

#include <SQLiteCpp/SQLiteCpp.h>

#include "specs/schema_text.h"  // generated: schema.sql as a string

namespace specs {

namespace {

constexpr std::string_view kSteps[] = {
    kSchemaVersion1,
    kSchemaVersion2,
};

}  // namespace

std::span<const std::string_view> migrationSteps() { return kSteps; }

int schemaVersion() { return static_cast<int>(std::size(kSteps)); }

void migrate(SQLite::Database& database, std::span<const std::string_view> steps) {
  const auto versionOf = [&] { return database.execAndGet("PRAGMA user_version").getInt(); };
  if (versionOf() >= static_cast<int>(steps.size())) return;
  SQLite::Transaction transaction(database, SQLite::TransactionBehavior::IMMEDIATE);
  // Read again: another process may have migrated while this one waited for the lock.
  for (int version = versionOf(); version < static_cast<int>(steps.size()); ++version) {
    database.exec(std::string(steps[static_cast<std::size_t>(version)]));
  }
  database.exec("PRAGMA user_version = " + std::to_string(steps.size()));
  transaction.commit();
}

}  // namespace specs
