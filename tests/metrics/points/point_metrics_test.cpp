#include "metrics/points/point_metrics.h"

#include <gtest/gtest.h>
#include <set>

#include "tests/metrics/points/random_clouds.h"

namespace {

using metrics::MetricOf;
using metrics::MetricShape;
using metrics::PointCloudInput;
using metrics::pointMetrics;

TEST(PointMetrics, EveryEntryIsWholeAndGivesAsManyNumbersAsItHasParts) {
  metrics_test::RandomClouds cases(30);
  const metrics_test::Cloud simulated = cases.cloud(9);
  const metrics_test::Cloud measured = cases.cloud(7);
  const PointCloudInput input{.clouds = {.simulated = simulated, .measured = measured}};
  std::set<std::string_view> names;
  std::set<int> numbers;
  for (const MetricOf<PointCloudInput>& metric : pointMetrics()) {
    SCOPED_TRACE(metric.info.name);
    EXPECT_TRUE(names.insert(metric.info.name).second);
    numbers.insert(metric.info.number);
    EXPECT_EQ(metric.compute(input).size(), metric.shape == MetricShape::Number ? 1U : metric.parts.size());
    EXPECT_EQ(metric.parts.empty(), metric.shape == MetricShape::Number);
    for (const auto& text : {metric.info.title, metric.info.meaning, metric.info.formula, metric.info.best,
                             metric.info.worst, metric.info.source}) {
      EXPECT_FALSE(text.empty());
    }
    EXPECT_EQ(metric.info.data, std::vector{metrics::DataKind::PointCloud});
  }
  EXPECT_EQ(numbers, (std::set<int>{0, 8, 9, 10, 11, 12}));
}

TEST(PointMetrics, OfEqualCloudsAreTheBestValue) {
  metrics_test::RandomClouds cases(31);
  const metrics_test::Cloud cloud = cases.cloud(20);
  const PointCloudInput input{.clouds = {.simulated = cloud, .measured = cloud}};
  for (const MetricOf<PointCloudInput>& metric : pointMetrics()) {
    for (const double number : metric.compute(input)) {
      EXPECT_EQ(number, metric.info.best == "1" ? 1.0 : 0.0) << metric.info.name;
    }
  }
}

}  // namespace
