#include "metrics/distributions/box_bounds.h"

#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limits>

#include "core/error.h"
#include "tests/metrics/random_cases.h"

namespace {

using metrics::contains;
using metrics::Edf;
using metrics::Interval;
using metrics::meanInterval;
using metrics::PBox;
using metrics::probabilityInterval;
using metrics::quantileInterval;
using metrics_test::RandomCases;
using testing::HasSubstr;
using testing::ThrowsMessage;

// Left edge 0, 5; right edge 4, 10.
PBox crossingRuns() { return PBox::envelope(std::vector<Edf>{Edf({0.0, 10.0}), Edf({4.0, 5.0})}); }

TEST(BoxBounds, AreReadAcrossAndUpwards) {
  const PBox box = crossingRuns();
  EXPECT_EQ(quantileInterval(box, 0.5), (Interval{.low = 0.0, .high = 4.0}));
  EXPECT_EQ(quantileInterval(box, 0.9), (Interval{.low = 5.0, .high = 10.0}));
  EXPECT_EQ(probabilityInterval(box, -1.0), (Interval{.low = 0.0, .high = 0.0}));
  EXPECT_EQ(probabilityInterval(box, 4.5), (Interval{.low = 0.5, .high = 0.5}));
  EXPECT_EQ(probabilityInterval(box, 7.0), (Interval{.low = 0.5, .high = 1.0}));
  EXPECT_EQ(meanInterval(box), (Interval{.low = 2.5, .high = 7.0}));
}

TEST(BoxBounds, OfASingleDistributionHaveNoWidth) {
  const PBox box = Edf({1.0, 2.0, 4.0});
  EXPECT_EQ(quantileInterval(box, 0.5), (Interval{.low = 2.0, .high = 2.0}));
  EXPECT_EQ(probabilityInterval(box, 2.0).width(), 0.0);
  EXPECT_EQ(meanInterval(box).width(), 0.0);
}

TEST(BoxBounds, HoldForEveryRunOfAnEnvelope) {
  RandomCases cases(70);
  for (int k = 0; k < 200; ++k) {
    const std::vector<Edf> runs = cases.runs();
    const PBox box = PBox::envelope(runs);
    const double p = cases.uniform(0.0, 1.0);
    const double x = cases.uniform(-6.0, 6.0);
    bool low_reached = false;
    bool high_reached = false;
    for (const Edf& run : runs) {
      EXPECT_TRUE(quantileInterval(box, p).contains(run.quantile(p)));
      EXPECT_TRUE(probabilityInterval(box, x).contains(run.cdf(x)));
      EXPECT_GE(run.mean(), meanInterval(box).low - 1e-13);
      EXPECT_LE(run.mean(), meanInterval(box).high + 1e-13);
      low_reached = low_reached || run.quantile(p) == quantileInterval(box, p).low;
      high_reached = high_reached || run.cdf(x) == probabilityInterval(box, x).high;
    }
    EXPECT_TRUE(low_reached);
    EXPECT_TRUE(high_reached);
  }
}

// Galois, edge by edge: some quantile at p is <= x exactly if p can be reached at x.
TEST(BoxBounds, QuantilesAndProbabilitiesAreInverse) {
  RandomCases cases(71);
  for (int k = 0; k < 500; ++k) {
    const PBox box = cases.box();
    const double p = cases.uniform(1e-9, 1.0);
    const double x = cases.uniform(-6.0, 6.0);
    EXPECT_EQ(quantileInterval(box, p).low <= x, p <= probabilityInterval(box, x).high);
    EXPECT_EQ(quantileInterval(box, p).high <= x, p <= probabilityInterval(box, x).low);
  }
}

TEST(BoxBounds, MeanIntervalIsAsWideAsTheBoxIsLarge) {
  RandomCases cases(72);
  for (int k = 0; k < 200; ++k) {
    const PBox box = cases.box();
    EXPECT_NEAR(meanInterval(box).width(), box.area(), 1e-13);
  }
}

TEST(Contains, EnvelopeItsRunsAndNothingBeyond) {
  RandomCases cases(73);
  for (int k = 0; k < 200; ++k) {
    const std::vector<Edf> runs = cases.runs();
    const PBox box = PBox::envelope(runs);
    EXPECT_TRUE(contains(box, box));
    for (const Edf& run : runs) EXPECT_TRUE(contains(box, run));
    EXPECT_FALSE(contains(box, box.left().shifted(-1e-9)));
    EXPECT_FALSE(contains(box, box.right().shifted(1e-9)));
  }
}

TEST(BoxBounds, RefuseWhatIsNoProbabilityAndNoValue) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double p : {-0.1, 1.1, nan}) {
    EXPECT_THAT([p] { (void)quantileInterval(crossingRuns(), p); },
                ThrowsMessage<core::InputError>(HasSubstr("lies between 0 and 1")));
  }
  EXPECT_THAT([nan] { (void)probabilityInterval(crossingRuns(), nan); },
              ThrowsMessage<core::InputError>(HasSubstr("nan is no value")));
}

}  // namespace
