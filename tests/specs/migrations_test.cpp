#include "specs/migrations.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <gmock/gmock.h>

#include "core/file.h"
#include "specs/project_store.h"
#include "tests/specs/small_project.h"
#include "tests/support/paths.h"

namespace specs {
namespace {

constexpr std::string_view kSteps[] = {
    "CREATE TABLE a (x); INSERT INTO a VALUES (1);",
    "ALTER TABLE a ADD COLUMN y; UPDATE a SET y = x + 1;",
    "CREATE TABLE b (z); INSERT INTO b SELECT y FROM a;",
};

SQLite::Database emptyDatabase() { return {":memory:", SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE}; }

TEST(Migrations, TakeEveryStepOnce) {
  SQLite::Database database = emptyDatabase();
  migrate(database, std::span(kSteps).first(1));
  EXPECT_EQ(database.execAndGet("PRAGMA user_version").getInt(), 1);
  migrate(database, kSteps);
  migrate(database, kSteps);
  EXPECT_EQ(database.execAndGet("PRAGMA user_version").getInt(), 3);
  EXPECT_EQ(database.execAndGet("SELECT z FROM b").getInt(), 2);
}

TEST(Migrations, AFailingStepChangesNothing) {
  constexpr std::string_view kBroken[] = {kSteps[0], kSteps[1], "INSERT INTO nowhere VALUES (1)"};
  SQLite::Database database = emptyDatabase();
  migrate(database, std::span(kBroken).first(1));
  EXPECT_THROW(migrate(database, kBroken), SQLite::Exception);
  EXPECT_EQ(database.execAndGet("PRAGMA user_version").getInt(), 1);
  EXPECT_THROW(database.execAndGet("SELECT y FROM a"), SQLite::Exception);
}

// version-1.sql is a dump of a file that the first version wrote. Whoever appends a step keeps such a dump of the
// version before it, and lists it here.
class AnOldFile : public ::testing::TestWithParam<const char*> {};

TEST_P(AnOldFile, OpensAndHoldsWhatItHeld) {
  test_support::TemporaryFolder folder;
  const auto file = folder / "demo.fidelis";
  {
    SQLite::Database database(file.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
    database.exec(core::readFile(test_support::sourceFolder() / "tests/specs" / GetParam()));
  }
  test_support::TemporaryFolder other;
  ProjectStore fresh = ProjectStore::create(other / "demo.fidelis");
  test_specs::fill(fresh);
  for (const Access access : {Access::ReadOnly, Access::ReadWrite}) {
    const ProjectStore store = ProjectStore::open(file, access);
    EXPECT_EQ(store.specification().requirements, fresh.specification().requirements);
    EXPECT_EQ(store.specification().tests, fresh.specification().tests);
    EXPECT_EQ(store.specification().links, fresh.specification().links);
    EXPECT_EQ(store.cepra(), fresh.cepra());
    EXPECT_TRUE(percollect::sameContent(store.graph().value(), fresh.graph().value()));
  }
}

INSTANTIATE_TEST_SUITE_P(Versions, AnOldFile, ::testing::Values("version-1.sql"),
                         [](const auto& old) { return "Version" + std::string(old.param).substr(8, 1); });

}  // namespace
}  // namespace specs
