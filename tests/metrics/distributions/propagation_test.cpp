#include "metrics/distributions/propagation.h"

#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limits>

#include "core/error.h"
#include "metrics/distributions/box_bounds.h"
#include "tests/metrics/random_cases.h"

namespace {

using metrics::aleatoryOuter;
using metrics::contains;
using metrics::Edf;
using metrics::fromIntervals;
using metrics::Interval;
using metrics::PBox;
using metrics_test::RandomCases;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

/// One row per aleatory sample, one column per epistemic choice.
using Table = std::vector<std::vector<double>>;

template <typename Model>
Table simulated(const std::vector<double>& aleatory, const std::vector<double>& epistemic, Model model) {
  Table outputs;
  for (const double a : aleatory) {
    outputs.emplace_back();
    for (const double e : epistemic) outputs.back().push_back(model(a, e));
  }
  return outputs;
}

/// The other order of loops: one EDF per choice, then the envelope.
PBox epistemicOuter(const Table& outputs) {
  std::vector<Edf> runs;
  for (std::size_t choice = 0; choice < outputs.front().size(); ++choice) {
    std::vector<double> run;
    for (const std::vector<double>& row : outputs) run.push_back(row[choice]);
    runs.emplace_back(run);
  }
  return PBox::envelope(runs);
}

TEST(AleatoryOuter, OfAnAddedUnknownIsTheSampleWidenedByIt) {
  RandomCases cases(90);
  for (int k = 0; k < 100; ++k) {
    const std::vector<double> aleatory = cases.sample();
    const double w = cases.uniform(0.0, 2.0);
    const Table outputs = simulated(aleatory, {0.0, -w, 0.3 * w, w}, [](double a, double e) { return a + e; });
    const PBox box = aleatoryOuter(outputs);
    const PBox expected = metrics::widened(Edf(aleatory), {.below = w, .above = w});
    EXPECT_EQ(box.left(), expected.left());
    EXPECT_EQ(box.right(), expected.right());
    const PBox other_order = epistemicOuter(outputs);
    EXPECT_EQ(box.left(), other_order.left());
    EXPECT_EQ(box.right(), other_order.right());
  }
}

TEST(AleatoryOuter, ContainsTheEpistemicOuterBox) {
  RandomCases cases(91);
  for (int k = 0; k < 200; ++k) {
    const double frequency = cases.uniform(0.5, 3.0);
    const Table outputs = simulated(cases.sample(), cases.sample(6),
                                    [&](double a, double e) { return a * std::cos(frequency * e) + e * std::sin(a); });
    EXPECT_TRUE(contains(aleatoryOuter(outputs), epistemicOuter(outputs)));
  }
}

// A factor of unknown sign: as one constant it changes nothing of a symmetric sample, from value to value everything.
TEST(AleatoryOuter, OfAnUnknownSignIsWideWhereEpistemicOuterHasNoWidth) {
  const Table outputs = simulated({-1.0, 1.0}, {-1.0, 1.0}, [](double a, double e) { return a * e; });
  EXPECT_EQ(epistemicOuter(outputs).area(), 0.0);
  EXPECT_THAT(aleatoryOuter(outputs).left().values(), ElementsAre(-1.0));
  EXPECT_THAT(aleatoryOuter(outputs).right().values(), ElementsAre(1.0));
}

TEST(AleatoryOuter, OfOneChoiceIsTheSample) {
  const PBox box = aleatoryOuter(Table{{3.0}, {1.0}, {2.0}});
  EXPECT_EQ(box.left(), Edf({1.0, 2.0, 3.0}));
  EXPECT_EQ(box.area(), 0.0);
}

TEST(FromIntervals, EdgesAreTheSamplesOfLowAndOfHighEnds) {
  const std::vector<Interval> values{{.low = 2.0, .high = 3.0}, {.low = 0.0, .high = 5.0}, {.low = 1.0, .high = 1.0}};
  const PBox box = fromIntervals(values);
  EXPECT_EQ(box.left(), Edf({0.0, 1.0, 2.0}));
  EXPECT_EQ(box.right(), Edf({1.0, 3.0, 5.0}));
  EXPECT_EQ(box.left().n(), 3U);
}

TEST(FromIntervals, ContainsEverySampleFromTheIntervals) {
  RandomCases cases(92);
  for (int k = 0; k < 200; ++k) {
    std::vector<Interval> values;
    std::vector<double> sample;
    for (const double x : cases.sample()) {
      values.push_back({.low = x, .high = x + cases.uniform(0.0, 1.0)});
      sample.push_back(cases.uniform(values.back().low, values.back().high));
    }
    EXPECT_TRUE(contains(fromIntervals(values), Edf(sample)));
  }
}

TEST(Widened, MovesEachEdgeByItsOwnMargin) {
  const PBox box = metrics::widened(PBox::fromInterval(2.0, 5.0), {.below = 0.5, .above = 1.5});
  EXPECT_THAT(box.left().values(), ElementsAre(1.5));
  EXPECT_THAT(box.right().values(), ElementsAre(6.5));
  EXPECT_DOUBLE_EQ(metrics::widened(Edf({1.0, 4.0}), {.below = 0.25, .above = 0.5}).area(), 0.75);
}

TEST(Propagation, RefusesWhatIsNoOutputAndNoInterval) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  const auto outer = [](Table outputs) { return [outputs] { (void)aleatoryOuter(outputs); }; };
  EXPECT_THAT(outer({}), ThrowsMessage<core::InputError>(HasSubstr("has no values")));
  EXPECT_THAT(outer({{1.0}, {}}), ThrowsMessage<core::InputError>(HasSubstr("aleatory sample 2: has no output")));
  EXPECT_THAT(outer({{1.0}, {2.0, nan}}),
              ThrowsMessage<core::InputError>(HasSubstr("aleatory sample 2, epistemic choice 2: is nan")));
  const auto box = [](Interval second) {
    return [second] { (void)fromIntervals(std::vector<Interval>{{.low = 0.0, .high = 1.0}, second}); };
  };
  EXPECT_THAT(box({.low = 2.0, .high = 1.0}),
              ThrowsMessage<core::InputError>(HasSubstr("value 2: [2, 1] is no interval")));
  EXPECT_THAT(box({.low = nan, .high = 1.0}), ThrowsMessage<core::InputError>(HasSubstr("value 2")));
  EXPECT_THAT(box({.low = 0.0, .high = inf}), ThrowsMessage<core::InputError>(HasSubstr("value 2")));
  for (const double margin : {-0.1, nan, inf}) {
    EXPECT_THAT([margin] { (void)metrics::widened(Edf({1.0}), {.below = 0.0, .above = margin}); },
                ThrowsMessage<core::InputError>(HasSubstr("must be finite and not negative")));
  }
}

}  // namespace
