#include "metrics/validity/ngo.h"

#include <cmath>
#include <gtest/gtest.h>

#include "core/error.h"
#include "tests/support/thrown_message.h"

namespace {

using metrics::FidelityLevel;
using metrics::NgoGap;
using metrics::ngoGap;

std::vector<FidelityLevel> fourLevels() {
  return {
      {.name = "objects", .metrics = {{"ospa", 1.0, 4.0}, {"1 - iou", 0.75, 1.0}}},
      {.name = "detections of an object", .metrics = {{"rmse_x", 0.2, 1.0}, {"rmse_y", 0.4, 1.0}, {"n", 6.0, 10.0}}},
      {.name = "point clouds", .metrics = {{"wasserstein", 0.0, 3.0}}},
      {.name = "single quantities", .metrics = {{"r", 2.0, 2.0}, {"azimuth", 0.5, 1.0}}}};
}

// Level means by hand: (0.25 + 0.75)/2, (0.2 + 0.4 + 0.6)/3, 0, (1 + 0.5)/2.
TEST(NgoGap, IsTheMeanOfTheLevelsMeans) {
  const NgoGap gap = ngoGap(fourLevels());
  ASSERT_EQ(gap.levels.size(), 4u);
  EXPECT_DOUBLE_EQ(gap.levels[0], 0.5);
  EXPECT_DOUBLE_EQ(gap.levels[1], 0.4);
  EXPECT_DOUBLE_EQ(gap.levels[2], 0.0);
  EXPECT_DOUBLE_EQ(gap.levels[3], 0.75);
  EXPECT_DOUBLE_EQ(gap.gap, (0.5 + 0.4 + 0.0 + 0.75) / 4.0);
}

TEST(NgoGap, WeighsLevelsEquallyHoweverManyMetricsTheyHave) {
  std::vector<FidelityLevel> levels = fourLevels();
  const double before = ngoGap(levels).gap;
  levels[1].metrics.insert(levels[1].metrics.end(), levels[1].metrics.begin(), levels[1].metrics.end());
  EXPECT_DOUBLE_EQ(ngoGap(levels).gap, before);
}

TEST(NgoGap, RunsFromZeroToOne) {
  std::vector<FidelityLevel> levels = fourLevels();
  for (FidelityLevel& level : levels) {
    for (metrics::ScaledMetric& metric : level.metrics) metric.value = 0.0;
  }
  EXPECT_EQ(ngoGap(levels).gap, 0.0);
  for (FidelityLevel& level : levels) {
    for (metrics::ScaledMetric& metric : level.metrics) metric.value = metric.maximum;
  }
  EXPECT_EQ(ngoGap(levels).gap, 1.0);
}

TEST(NgoGap, IsIndependentOfTheUnits) {
  std::vector<FidelityLevel> levels = fourLevels();
  const double before = ngoGap(levels).gap;
  levels[0].metrics[0].value *= 1000.0;
  levels[0].metrics[0].maximum *= 1000.0;
  EXPECT_DOUBLE_EQ(ngoGap(levels).gap, before);
}

TEST(NgoGap, NamesTheMetricThatLeavesItsScale) {
  const auto message = [](double value, double maximum) {
    return test_support::thrownMessage([&] {
      (void)ngoGap(std::vector<FidelityLevel>{{.name = "objects", .metrics = {{"ospa", value, maximum}}}});
    });
  };
  EXPECT_NE(message(5.0, 4.0).find("level 'objects', metric 'ospa': is 5"), std::string::npos);
  EXPECT_NE(message(-1.0, 4.0).find("is -1"), std::string::npos);
  EXPECT_NE(message(NAN, 4.0).find("not between"), std::string::npos);
  EXPECT_NE(message(0.0, 0.0).find("must be positive"), std::string::npos);
  EXPECT_THROW((void)ngoGap({}), core::InputError);
  EXPECT_THROW((void)ngoGap(std::vector<FidelityLevel>{{.name = "objects", .metrics = {}}}), core::InputError);
}

}  // namespace
