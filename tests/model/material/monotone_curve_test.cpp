#include "model/material/monotone_curve.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <vector>

namespace model {
namespace {

TEST(MonotoneCurve, PassesItsPointsAndHoldsItsEnds) {
  const MonotoneCurve curve({0, 1, 4, 5}, {2, 3, 1, 1});
  EXPECT_EQ(curve.at(0), 2);
  EXPECT_EQ(curve.at(1), 3);
  EXPECT_EQ(curve.at(4), 1);
  EXPECT_EQ(curve.at(-1), 2);
  EXPECT_EQ(curve.at(9), 1);
  EXPECT_EQ(MonotoneCurve({3}, {7}).at(0), 7);
}

TEST(MonotoneCurve, ReproducesStraightLines) {
  const MonotoneCurve curve({0, 1, 3, 4, 10}, {1, 3, 7, 9, 21});
  for (double x = 0; x <= 10; x += 0.1) EXPECT_NEAR(curve.at(x), 1 + 2 * x, 1e-12);
}

TEST(MonotoneCurve, NeverOvershoots) {
  const MonotoneCurve curve({0, 1, 2, 2.1, 5, 6}, {1, 1, 1, 0, 0, 3});
  double last = curve.at(0);
  for (double x = 0; x <= 5; x += 0.01) {
    EXPECT_LE(curve.at(x), last + 1e-12);
    EXPECT_GE(curve.at(x), -1e-12);
    last = curve.at(x);
  }
}

// Halving the step of a smooth function divides the error of a third-order scheme by about eight.
TEST(MonotoneCurve, ConvergesOnSmoothFunctions) {
  const auto worst = [](int n) {
    std::vector<double> x, y;
    for (int i = 0; i <= n; ++i) {
      x.push_back(1.2 * i / n);
      y.push_back(std::exp(-x.back()));
    }
    const MonotoneCurve curve(x, y);
    double error = 0;
    for (double t = 0; t <= 1.2; t += 0.001) error = std::max(error, std::abs(curve.at(t) - std::exp(-t)));
    return error;
  };
  EXPECT_LT(worst(20), worst(10) / 4);
  EXPECT_LT(worst(20), 1e-4);
}

}  // namespace
}  // namespace model
