#include "metrics/validity/viehof.h"

#include <cmath>
#include <gtest/gtest.h>

#include "core/error.h"
#include "tests/metrics/resampling/normal_samples.h"
#include "tests/support/thrown_message.h"

namespace {

using metrics::Edf;
using metrics::ToleranceInterval;
using metrics::toleranceInterval;
using metrics::ValidityLabel;
using metrics::ValidityMap;
using metrics::viehofLabel;
using metrics::ViehofOptions;

ValidityLabel labelOf(std::vector<double> simulated, std::vector<double> measured, const ViehofOptions& options = {}) {
  return viehofLabel({.simulated = Edf(std::move(simulated)), .measured = Edf(std::move(measured))}, options).label;
}

// t(4, 0.975) = 2.7764451 (tables), mean 3, s = sqrt(2.5), n = 5.
TEST(ToleranceInterval, IsThatOfTheNextRepetition) {
  const ToleranceInterval interval = toleranceInterval(Edf({1.0, 2.0, 3.0, 4.0, 5.0}), 0.95);
  const double half = 2.7764451051977987 * std::sqrt(2.5) * std::sqrt(1.2);
  EXPECT_NEAR(interval.low, 3.0 - half, 1e-9);
  EXPECT_NEAR(interval.high, 3.0 + half, 1e-9);
}

// The defining property, exact for normals: of 2000 trials 90 % hold the next value (deviation 0.7 %).
TEST(ToleranceInterval, HoldsTheNextValueAsOftenAsItSays) {
  int held = 0;
  for (std::uint32_t k = 0; k < 2000; ++k) {
    std::vector<double> values = metrics_test::normalSample(k, 6);
    const double next = values.back();
    values.pop_back();
    const ToleranceInterval interval = toleranceInterval(Edf(values), 0.9);
    held += interval.low <= next && next <= interval.high ? 1 : 0;
  }
  EXPECT_NEAR(held / 2000.0, 0.9, 0.028);
}

// The measured interval is 3 -+ 4.809.
TEST(Viehof, LabelsBySharesOfTheSimulatedInterval) {
  const std::vector<double> measured{1.0, 2.0, 3.0, 4.0, 5.0};
  EXPECT_EQ(labelOf({2.9, 3.0, 3.1}, measured), ValidityLabel::Green);
  EXPECT_EQ(labelOf({7.2, 7.3, 7.5}, measured), ValidityLabel::Yellow);
  EXPECT_EQ(labelOf({8.0, 8.5, 9.0}, measured), ValidityLabel::Red);
  EXPECT_EQ(labelOf({19.9, 20.0, 20.1}, measured), ValidityLabel::Black);
}

TEST(Viehof, TakesASingleSimulatedValueAsAModelWithoutScatter) {
  const std::vector<double> measured{1.0, 2.0, 3.0, 4.0, 5.0};
  EXPECT_EQ(labelOf({7.8}, measured), ValidityLabel::Green);
  EXPECT_EQ(labelOf({7.9}, measured), ValidityLabel::Black);
}

TEST(Viehof, FollowsTheThresholdsItIsGiven) {
  const std::vector<double> measured{1.0, 2.0, 3.0, 4.0, 5.0};
  const metrics::ViehofResult result = viehofLabel({.simulated = Edf({7.2, 7.3, 7.5}), .measured = Edf(measured)});
  const double share = result.share_inside;
  EXPECT_GT(share, 0.5);
  EXPECT_LT(share, 1.0);
  EXPECT_EQ(labelOf({7.2, 7.3, 7.5}, measured, {.green = share}), ValidityLabel::Green);
  EXPECT_EQ(labelOf({7.2, 7.3, 7.5}, measured, {.yellow = share + 0.01}), ValidityLabel::Red);
  EXPECT_EQ(labelOf({7.2, 7.3, 7.5}, measured, {.yellow = share + 0.02, .red = share + 0.01}), ValidityLabel::Black);
}

TEST(Viehof, MovesWithTheData) {
  std::vector<double> simulated{7.2, 7.3, 7.5};
  std::vector<double> measured{1.0, 2.0, 3.0, 4.0, 5.0};
  const double share = viehofLabel({.simulated = Edf(simulated), .measured = Edf(measured)}).share_inside;
  for (double& x : simulated) x = 10.0 * x - 50.0;
  for (double& x : measured) x = 10.0 * x - 50.0;
  EXPECT_NEAR(viehofLabel({.simulated = Edf(simulated), .measured = Edf(measured)}).share_inside, share, 1e-12);
}

TEST(Viehof, RefusesASingleMeasurementAndDisorderedThresholds) {
  EXPECT_THROW((void)labelOf({1.0, 2.0}, {1.0}), core::InputError);
  EXPECT_THROW((void)labelOf({1.0, 2.0}, {1.0, 2.0}, {.green = 0.4}), core::InputError);
  EXPECT_THROW((void)labelOf({1.0, 2.0}, {1.0, 2.0}, {.confidence = 1.0}), core::InputError);
}

TEST(ValidityMap, IsAsValidAsItsWorstMeasurand) {
  ValidityMap map({"dry", "rain"}, {"range", "pulse width"});
  map.at(1, 0) = ValidityLabel::Yellow;
  map.at(1, 1) = ValidityLabel::Black;
  EXPECT_EQ(map.worstOf(0), ValidityLabel::Green);
  EXPECT_EQ(map.worstOf(1), ValidityLabel::Black);
  EXPECT_DOUBLE_EQ(map.shareUpTo(ValidityLabel::Green), 0.5);
  EXPECT_DOUBLE_EQ(map.shareUpTo(ValidityLabel::Yellow), 0.75);
  EXPECT_DOUBLE_EQ(map.shareUpTo(ValidityLabel::Black), 1.0);
}

TEST(ValidityMap, RefusesDoubledNames) {
  EXPECT_NE(test_support::thrownMessage([] {
              ValidityMap({"dry", "dry"}, {"range"});
            }).find("'dry'"),
            std::string::npos);
  EXPECT_THROW(ValidityMap({}, {"range"}), core::InputError);
}

}  // namespace
