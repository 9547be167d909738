#include "gap/candidates/candidates.h"

#include <gtest/gtest.h>

#include "tests/gap/measured_wall.h"

// What counts when causes are compared.
namespace {

class Merit : public test_support::MeasuredWall {
 protected:
  void SetUp() override { measure({}); }
  /// Of 900 that there are to explain.
  [[nodiscard]] double of(gap::Candidate candidate, double weight_of_total) const {
    return gap::Judge{*replay_, split_, {.baseline = 1000.0, .perfect = 100.0, .perfect_spread = 5.0}, weight_of_total}
        .meritOf(candidate);
  }
  [[nodiscard]] static gap::Candidate candidate(double explained, double discrepancy, std::size_t numbers = 0) {
    gap::Candidate candidate{.explained = explained, .discrepancy = discrepancy};
    candidate.hypothesis.parameters.resize(numbers);
    return candidate;
  }
};

TEST_F(Merit, ExcusesAWorldForHalfOfItsNoise) {
  EXPECT_DOUBLE_EQ(of(candidate(1.0, 550.0), 0.0), 0.75);  // half of the way, and all of it but for noise
}

TEST_F(Merit, FallsWithWhatIsLeftOfTheTotalGap) {
  gap::Candidate cause = candidate(0.9, 190.0);
  cause.total_left = 0.5;
  EXPECT_DOUBLE_EQ(of(cause, 0.3), 0.9 - 0.15);
  cause.total_left = 7.0;  // twice the gap is as wrong as seven times the gap
  EXPECT_DOUBLE_EQ(of(cause, 0.3), 0.9 - 0.6);
}

TEST_F(Merit, EveryFreeNumberCostsHalfTheLogarithmOfTheCells) {
  EXPECT_NEAR(of(candidate(0.9, 190.0, 8), 0.0), 0.9 - 8 * 4.0 / 900.0, 1e-12);
}

}  // namespace
