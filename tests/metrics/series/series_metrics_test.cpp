#include "metrics/series/series_metrics.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <set>

#include "core/json_object.h"
#include "tests/support/paths.h"
#include "tests/support/thrown_message.h"

namespace {

using metrics::MetricOf;
using metrics::SeriesInput;
using metrics::seriesMetrics;
using test_support::thrownMessage;

const MetricOf<SeriesInput>& named(std::string_view name) {
  const auto all = seriesMetrics();
  const auto found = std::find_if(all.begin(), all.end(), [&](const auto& metric) { return metric.info.name == name; });
  if (found == all.end()) throw std::out_of_range(std::string(name));
  return *found;
}

/// Rounding of numpy's sums over 60 values, some of them near 1e6.
void expectClose(double value, double reference) {
  EXPECT_NEAR(value, reference, 1e-9 * std::max(1.0, std::abs(reference)));
}

// tests/data/metrics/series/make_reference.py: numpy 1.24.2, scipy 1.10.1.
TEST(SeriesMetrics, ReproduceNumpyAndScipy) {
  const nlohmann::json cases = core::readJson(test_support::testData("metrics/series/reference.json"));
  ASSERT_EQ(cases.size(), 6u);
  for (const auto& [name, expected] : cases.items()) {
    SCOPED_TRACE(name);
    const auto simulated = expected.at("simulated").get<std::vector<double>>();
    const auto measured = expected.at("measured").get<std::vector<double>>();
    const SeriesInput input = {
        .simulated = simulated, .measured = measured, .largest_lag = expected.at("largest_lag").get<std::size_t>()};
    int compared = 0;
    for (const MetricOf<SeriesInput>& metric : seriesMetrics()) {
      const std::string key(metric.info.name);
      if (!expected.contains(key)) continue;
      SCOPED_TRACE(key);
      ++compared;
      const std::vector<double> numbers = metric.compute(input);
      if (metric.parts.empty()) expectClose(numbers.at(0), expected[key]);
      for (std::size_t i = 0; i < metric.parts.size(); ++i) {
        expectClose(numbers.at(i), expected[key].at(std::string(metric.parts[i])));
      }
    }
    EXPECT_EQ(compared, 12);
  }
}

TEST(SeriesMetrics, OverallErrorIsManhattan) {
  const std::vector<double> simulated = {1.0, 2.0};
  const std::vector<double> measured = {3.0, 1.0};
  const SeriesInput input = {.simulated = simulated, .measured = measured};
  EXPECT_EQ(named("overall_error").compute(input), named("manhattan").compute(input));
}

TEST(SeriesMetrics, GiveAsManyNumbersAsPartsAndAreNamedOnce) {
  const std::vector<double> simulated = {1.0, 2.0, 4.0, 3.0, 5.0};
  const std::vector<double> measured = {1.0, 2.5, 3.0, 3.0, 6.0};
  const SeriesInput input = {.simulated = simulated, .measured = measured};
  std::set<std::string_view> names;
  for (const MetricOf<SeriesInput>& metric : seriesMetrics()) {
    EXPECT_TRUE(names.insert(metric.info.name).second) << metric.info.name;
    EXPECT_EQ(metric.compute(input).size(), std::max<std::size_t>(1, metric.parts.size())) << metric.info.name;
    for (const std::string_view text : {metric.info.title, metric.info.meaning, metric.info.formula, metric.info.best,
                                        metric.info.worst, metric.info.source}) {
      EXPECT_FALSE(text.empty()) << metric.info.name;
    }
    EXPECT_FALSE(metric.info.data.empty());
  }
}

TEST(SeriesMetrics, OfEqualSeriesAreAtTheirBest) {
  const std::vector<double> series = {1.0, 2.5, 3.0, -3.0, 6.0};
  const SeriesInput input = {.simulated = series, .measured = series};
  for (const MetricOf<SeriesInput>& metric : seriesMetrics()) {
    const double best = metric.info.best.front() == '1' ? 1.0 : 0.0;
    EXPECT_NEAR(metric.compute(input).front(), best, 1e-15) << metric.info.name;
  }
}

TEST(SeriesMetrics, OptionsReachTheirMetrics) {
  const std::vector<double> simulated = {0.0, 0.0, 0.0, 5.0, 0.0, 0.0, 0.0, 0.0};
  const std::vector<double> measured = {0.0, 5.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
  SeriesInput input = {.simulated = simulated, .measured = measured, .largest_lag = 1, .warping_window = 0};
  EXPECT_LE(std::abs(named("cross_correlation").compute(input)[1]), 1.0);
  EXPECT_EQ(named("dtw").compute(input).front(), 10.0);
  input.largest_lag = 2;
  input.warping_window = 2;
  EXPECT_EQ(named("cross_correlation").compute(input)[1], 2.0);
  EXPECT_EQ(named("dtw").compute(input).front(), 0.0);
}

// A frame lost between 0.2 s and 0.4 s: behind it a lag of one value is another time.
TEST(SeriesMetrics, WithLagsRefuseUnevenTimes) {
  const std::vector<double> series = {1.0, 2.0, 4.0, 3.0, 5.0, 4.0};
  const std::vector<double> even = {0.0, 0.1, 0.21, 0.29, 0.4, 0.5};
  const std::vector<double> gap = {0.0, 0.1, 0.2, 0.4, 0.5, 0.6};
  const std::vector<double> too_few = {0.0, 0.1};
  const std::vector<double> stopped(6, 3.0);
  const std::vector<double> backwards = {0.5, 0.4, 0.3, 0.2, 0.1, 0.0};
  for (const std::string_view name : {"cross_correlation", "autocorrelation_difference"}) {
    const auto message = [&](const std::vector<double>& times) {
      return thrownMessage(
          [&] { (void)named(name).compute({.simulated = series, .measured = series, .times_s = times}); });
    };
    EXPECT_EQ(message(even), "");
    EXPECT_NE(message(gap).find("times, value 4: comes 0.2 s after the one before"), std::string::npos);
    EXPECT_NE(message(stopped).find("times, value 2"), std::string::npos);
    EXPECT_NE(message(backwards).find("times, value 2"), std::string::npos);
    EXPECT_NE(message(too_few).find("are 2 for 6 values"), std::string::npos);
  }
}

}  // namespace
