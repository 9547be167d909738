// Bad input, bad luck and other people never corrupt a project file.

#include <algorithm>
#include <fstream>
#include <functional>
#include <gmock/gmock.h>
#include <signal.h>
#include <sqlite3.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

#include "core/error.h"
#include "core/file.h"
#include "specs/project_store.h"
#include "tests/specs/small_project.h"
#include "tests/support/paths.h"

namespace specs {
namespace {

using test_specs::kEve;
using ::testing::HasSubstr;
using namespace std::chrono_literals;

std::string complaint(const std::function<void()>& work) {
  try {
    work();
  } catch (const core::InputError& error) {
    return error.what();
  }
  return "";
}

/// Runs `work` in a process of its own. Returns its process id.
pid_t inChild(const std::function<int()>& work) {
  const pid_t child = ::fork();
  if (child == 0) {
    int status = 99;
    try {
      status = work();
    } catch (...) {
    }
    ::_exit(status);
  }
  return child;
}

int statusOfChild(pid_t child) {
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

/// Runs SQL behind the store's back.
void runSql(const std::filesystem::path& file, const std::string& sql) {
  sqlite3* database = nullptr;
  ASSERT_EQ(sqlite3_open(file.c_str(), &database), SQLITE_OK);
  char* message = nullptr;
  EXPECT_EQ(sqlite3_exec(database, sql.c_str(), nullptr, nullptr, &message), SQLITE_OK) << message;
  sqlite3_free(message);
  sqlite3_close(database);
}

class AProjectFile : public ::testing::Test {
 protected:
  AProjectFile() {
    auto store = ProjectStore::create(file);
    test_specs::fill(store);
  }
  test_support::TemporaryFolder folder;
  std::filesystem::path file = folder / "demo.fidelis";
};

/// Two requirements at a time, so that half an action would show as an odd number.
void addPair(ProjectStore& store, int number) {
  store.inOneAction([&] {
    Requirement requirement{{.id = "Pair_A_" + std::to_string(number), .text = std::string(5000, 'x')}};
    store.add(requirement, kEve);
    requirement.id = "Pair_B_" + std::to_string(number);
    store.add(requirement, kEve);
  });
}

TEST_F(AProjectFile, SurvivesBeingKilledWhileWriting) {
  std::size_t most = 0;
  for (int round = 0; round < 12; ++round) {
    const pid_t child = inChild([&] {
      auto store = ProjectStore::open(file);
      for (int i = 1;; ++i) addPair(store, round * 100000 + i);
      return 0;
    });
    std::this_thread::sleep_for(std::chrono::milliseconds(5 + 7 * round));
    ::kill(child, SIGKILL);
    ASSERT_EQ(statusOfChild(child), 128 + SIGKILL);
    const auto store = ProjectStore::open(file);  // checks the file
    const std::size_t pairs = store.all<Requirement>().size() - 2;
    EXPECT_EQ(pairs % 2, 0u) << "half an action";
    EXPECT_GE(pairs, most) << "a completed action is lost";
    most = pairs;
  }
  EXPECT_GT(most, 0u) << "nothing was written before the kill: the test shows nothing";
}

TEST_F(AProjectFile, SurvivesAFullDisk) {
  const auto status = statusOfChild(inChild([&] {
    ::signal(SIGXFSZ, SIG_IGN);
    auto store = ProjectStore::open(file);
    const rlimit small{.rlim_cur = 400'000, .rlim_max = 400'000};
    if (::setrlimit(RLIMIT_FSIZE, &small) != 0) return 1;
    const std::string said = complaint([&] {
      for (int i = 1; i < 1000; ++i) addPair(store, i);
    });
    return said.find("disk full") != std::string::npos ? 0 : 2;
  }));
  EXPECT_EQ(status, 0);
  auto store = ProjectStore::open(file);
  const std::size_t pairs = store.all<Requirement>().size() - 2;
  EXPECT_GT(pairs, 0u);
  EXPECT_EQ(pairs % 2, 0u);
  addPair(store, 5000);  // room again: the work goes on
}

TEST_F(AProjectFile, ANewProjectThatFindsNoRoomLeavesNothing) {
  const std::filesystem::path other = folder / "other.fidelis";
  const auto status = statusOfChild(inChild([&] {
    ::signal(SIGXFSZ, SIG_IGN);
    const rlimit small{.rlim_cur = 10'000, .rlim_max = 10'000};
    if (::setrlimit(RLIMIT_FSIZE, &small) != 0) return 1;
    return complaint([&] { ProjectStore::create(other); }).empty() ? 2 : 0;
  }));
  EXPECT_EQ(status, 0);
  EXPECT_FALSE(std::filesystem::exists(other));
}

TEST_F(AProjectFile, AWriterWaitsForAnotherThenSaysSo) {
  auto mine = ProjectStore::open(file);
  auto other = ProjectStore::open(file);
  mine.setPatience(50ms);
  other.inOneAction([&] {
    addPair(other, 1);
    EXPECT_THAT(complaint([&] { addPair(mine, 2); }), HasSubstr("another program is writing"));
    EXPECT_EQ(mine.all<Requirement>().size(), 2u) << "readers see the last completed action, and do not wait";
  });
  addPair(mine, 2);
  EXPECT_EQ(mine.all<Requirement>().size(), 6u);
}

TEST_F(AProjectFile, ProcessesTakeTurns) {
  const auto write = [&](int from) {
    return inChild([&, from] {
      auto store = ProjectStore::open(file);
      for (int i = 1; i <= 20; ++i) addPair(store, from + i);
      return 0;
    });
  };
  const pid_t first = write(100);
  const pid_t second = write(200);
  EXPECT_EQ(statusOfChild(first), 0);
  EXPECT_EQ(statusOfChild(second), 0);
  EXPECT_EQ(ProjectStore::open(file).all<Requirement>().size(), 2u + 2 * 2 * 20);
}

TEST_F(AProjectFile, OpenForReadingRefusesEveryWriteAndLeavesNoTrace) {
  const std::string before = core::readFile(file);
  {
    auto store = ProjectStore::open(file, Access::ReadOnly);
    EXPECT_TRUE(store.readOnly());
    EXPECT_EQ(store.all<Requirement>().size(), 2u);
    EXPECT_THAT(complaint([&] { addPair(store, 1); }), HasSubstr("reading only"));
  }
  EXPECT_EQ(core::readFile(file), before);
  EXPECT_FALSE(std::filesystem::exists(file.string() + "-wal"));
  EXPECT_FALSE(std::filesystem::exists(file.string() + "-shm"));
}

TEST_F(AProjectFile, ThatIsWriteProtectedCanBeReadAndSaysSo) {
  std::filesystem::permissions(file, std::filesystem::perms(0444));
  std::filesystem::permissions(folder.path(), std::filesystem::perms(0555));
  const auto status = statusOfChild(inChild([&] {
    // Permissions mean nothing to root: become nobody.
    if (::geteuid() == 0 && (::setgid(65534) != 0 || ::setuid(65534) != 0)) return 1;
    if (complaint([&] { (void)ProjectStore::open(file); }).find("write-protected") == std::string::npos) return 2;
    return ProjectStore::open(file, Access::ReadOnly).all<Requirement>().size() == 2 ? 0 : 3;
  }));
  std::filesystem::permissions(folder.path(), std::filesystem::perms(0755));
  EXPECT_EQ(status, 0);
}

TEST_F(AProjectFile, IsNotReplacedByANewOne) {
  EXPECT_THAT(complaint([&] { (void)ProjectStore::create(file); }), HasSubstr("there already"));
}

TEST_F(AProjectFile, OfANewerProgramIsRefusedAndLeftAlone) {
  runSql(file, "PRAGMA user_version = 999");
  const std::string before = core::readFile(file);
  EXPECT_THAT(complaint([&] { (void)ProjectStore::open(file); }), HasSubstr("newer program (version 999"));
  EXPECT_THAT(complaint([&] { (void)ProjectStore::open(file, Access::ReadOnly); }), HasSubstr("newer program"));
  EXPECT_EQ(core::readFile(file), before);
}

TEST_F(AProjectFile, ThatIsDamagedIsAnErrorAndNoCrash) {
  const std::string whole = core::readFile(file);
  ASSERT_GT(whole.size(), 40'000u);
  int refused = 0;
  for (std::size_t at = 4096; at + 4096 <= whole.size(); at += 4096) {
    std::string damaged = whole;
    std::fill_n(damaged.begin() + static_cast<std::ptrdiff_t>(at), 4096, static_cast<char>(0xa5));
    core::writeFile(folder / "damaged.fidelis", damaged);
    const std::string said = complaint([&] { (void)ProjectStore::open(folder / "damaged.fidelis").specification(); });
    if (!said.empty()) {
      EXPECT_THAT(said, HasSubstr("damaged"));
      ++refused;
    }
  }
  EXPECT_GT(refused, 5);
  for (const std::size_t length : {20u, 100u, 5000u}) {  // cut off
    core::writeFile(folder / "damaged.fidelis", whole.substr(0, length));
    EXPECT_NE(complaint([&] { (void)ProjectStore::open(folder / "damaged.fidelis"); }), "") << length;
  }
}

TEST_F(AProjectFile, OfAnotherKindIsToldApart) {
  EXPECT_THAT(complaint([&] { (void)ProjectStore::open(folder / "absent"); }), HasSubstr("no such project file"));
  EXPECT_THAT(complaint([&] { (void)ProjectStore::open(folder.write("text", "hello, I am a longer text")); }),
              HasSubstr("no project file"));
  EXPECT_THAT(complaint([&] { (void)ProjectStore::open(folder.write("empty", "")); }), HasSubstr("no project file"));
  runSql(folder / "music.db", "CREATE TABLE song (title TEXT)");
  EXPECT_THAT(complaint([&] { (void)ProjectStore::open(folder / "music.db"); }), HasSubstr("no Fidelis project"));
  EXPECT_THAT(complaint([&] { (void)ProjectStore::open(folder.path()); }), HasSubstr("no project file"));
  EXPECT_THAT(complaint([&] { (void)ProjectStore::create(folder / "no/such/folder/x"); }), HasSubstr("folder"));
}

TEST_F(AProjectFile, WithWeirdCharactersInItsNameOpens) {
  const std::filesystem::path odd = folder / "a b%20?#'.fidelis";
  std::filesystem::copy_file(file, odd);
  EXPECT_EQ(ProjectStore::open(odd, Access::ReadOnly).all<Requirement>().size(), 2u);
}

}  // namespace
}  // namespace specs
