#include "model/external/process.h"

#include <atomic>
#include <chrono>
#include <csignal>
#include <fstream>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <string>
#include <thread>

#include "core/error.h"
#include "core/file.h"
#include "tests/support/paths.h"

namespace model {
namespace {

using ::testing::HasSubstr;
using Kind = ProcessEnd::Kind;

/// Cancelled from the moment on at which a file exists.
class CancelOnceThereIs final : public core::Progress {
 public:
  explicit CancelOnceThereIs(std::filesystem::path file) : file_(std::move(file)) {}
  void report(double, std::string_view) override {}
  [[nodiscard]] bool cancelled() const override { return std::filesystem::exists(file_); }

 private:
  std::filesystem::path file_;
};

class Process : public ::testing::Test {
 protected:
  ProcessEnd run(const std::string& script, double time_limit_s = 60.0) {
    return runProcess(
        {.words = {"sh", "-c", script}, .folder = folder_.path(), .log = folder_ / "log", .time_limit_s = time_limit_s},
        nobody_);
  }

  /// Whether the process whose number a script wrote into `file` still runs; a zombie does not.
  [[nodiscard]] bool runs(const std::string& file) const {
    std::ifstream number(folder_ / file);
    std::string pid, name, state;
    EXPECT_TRUE(number >> pid) << file;
    std::ifstream stat("/proc/" + pid + "/stat");
    std::string skipped;
    return bool(stat >> skipped >> name >> state) && state != "Z" && state != "X";
  }

  /// SIGKILL is sent when runProcess returns; the kernel may need a moment.
  [[nodiscard]] bool ends(const std::string& file) const {
    for (int i = 0; i < 500 && runs(file); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(10));
    return !runs(file);
  }

  test_support::TemporaryFolder folder_;
  core::SilentProgress nobody_;
};

TEST_F(Process, StatusAndSignalAreTold) {
  EXPECT_EQ(run("exit 0").code, 0);
  const ProcessEnd failed = run("exit 7");
  EXPECT_EQ(failed.kind, Kind::kExited);
  EXPECT_EQ(failed.code, 7);
  const ProcessEnd killed = run("kill -SEGV $$");
  EXPECT_EQ(killed.kind, Kind::kKilled);
  EXPECT_EQ(killed.code, SIGSEGV);
}

TEST_F(Process, RunsInItsFolderWithoutInputAndLogsBothStreams) {
  EXPECT_EQ(run("pwd; cat; echo oops >&2").code, 0);
  EXPECT_EQ(lastLines(folder_ / "log"), std::filesystem::canonical(folder_.path()).string() + "\noops");
}

TEST_F(Process, WordsReachTheProgramAsTheyAre) {
  const std::string odd = "a b\"c'$HOME;*";
  const ProcessEnd end = runProcess(
      {.words = {"printf", "%s", odd}, .folder = folder_.path(), .log = folder_ / "log", .time_limit_s = 60}, nobody_);
  EXPECT_EQ(end.code, 0);
  EXPECT_EQ(core::readFile(folder_ / "log"), odd);
}

TEST_F(Process, AMissingProgramIsTold) {
  const ProcessEnd end = runProcess(
      {.words = {"./no-such-program"}, .folder = folder_.path(), .log = folder_ / "log", .time_limit_s = 60}, nobody_);
  EXPECT_EQ(end.kind, Kind::kNotStarted);
  EXPECT_EQ(end.code, ENOENT);
}

TEST_F(Process, TheTimeLimitEndsTheWholeGroup) {
  const ProcessEnd end = run("sleep 600 & echo $! > child; echo $$ > parent; wait", 0.3);
  EXPECT_EQ(end.kind, Kind::kTimeOut);
  EXPECT_TRUE(ends("parent"));
  EXPECT_TRUE(ends("child"));
}

TEST_F(Process, WhoIgnoresTheRequestIsEndedAllTheSame) {
  const ProcessEnd end = run("trap '' TERM; echo $$ > parent; while :; do sleep 0.05; done", 0.3);
  EXPECT_EQ(end.kind, Kind::kTimeOut);
  EXPECT_TRUE(ends("parent"));
}

// A file is there before anything is written into it, so it gets its name once the number is in.
TEST_F(Process, CancellingEndsTheWholeGroup) {
  const CancelOnceThereIs progress(folder_ / "parent");
  EXPECT_THROW(
      (void)runProcess({.words = {"sh", "-c", "sleep 600 & echo $! > child; echo $$ > number; mv number parent; wait"},
                        .folder = folder_.path(),
                        .log = folder_ / "log",
                        .time_limit_s = 600},
                       progress),
      core::Cancelled);
  EXPECT_TRUE(ends("parent"));
  EXPECT_TRUE(ends("child"));
}

TEST_F(Process, WhatWasLeftRunningEndsWithTheProgram) {
  EXPECT_EQ(run("sleep 600 & echo $! > child").code, 0);
  EXPECT_TRUE(ends("child"));
}

TEST_F(Process, LastLinesAreFewAndReadable) {
  EXPECT_EQ(run("for i in 1 2 3 4 5 6; do echo line $i; done; printf 'bell \\007 and \\377\\n'").code, 0);
  EXPECT_EQ(lastLines(folder_ / "log", 3), "line 5\nline 6\nbell   and ?");
  EXPECT_EQ(run("head -c 100000 /dev/zero | tr '\\0' 'x'; echo; echo end").code, 0);
  EXPECT_EQ(lastLines(folder_ / "log"), "end");
  EXPECT_EQ(lastLines(folder_ / "no log"), "");
}

}  // namespace
}  // namespace model
