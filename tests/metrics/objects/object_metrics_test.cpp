#include "metrics/objects/object_metrics.h"

#include <gtest/gtest.h>
#include <set>

#include "tests/metrics/objects/random_objects.h"

namespace {

using metrics::MetricOf;
using metrics::MetricShape;
using metrics::ObjectListInput;
using metrics::objectMetrics;
using metrics::trackMetrics;
using metrics::TracksInput;

template <typename Input>
std::set<int> numbersOf(std::span<const MetricOf<Input>> list, const Input& input) {
  std::set<std::string_view> names;
  std::set<int> numbers;
  for (const MetricOf<Input>& metric : list) {
    SCOPED_TRACE(metric.info.name);
    EXPECT_TRUE(names.insert(metric.info.name).second);
    numbers.insert(metric.info.number);
    EXPECT_EQ(metric.compute(input).size(), metric.shape == MetricShape::Number ? 1U : metric.parts.size());
    EXPECT_EQ(metric.parts.empty(), metric.shape == MetricShape::Number);
    for (const auto& text : {metric.info.title, metric.info.meaning, metric.info.formula, metric.info.best,
                             metric.info.worst, metric.info.source}) {
      EXPECT_FALSE(text.empty());
    }
  }
  return numbers;
}

metrics_test::ObjectList boxes(const metrics_test::Cloud& at) {
  metrics_test::ObjectList list = metrics_test::objectsAt(at);
  for (metrics::Object& object : list) object.footprint = {.length_m = 4.0, .width_m = 2.0};
  return list;
}

TEST(ObjectMetrics, EveryEntryIsWholeAndGivesAsManyNumbersAsItHasParts) {
  metrics_test::RandomObjects cases(90);
  const metrics_test::ObjectList simulated = boxes(cases.cloud(4));
  const metrics_test::ObjectList measured = boxes(cases.cloud(3));
  const ObjectListInput input{.lists = {.simulated = simulated, .measured = measured}};
  EXPECT_EQ(numbersOf(objectMetrics(), input), (std::set<int>{24, 25, 28}));
}

TEST(TrackMetrics, EveryEntryIsWholeAndGivesAsManyNumbersAsItHasParts) {
  metrics_test::RandomObjects cases(91);
  const metrics_test::TrackList simulated = {cases.track(5), cases.track(5)};
  const metrics_test::TrackList measured = {cases.track(5)};
  const TracksInput input{.sets = {.simulated = simulated, .measured = measured}};
  EXPECT_EQ(numbersOf(trackMetrics(), input), (std::set<int>{0, 26, 27, 29}));
}

TEST(ObjectMetrics, OfEqualInputsAreZero) {
  metrics_test::RandomObjects cases(92);
  const metrics_test::ObjectList list = boxes(cases.cloud(6));
  for (const auto& metric : objectMetrics()) {
    const ObjectListInput input{.lists = {.simulated = list, .measured = list}};
    for (const double number : metric.compute(input)) EXPECT_EQ(number, 0.0) << metric.info.name;
  }
  const metrics_test::TrackList tracks = {cases.track(5), cases.track(5)};
  for (const auto& metric : trackMetrics()) {
    const TracksInput input{.sets = {.simulated = tracks, .measured = tracks}};
    for (const double number : metric.compute(input)) EXPECT_NEAR(number, 0.0, 1e-9) << metric.info.name;
  }
}

TEST(ObjectMetrics, LeaveOutImprobableObjectsOnlyIfTold) {
  metrics_test::ObjectList simulated = boxes({{0, 0, 0}, {50, 0, 0}});
  const metrics_test::ObjectList measured = boxes({{0, 0, 0}});
  simulated[1].existence = 0.3;
  ObjectListInput input{.lists = {.simulated = simulated, .measured = measured}};
  const auto& gospa = objectMetrics().back();
  ASSERT_EQ(gospa.info.name, "gospa");
  EXPECT_EQ(gospa.compute(input)[3], 1.0);
  input.options.least_existence = 0.5;
  EXPECT_EQ(gospa.compute(input)[3], 0.0);
}

}  // namespace
