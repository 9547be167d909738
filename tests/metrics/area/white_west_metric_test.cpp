#include "metrics/area/white_west_metric.h"

#include <algorithm>
#include <gtest/gtest.h>

#include "metrics/distributions/box_bounds.h"
#include "tests/metrics/random_cases.h"

namespace {

using metrics::AreaPortions;
using metrics::areaPortions;
using metrics::Edf;
using metrics::PBox;
using metrics::whiteWestPortions;
using metrics_test::RandomCases;
using metrics_test::widened;

double missing(const PBox& simulated, const PBox& measured) {
  return whiteWestPortions({.simulated = simulated, .measured = measured}).area();
}

TEST(WhiteWestMetric, OfIntervalsIsWhatSticksOutOnEitherSide) {
  const PBox simulated = PBox::fromInterval(2.0, 5.0);
  const PBox measured = PBox::fromInterval(1.0, 9.0);
  const AreaPortions portions = whiteWestPortions({.simulated = simulated, .measured = measured});
  EXPECT_EQ(portions.d_minus, 1.0);
  EXPECT_EQ(portions.d_plus, 4.0);
}

TEST(WhiteWestMetric, IsTheAreaThatTheEnvelopeOfBothAdds) {
  RandomCases cases(110);
  for (int k = 0; k < 300; ++k) {
    const PBox simulated = cases.box();
    const PBox measured = cases.box();
    const PBox both =
        PBox::envelope(std::vector<Edf>{simulated.left(), simulated.right(), measured.left(), measured.right()});
    EXPECT_NEAR(missing(simulated, measured), both.area() - simulated.area(), 1e-12);
  }
}

TEST(WhiteWestMetric, IsTheAreaMetricIfTheMeasurementIsASample) {
  RandomCases cases(111);
  for (int k = 0; k < 300; ++k) {
    const PBox simulated = cases.box();
    const PBox measured = cases.edf();
    const AreaPortions portions = whiteWestPortions({.simulated = simulated, .measured = measured});
    const AreaPortions area = areaPortions({.simulated = simulated, .measured = measured});
    EXPECT_EQ(portions.d_plus, area.d_plus);
    EXPECT_EQ(portions.d_minus, area.d_minus);
  }
}

TEST(WhiteWestMetric, IsNoSmallerThanTheAreaMetric) {
  RandomCases cases(112);
  for (int k = 0; k < 300; ++k) {
    const PBox simulated = cases.box();
    const PBox measured = cases.box();
    EXPECT_GE(missing(simulated, measured),
              metrics::areaValidationMetric({.simulated = simulated, .measured = measured}) - 1e-13);
  }
}

TEST(WhiteWestMetric, IsZeroExactlyIfTheSimulationCoversTheMeasurement) {
  RandomCases cases(113);
  int covered = 0;
  for (int k = 0; k < 500; ++k) {
    const PBox measured = cases.box();
    const PBox simulated = cases.box();
    const PBox wide = PBox::fromEdges(simulated.left().shifted(-cases.uniform(0.0, 6.0)),
                                      simulated.right().shifted(cases.uniform(0.0, 6.0)));
    EXPECT_EQ(missing(wide, measured) == 0.0, metrics::contains(wide, measured));
    covered += metrics::contains(wide, measured) ? 1 : 0;
  }
  EXPECT_GT(covered, 50);
  EXPECT_LT(covered, 450);
}

// What C sticks out of A, it sticks out of B, or B out of A. The area metric fails here: 0 + 0 < 10.
TEST(WhiteWestMetric, KeepsTheTriangleInequalityForBoxes) {
  RandomCases cases(114);
  for (int k = 0; k < 500; ++k) {
    const PBox a = cases.box();
    const PBox b = cases.box();
    const PBox c = cases.box();
    EXPECT_LE(missing(a, c), missing(a, b) + missing(b, c) + 1e-12);
  }
  const PBox between = PBox::fromInterval(0.0, 10.0);
  EXPECT_EQ(missing(Edf({0.0}), between), 10.0);
  EXPECT_EQ(missing(between, Edf({10.0})), 0.0);
  EXPECT_EQ(missing(Edf({0.0}), Edf({10.0})), 10.0);
}

// EDF +-w against the same EDF moved by c and widened by v: each side sticks out on its own.
TEST(WhiteWestMetric, OfWidenedCopiesIsTheExcessOnEachSide) {
  RandomCases cases(115);
  for (int k = 0; k < 200; ++k) {
    const Edf edf = cases.edf();
    const double c = cases.uniform(-2.0, 2.0);
    const double w = cases.uniform(0.0, 2.0);
    const double v = cases.uniform(0.0, 2.0);
    const PBox simulated = widened(edf.shifted(c), w);
    const PBox measured = widened(edf, v);
    const AreaPortions portions = whiteWestPortions({.simulated = simulated, .measured = measured});
    EXPECT_NEAR(portions.d_minus, std::max(0.0, c - w + v), 1e-13);
    EXPECT_NEAR(portions.d_plus, std::max(0.0, v - c - w), 1e-13);
  }
}

}  // namespace
