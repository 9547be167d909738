#include "metrics/distributions/p_box.h"

#include <algorithm>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "tests/metrics/random_cases.h"

namespace {

using metrics::Edf;
using metrics::PBox;
using metrics_test::RandomCases;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

TEST(PBox, CrossingRunsGiveEdgesThatAreNoneOfThem) {
  const std::vector<Edf> runs{Edf({0.0, 10.0}), Edf({4.0, 5.0})};
  const PBox box = PBox::envelope(runs);
  EXPECT_THAT(box.left().values(), ElementsAre(0.0, 5.0));
  EXPECT_THAT(box.right().values(), ElementsAre(4.0, 10.0));
  EXPECT_DOUBLE_EQ(box.area(), 4.5);
  EXPECT_DOUBLE_EQ(box.widthAt(0.5), 4.0);
}

// Largest and smallest CDF in the value domain, smallest and largest left-continuous quantile in the other: the same.
TEST(PBox, EdgesAreTheLargestAndSmallestCdfOfTheRuns) {
  RandomCases cases(3);
  for (int k = 0; k < 200; ++k) {
    const std::vector<Edf> runs = cases.runs();
    const PBox box = PBox::envelope(runs);
    for (const Edf& run : runs) {
      for (const double x : run.values()) {
        double smallest = 1.0;
        double largest = 0.0;
        for (const Edf& other : runs) {
          smallest = std::min(smallest, other.cdf(x));
          largest = std::max(largest, other.cdf(x));
        }
        EXPECT_EQ(box.left().cdf(x), largest);
        EXPECT_EQ(box.right().cdf(x), smallest);
      }
    }
  }
}

// Runs of one size without ties are combined rank by rank; a tie sends them through the walk over levels.
TEST(PBox, EnvelopeOfRunsOfOneSizeHasTheirExtremesAtEveryRank) {
  RandomCases cases(7);
  std::vector<std::vector<double>> samples(5, std::vector<double>(1000));
  for (auto& sample : samples) {
    for (double& x : sample) x = cases.uniform(-1.0, 1.0);
    std::sort(sample.begin(), sample.end());
  }
  for (const bool tie : {false, true}) {
    if (tie) samples[2][1] = samples[2][0];
    const PBox box = PBox::envelope(std::vector<Edf>(samples.begin(), samples.end()));
    for (std::size_t i = 0; i < 1000; ++i) {
      const auto [low, high] = std::minmax({samples[0][i], samples[1][i], samples[2][i], samples[3][i], samples[4][i]});
      const double level = static_cast<double>(i + 1) / 1000.0;
      ASSERT_EQ(box.left().quantile(level), low);
      ASSERT_EQ(box.right().quantile(level), high);
    }
  }
}

TEST(PBox, EnvelopeIsOrderIndependent) {
  RandomCases cases(4);
  for (int k = 0; k < 100; ++k) {
    std::vector<Edf> runs = cases.runs(6);
    const PBox box = PBox::envelope(runs);
    std::rotate(runs.begin(), runs.begin() + static_cast<std::ptrdiff_t>(runs.size() / 2), runs.end());
    std::reverse(runs.begin(), runs.end());
    const PBox other = PBox::envelope(runs);
    EXPECT_EQ(box.left(), other.left());
    EXPECT_EQ(box.right(), other.right());
  }
}

TEST(PBox, AreaIsTheDifferenceOfTheEdgesMeans) {
  RandomCases cases(5);
  for (int k = 0; k < 200; ++k) {
    const PBox box = cases.box();
    EXPECT_NEAR(box.area(), box.right().mean() - box.left().mean(), 1e-13);
  }
}

TEST(PBox, OneRunIsABoxOfWidthZero) {
  const std::vector<Edf> runs{Edf({1.0, 2.0})};
  const PBox box = PBox::envelope(runs);
  EXPECT_TRUE(box.isSingleDistribution());
  EXPECT_EQ(box.left(), box.right());
  EXPECT_EQ(box.area(), 0.0);
  EXPECT_EQ(box.left().n(), 2U);
}

TEST(PBox, ShiftMovesBothEdges) {
  const PBox box = PBox::fromInterval(2.0, 5.0).shifted(1.0);
  EXPECT_THAT(box.left().values(), ElementsAre(3.0));
  EXPECT_THAT(box.right().values(), ElementsAre(6.0));
}

TEST(PBox, RefusesNoRunsAndEdgesThatCross) {
  EXPECT_THAT([] { PBox::envelope({}); }, ThrowsMessage<core::InputError>(HasSubstr("no run to make a p-box of")));
  EXPECT_THAT(
      [] {
        PBox::fromEdges(Edf({1.0, 4.0}), Edf({2.0, 3.0}));
      },
      ThrowsMessage<core::InputError>(HasSubstr("level 1: the left edge of the p-box, 4, lies right of")));
  EXPECT_THAT([] { PBox::fromInterval(2.0, 1.0); }, ThrowsMessage<core::InputError>(HasSubstr("lies right of")));
}

}  // namespace
