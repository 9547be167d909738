#include "core/bulk_math.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numeric>
#include <vector>

namespace core {
namespace {

struct Columns {
  explicit Columns(std::size_t count) : n(4, std::vector<float>(count)) {}
  [[nodiscard]] std::array<std::span<float>, 4> spans() { return {n[0], n[1], n[2], n[3]}; }
  std::vector<std::vector<float>> n;
};

// The same Philox words and the same Box–Muller as core::Random, whose words come from another library.
TEST(BulkMath, NormalsAreThoseOfTheStreamsOneByOne) {
  for (const std::size_t count : {1UL, 3UL, 16UL, 37UL}) {
    std::vector<std::uint32_t> beams(count);
    std::iota(beams.begin(), beams.end(), 5U);
    const Random::Key key{.seed = 0x123456789ABCULL, .sample = 3, .frame = 7, .purpose = purposeOf("a test")};
    Columns columns(count);
    normalsOf(key, beams, 0, columns.spans());
    for (std::size_t i = 0; i < count; ++i) {
      Random::Key own = key;
      own.beam = beams[i];
      Random random(own);
      for (std::size_t n = 0; n < 4; ++n) EXPECT_NEAR(columns.n[n][i], random.normal(), 1e-5) << count << " " << i;
    }
  }
}

TEST(BulkMath, AStreamDoesNotDependOnItsNeighbours) {
  const std::vector<std::uint32_t> many{9, 8, 7, 6, 5, 4, 3, 2, 1, 0, 11, 12, 13, 14, 15, 16, 17, 18, 19};
  Columns together(many.size());
  normalsOf({.seed = 1}, many, 2, together.spans());
  for (std::size_t i = 0; i < many.size(); ++i) {
    Columns alone(1);
    normalsOf({.seed = 1}, std::span(many).subspan(i, 1), 2, alone.spans());
    for (std::size_t n = 0; n < 4; ++n) EXPECT_EQ(together.n[n][i], alone.n[n][0]);
  }
}

TEST(BulkMath, FramesOfABeamAreDrawnAsOneByOne) {
  const Random::Key first{.seed = 0x123456789ABCULL, .sample = 3, .frame = 7, .beam = 12};
  Columns together(21);
  normalsInFrames(first, 3, together.spans());
  for (std::size_t i = 0; i < together.n[0].size(); ++i) {
    Random::Key own = first;
    own.frame += static_cast<std::uint32_t>(i);
    Columns alone(1);
    normalsOf(own, std::span(&own.beam, 1), 3, alone.spans());
    for (std::size_t n = 0; n < 4; ++n) EXPECT_EQ(together.n[n][i], alone.n[n][0]) << i;
  }
}

TEST(BulkMath, LogarithmAndExponentialAgreeWithTheLibrary) {
  std::vector<double> x, out;
  for (double value = 1e-12; value < 1e12; value *= 1.37) x.push_back(value);
  out.resize(x.size());
  log2Of(x, out);
  for (std::size_t i = 0; i < x.size(); ++i) EXPECT_NEAR(out[i], std::log2(x[i]), 1e-14 * (1 + std::abs(out[i])));
  std::vector<double> negative;
  for (const double value : x) negative.push_back(-std::min(value, 700.0));
  expOf(negative, out);
  for (std::size_t i = 0; i < x.size(); ++i) EXPECT_NEAR(out[i], std::exp(negative[i]), 1e-14 * std::exp(negative[i]));
}

}  // namespace
}  // namespace core
