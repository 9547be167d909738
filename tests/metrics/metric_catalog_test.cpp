#include "metrics/metric_catalog.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <set>
#include <string>

#include "core/error.h"
#include "tests/metrics/random_cases.h"

namespace {

using metrics::Edf;
using metrics::Metric;
using metrics::metricCatalog;
using metrics::MetricInput;
using metrics::metricNamed;
using metrics::MetricShape;
using metrics::PBox;
using testing::ElementsAre;

TEST(MetricCatalog, NamesEveryKeyOfTheFileFormat) {
  for (const char* name : {"d_avm", "d_plus", "d_minus", "d_bias", "d_cavm", "residual_bias", "d_bias_balanced",
                           "d_cavm_balanced", "dvm", "double_metric", "d_mavm", "d_avm_max", "pbox_area", "ks",
                           "mean_difference", "median_difference", "std_difference"}) {
    EXPECT_EQ(metricNamed(name).info.name, name);
  }
}

TEST(MetricCatalog, EveryMetricGivesAsManyNumbersAsItHasParts) {
  metrics_test::RandomCases cases(80);
  std::set<std::string_view> names;
  const PBox simulated = cases.box();
  const Edf pooled = cases.edf();
  const Edf measured({1.0, 2.0, 4.0});
  const PBox measured_box(measured);
  const MetricInput input({.simulated = simulated, .measured = measured_box},
                          {.simulated = pooled, .measured = measured});
  for (const Metric& metric : metricCatalog()) {
    EXPECT_TRUE(names.insert(metric.info.name).second) << metric.info.name;
    EXPECT_EQ(metric.compute(input).size(), metric.shape == MetricShape::Number ? 1U : metric.parts.size());
    EXPECT_EQ(metric.parts.empty(), metric.shape == MetricShape::Number) << metric.info.name;
    EXPECT_FALSE(metric.info.meaning.empty());
  }
}

// The interval [2, 5] simulated, 7 measured: 2 too low, whatever the choice inside; at most 5.
TEST(MetricCatalog, AgreesWithTheWorkedExampleOfAnInterval) {
  const PBox interval = PBox::fromInterval(2.0, 5.0);
  const Edf pooled({2.0, 5.0});
  const Edf seven({7.0});
  const PBox seven_box(seven);
  const MetricInput input({.simulated = interval, .measured = seven_box}, {.simulated = pooled, .measured = seven});
  const auto value = [&input](const char* name) { return metricNamed(name).compute(input); };
  EXPECT_THAT(value("d_avm"), ElementsAre(2.0));
  EXPECT_THAT(value("d_plus"), ElementsAre(2.0));
  EXPECT_THAT(value("d_minus"), ElementsAre(0.0));
  EXPECT_THAT(value("d_bias"), ElementsAre(-2.0));
  EXPECT_THAT(value("dvm"), ElementsAre(-2.0, 0.0));
  EXPECT_THAT(value("double_metric"), ElementsAre(5.0, 2.0));
  EXPECT_THAT(value("d_mavm"), ElementsAre(testing::DoubleEq(1.0 - 4.55), testing::DoubleEq(1.0 + 4.55)));
  EXPECT_THAT(value("d_avm_max"), ElementsAre(5.0));
  EXPECT_THAT(value("d_avm_max_error"), ElementsAre(0.0));
  EXPECT_THAT(value("pbox_area"), ElementsAre(3.0));
  EXPECT_THAT(value("mean_difference"), ElementsAre(-3.5));
  EXPECT_THAT(value("median_difference"), ElementsAre(-3.5));
  EXPECT_THAT(value("std_difference"), ElementsAre(testing::IsNan()));
  EXPECT_THAT(value("wasserstein_1"), ElementsAre(3.5));
}

// Rosenberger 2022, Tab. 4-3 numbers its metrics from 1 to 34.
TEST(MetricCatalog, HoldsEveryNumberOfTheTableOfMetrics) {
  std::set<int> numbers;
  for (const metrics::MetricInfo& info : metrics::allMetricInfos()) numbers.insert(info.number);
  for (int number = 1; number <= 34; ++number) EXPECT_TRUE(numbers.contains(number)) << number;
}

TEST(MetricCatalog, EveryMetricSaysWhatAReaderMustKnow) {
  for (const metrics::MetricInfo& info : metrics::allMetricInfos()) {
    EXPECT_FALSE(info.title.empty() || info.meaning.empty() || info.formula.empty()) << info.name;
    EXPECT_FALSE(info.best.empty() || info.worst.empty() || info.source.empty() || info.data.empty()) << info.name;
    EXPECT_EQ(info.meets.find_first_not_of("1234567"), std::string_view::npos) << info.name;
  }
}

TEST(MetricCatalog, AnIntervalScaleDoesNotAllowWhatAsksForARatio) {
  metrics::MetricInfo info;
  info.scale = metrics::Scale::Ratio;
  EXPECT_TRUE(metrics::isMeaningful(info, metrics::scaleNamed("ratio")));
  EXPECT_FALSE(metrics::isMeaningful(info, metrics::scaleNamed("interval")));
  EXPECT_THAT([] { (void)metrics::scaleNamed("ordinl"); },
              testing::ThrowsMessage<core::InputError>(testing::HasSubstr("nominal, ordinal, interval and ratio")));
}

TEST(MetricCatalog, UnknownNameIsToldTheNearest) {
  EXPECT_THAT([] { (void)metricNamed("d_bais"); },
              testing::ThrowsMessage<core::InputError>(testing::HasSubstr("Did you mean 'd_bias'?")));
}

TEST(MetricInput, RefusesZeroExperiments) {
  const Edf edf({1.0});
  const PBox box(edf);
  EXPECT_THAT(
      [&] {
        MetricInput({.simulated = box, .measured = box}, {.simulated = edf, .measured = edf}, {.experiments = 0.0});
      },
      testing::ThrowsMessage<core::InputError>(testing::HasSubstr("0 experiments")));
}

}  // namespace
