#include "core/memory.h"

#include <cstddef>
#include <fstream>
#include <gtest/gtest.h>
#include <vector>

namespace {

/// Memory that the process holds. 0 where the system does not say. [MiB]
double held_MiB() {
  constexpr double kPage_MiB = 4096.0 / (1024.0 * 1024.0);
  std::ifstream statm("/proc/self/statm");
  double all = 0.0, resident = 0.0;
  statm >> all >> resident;
  return resident * kPage_MiB;
}

/// Blocks of growing size, a small one that stays after each: what remembering the results of long work is like.
void workAndRemember(std::vector<std::vector<char>>& remembered) {
  std::vector<std::vector<char>> large;
  for (std::size_t i = 0; i < 30; ++i) {
    large.emplace_back((i % 5 + 1) * 5'000'000, 'x');
    remembered.emplace_back(2000, 'y');
    if (i % 3 == 0) large.front() = {};  // the first one freed raises the threshold
  }
}

TEST(Memory, GoesBackWhenLargeBlocksAreFreedThoughSmallOnesStay) {
  core::returnLargeBlocks();
  std::vector<std::vector<char>> remembered;
  const double before_MiB = held_MiB();
  if (before_MiB == 0.0) GTEST_SKIP() << "this system does not say how much memory a process holds";
  for (int round = 0; round < 3; ++round) workAndRemember(remembered);
  EXPECT_LT(held_MiB() - before_MiB, 20.0);  // a round takes 450 MB
}

}  // namespace
