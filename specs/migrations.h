#pragma once

#include <span>
#include <string_view>

namespace SQLite {
class Database;
}

namespace specs {

/// How the tables became what they are: step i leads from version i to version i + 1. A step never changes once it has
/// been released; to change the tables, append one (and keep a file of the version before in tests/specs).
[[nodiscard]] std::span<const std::string_view> migrationSteps();

/// The version that this program writes: the number of steps.
[[nodiscard]] int schemaVersion();

/// Takes a database from its `user_version` through all further steps, all or nothing. The caller has made sure that it
/// is not newer.
void migrate(SQLite::Database& database, std::span<const std::string_view> steps);

}  // namespace specs
