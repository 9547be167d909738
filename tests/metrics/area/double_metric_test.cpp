#include "metrics/area/double_metric.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "tests/metrics/random_cases.h"

namespace {

using metrics::DoubleMetric;
using metrics::doubleMetric;
using metrics::Edf;
using metrics::PBox;
using metrics_test::RandomCases;
using metrics_test::widened;

TEST(DoubleMetric, OfANumberAndAnIntervalIsTheDistanceToEachEnd) {
  const PBox interval = PBox::fromInterval(2.0, 5.0);
  const PBox seven = Edf({7.0});
  const DoubleMetric metric = doubleMetric({.simulated = interval, .measured = seven});
  EXPECT_EQ(metric.left, 5.0);
  EXPECT_EQ(metric.right, 2.0);
}

TEST(DoubleMetric, OfAShiftedAndWidenedCopyIsTheShiftOfEachEdge) {
  RandomCases cases(50);
  for (int k = 0; k < 100; ++k) {
    const Edf measured = cases.edf();
    const double c = cases.uniform(-2.0, 2.0);
    const double w = cases.uniform(0.0, 2.0);
    const DoubleMetric metric = doubleMetric({.simulated = widened(measured.shifted(c), w), .measured = measured});
    EXPECT_NEAR(metric.left, std::abs(c - w), 1e-13);
    EXPECT_NEAR(metric.right, std::abs(c + w), 1e-13);
  }
}

TEST(DoubleMetric, SeesTheWidthThatTheAreaExcuses) {
  RandomCases cases(51);
  for (int k = 0; k < 200; ++k) {
    const Edf simulated = cases.edf();
    const Edf measured = cases.edf();
    const double w = cases.uniform(0.0, 2.0);
    const DoubleMetric metric = doubleMetric({.simulated = widened(simulated, w), .measured = measured});
    EXPECT_GE(std::max(metric.left, metric.right), w + std::abs(simulated.mean() - measured.mean()) - 1e-12);
  }
}

// Both sides widened, by w and v: edges lie c - w + v and c + w - v apart.
TEST(DoubleMetric, OfTwoBoxesIsTheDistanceOfEdges) {
  RandomCases cases(52);
  for (int k = 0; k < 100; ++k) {
    const Edf edf = cases.edf();
    const double c = cases.uniform(-2.0, 2.0);
    const double w = cases.uniform(0.0, 2.0);
    const double v = cases.uniform(0.0, 2.0);
    const DoubleMetric metric = doubleMetric({.simulated = widened(edf.shifted(c), w), .measured = widened(edf, v)});
    EXPECT_NEAR(metric.left, std::abs(c - w + v), 1e-13);
    EXPECT_NEAR(metric.right, std::abs(c + w - v), 1e-13);
  }
}

}  // namespace
