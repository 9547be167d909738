#include <cstdlib>
#include <gtest/gtest.h>

#include "tests/support/program.h"

namespace {

// A linker that thinks the library unused drops it, and nothing else would show.
TEST(Memory, OfTheProgramComesFromAnAllocatorThatGivesItBack) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "sanitizers bring an allocator of their own";
#endif
  ::setenv("MIMALLOC_SHOW_STATS", "1", 1);
  const test_support::ProgramRun run = test_support::runFidelis({"--version"});
  ::unsetenv("MIMALLOC_SHOW_STATS");
  EXPECT_EQ(run.status, 0);
  EXPECT_NE(run.messages.find("heap stats"), std::string::npos) << run.messages;
}

}  // namespace
