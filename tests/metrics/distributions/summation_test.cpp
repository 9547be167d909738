#include "metrics/distributions/summation.h"

#include <array>
#include <cstdint>
#include <gtest/gtest.h>

namespace {

using metrics::blockSums;

// Whole numbers below 2^53 add exactly: 0 + … + (n - 1) and the sum of squares. Sizes around one and several blocks.
TEST(BlockSums, AddsEveryTermOnce) {
  for (const std::size_t n : {0u, 1u, 15u, 16u, 17u, 255u, 256u, 257u, 511u, 512u, 513u, 10'000u}) {
    const auto [sum, squares] = blockSums<2>(n, [](std::size_t i) {
      const auto x = static_cast<double>(i);
      return std::array{x, x * x};
    });
    const std::uint64_t m = n > 0 ? n - 1 : 0;
    EXPECT_EQ(sum, static_cast<double>(m * (m + 1) / 2)) << n;
    EXPECT_EQ(squares, static_cast<double>(m * (m + 1) * (2 * m + 1) / 6)) << n;
  }
}

// A tenth is not a double: added one by one, ten million of them are off by 1e-4. Tolerance: 20 roundings, 2e-9.
TEST(BlockSums, RoundingDoesNotGrowWithTheNumberOfTerms) {
  constexpr std::size_t kCount = 10'000'000;
  const double sum = blockSums<1>(kCount, [](std::size_t) { return std::array{0.1}; })[0];
  EXPECT_NEAR(sum, 1e6, 20 * 0x1p-53 * 1e6);
}

}  // namespace
