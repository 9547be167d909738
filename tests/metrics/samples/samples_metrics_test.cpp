#include "metrics/samples/samples_metrics.h"

#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limits>
#include <set>
#include <string>

#include "tests/metrics/random_cases.h"

namespace {

using metrics::Edf;
using metrics::MetricOf;
using metrics::MetricShape;
using metrics::SamplePair;
using metrics::samplesMetrics;
using metrics_test::normalGrid;
using metrics_test::RandomCases;
using testing::ElementsAre;

const MetricOf<SamplePair>& metricNamed(std::string_view name) {
  for (const MetricOf<SamplePair>& metric : samplesMetrics()) {
    if (metric.info.name == name) return metric;
  }
  throw std::out_of_range(std::string(name));
}

TEST(SamplesMetrics, KeepTheKeysOfTheFileFormatInOrder) {
  std::vector<std::string> names;
  for (const MetricOf<SamplePair>& metric : samplesMetrics()) names.emplace_back(metric.info.name);
  names.resize(5);
  EXPECT_THAT(names, ElementsAre("ks", "wasserstein_1", "mean_difference", "median_difference", "std_difference"));
}

TEST(SamplesMetrics, HaveNumbersOfTheTableOnce) {
  std::multiset<int> numbers;
  for (const MetricOf<SamplePair>& metric : samplesMetrics()) numbers.insert(metric.info.number);
  for (const int number : {9, 30, 31, 33, 34}) EXPECT_EQ(numbers.count(number), 1u) << number;
}

TEST(SamplesMetrics, SayWhatTheyAre) {
  std::set<std::string_view> names;
  for (const MetricOf<SamplePair>& metric : samplesMetrics()) {
    const metrics::MetricInfo& info = metric.info;
    EXPECT_TRUE(names.insert(info.name).second) << info.name;
    for (const std::string_view text : {info.title, info.meaning, info.formula, info.best, info.worst, info.source}) {
      EXPECT_FALSE(text.empty()) << info.name;
    }
    EXPECT_FALSE(info.meaning.ends_with('.')) << info.name;
    EXPECT_FALSE(info.p_box) << info.name;
    EXPECT_EQ(metric.parts.empty(), metric.shape == MetricShape::Number) << info.name;
  }
}

// n = 1, counters with ties, tables: always as many numbers as parts, never an exception.
TEST(SamplesMetrics, GiveAsManyNumbersAsTheyHaveParts) {
  RandomCases cases(85);
  std::vector<Edf> samples = {Edf({1.0}), Edf({1.0, 1.0, 1.0}),
                              Edf::fromSteps(std::vector{1.0, 2.0}, std::vector{0.5, 1.0}),
                              Edf::weighted(std::vector{1.0, 2.0, 4.0}, std::vector{1.0, 2.0, 0.5})};
  for (int k = 0; k < 6; ++k) samples.push_back(cases.edf());
  for (const MetricOf<SamplePair>& metric : samplesMetrics()) {
    for (const Edf& simulated : samples) {
      for (const Edf& measured : samples) {
        const std::vector<double> numbers = metric.compute({.simulated = simulated, .measured = measured});
        EXPECT_EQ(numbers.size(), metric.shape == MetricShape::Number ? 1u : metric.parts.size()) << metric.info.name;
      }
    }
  }
}

TEST(SamplesMetrics, OfASampleMovedUpByTwo) {
  const Edf measured(normalGrid(5.0, 1.0, 20));
  const Edf simulated = measured.shifted(2.0);
  const auto value = [&](std::string_view name) {
    return metricNamed(name).compute({.simulated = simulated, .measured = measured}).front();
  };
  EXPECT_NEAR(value("wasserstein_1"), 2.0, 1e-12);
  EXPECT_NEAR(value("mean_difference"), 2.0, 1e-12);
  EXPECT_NEAR(value("median_difference"), 2.0, 1e-12);
  EXPECT_NEAR(value("abs_mean_difference"), 2.0, 1e-12);
  EXPECT_NEAR(value("std_difference"), 0.0, 1e-12);
  EXPECT_EQ(value("ks_positive"), 1.0);
  EXPECT_GT(value("anderson_darling"), 4.0);
  EXPECT_NEAR(value("js") * value("js"), value("js_divergence"), 1e-14);
  EXPECT_NEAR(metricNamed("kl").compute({.simulated = simulated, .measured = measured})[0], value("kl"), 0.0);
}

TEST(SamplesMetrics, SwappedDifferencesChangeTheirSign) {
  const Edf a({1.0, 2.0, 4.0});
  const Edf b({0.0, 3.0, 9.0});
  for (const char* name : {"mean_difference", "median_difference", "std_difference"}) {
    EXPECT_DOUBLE_EQ(metricNamed(name).compute({.simulated = a, .measured = b})[0],
                     -metricNamed(name).compute({.simulated = b, .measured = a})[0]);
  }
}

}  // namespace
