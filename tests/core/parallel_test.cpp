#include "core/parallel.h"

#include <atomic>
#include <gtest/gtest.h>
#include <stdexcept>
#include <thread>

namespace {

// One piece of the outer loop fails while the other is at work: what that one computes must still be whole, or it would
// go on with half of its results. With one core nothing runs side by side and the test shows nothing.
TEST(ParallelFor, RunsAnInnerLoopToItsEndThoughAnotherPieceOfTheOuterOneThrows) {
  constexpr std::size_t kInner = 100;
  std::atomic<bool> working = false;
  std::atomic<int> begun = 0, whole = 0;
  const auto outer = [&](std::size_t piece, std::size_t) {
    if (piece == 0) {
      for (int i = 0; i < 200 && !working; ++i) std::this_thread::sleep_for(std::chrono::milliseconds(1));
      throw std::runtime_error("stop");
    }
    working = true;
    for (int round = 0; round < 30; ++round) {
      std::atomic<std::size_t> done = 0;
      ++begun;
      core::parallelFor(kInner, 1, [&](std::size_t, std::size_t) {
        std::this_thread::sleep_for(std::chrono::microseconds(1));
        ++done;
      });
      if (done == kInner) ++whole;
    }
  };
  EXPECT_THROW(core::parallelFor(2, 1, outer), std::runtime_error);
  EXPECT_EQ(whole, begun);
}

}  // namespace
