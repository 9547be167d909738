#include "gap/causes/starts.h"

#include <algorithm>
#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/gap/measured_wall.h"

// Where the residual map lets a search begin.
namespace {

using test_support::SmallWorld;

class Starts : public test_support::MeasuredWall {};

// One in five hundred shots: three frames of four samples hardly have such an echo, all that was measured has dozens.
TEST_F(Starts, BeginsAtTheRateAtWhichFalseEchoesCame) {
  measure({{"false-alarm", {{"rate_per_beam", 0.002}}}});
  const auto where = gap::whereIn(*replay_, replay_->baseline(), 1);
  const auto starts = gap::startsFrom(*replay_, effect("false-alarm"), where);
  ASSERT_EQ(starts.size(), 1U);
  const double shots = 6.0 * 20.0 * 4.0 * 41.0;
  EXPECT_NEAR(starts[0][0], 0.002, 4.0 * std::sqrt(0.002 / shots));
  const auto of_pulses = gap::startsFrom(*replay_, effect("crosstalk"), where);
  ASSERT_FALSE(of_pulses.empty());
  EXPECT_NEAR(of_pulses[0][0] * 2.0 * 150.0 / 299792458.0, starts[0][0], 1e-9);
}

// What edges do in two programs is no false echo, so beams at edges are no shots either. Of a wall 3 m wide many are.
TEST_F(Starts, CountsFalseEchoesOfTheBeamsThatItLooksAtOnly) {
  world_.withAWallOf(3.0);
  measure({{"false-alarm", {{"rate_per_beam", 0.1}}}});
  const auto where = gap::whereIn(*replay_, replay_->baseline(), 1);
  const double shots = 6.0 * 20.0 * 4.0 * 37.0;  // without two columns at each edge: with them a tenth would be lost
  EXPECT_NEAR(where.false_echoes_per_shot, 0.1, 2.5 * std::sqrt(0.1 / shots));
}

// Within the echo separation, 0.8 m, two echoes are one, and its range lies between them.
TEST_F(Starts, LooksForAFalseTargetOnBothSidesOfTheEchoThatItMayPull) {
  measure({});
  gap::WhereResult where;
  where.rows.push_back({.measurand = "range", .covariate = "azimuth_deg", .low = 4.0, .high = 6.0});
  where.rows.push_back({.measurand = "range", .covariate = "range_m", .low = 13.0, .high = 13.2});
  std::vector<double> ranges_m;
  for (const auto& start : gap::startsFrom(*replay_, effect("spoofing"), where)) {
    EXPECT_DOUBLE_EQ(start[0], 5.0);  // azimuth_deg
    ranges_m.push_back(start[1]);
  }
  using testing::DoubleNear;
  EXPECT_THAT(ranges_m,
              testing::UnorderedElementsAre(DoubleNear(12.7, 1e-9), DoubleNear(12.9, 1e-9), DoubleNear(13.1, 1e-9),
                                            DoubleNear(13.3, 1e-9), DoubleNear(13.5, 1e-9)));
}

// From an irradiance that saturates the receiver no step leads to a gain that gives way alone.
TEST_F(Starts, BeginsWithEachStrengthOfALightAloneToo) {
  measure({});
  gap::WhereResult where;
  where.rows.push_back({.measurand = "intensity", .covariate = "azimuth_deg", .low = -6.0, .high = 4.0});
  const auto forms = gap::hypothesesFor(*replay_, {"blinding"});
  const gap::Hypothesis blinding = test_support::hypothesisNamed(forms, "blinding", "desensitised");
  ASSERT_EQ(blinding.parameters[1].name, "irradiance");
  ASSERT_EQ(blinding.parameters[3].name, "gain_loss");
  double largest_loss = 0.0;
  for (const auto& start : gap::startsFrom(*replay_, blinding, where)) {
    EXPECT_DOUBLE_EQ(start[0], -1.0);  // azimuth_deg
    if (start[1] < 5.0) largest_loss = std::max(largest_loss, start[3]);
  }
  EXPECT_GT(largest_loss, 0.5);
}

// A cloud returns echoes, as the model has it; one column of beams elsewhere sees a false target.
TEST_F(Starts, LooksForAFalseTargetWhereTheModelExpectsNoEcho) {
  const SmallWorld::Effects cloud = {{"exhaust-cloud", {{"centre", {4.0, -0.7, 0.0}}, {"size_m", 1.5}}}};
  SmallWorld::Effects truth = cloud;
  truth["spoofing"] = {{"azimuth_deg", 5.0}, {"width_deg", 0.8}, {"range_m", 5.0}};
  measured_ = world_.measuredBy(SmallWorld::modelWith(truth), 0.4);
  replay_.emplace(measured_, SmallWorld::modelWith(cloud));
  split_ = gap::splitOf(*replay_, 1);
  const auto where = gap::whereIn(*replay_, replay_->baseline(), 1);
  const auto starts = gap::startsFrom(*replay_, effect("spoofing"), where);
  ASSERT_FALSE(starts.empty());
  EXPECT_NEAR(starts.back()[0], 5.0, 0.4);  // azimuth_deg
  EXPECT_NEAR(starts.back()[1], 5.0, 0.1);  // range_m
  EXPECT_NEAR(starts.back()[2], 1.0, 0.3);  // width_deg, of one beam
}

}  // namespace
