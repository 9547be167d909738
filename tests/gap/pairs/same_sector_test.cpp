#include "gap/pairs/same_sector.h"

#include <gtest/gtest.h>
#include <string>
#include <utility>

#include "gap/far/how_far.h"
#include "tests/gap/hypothesis_named.h"
#include "tests/gap/small_world.h"

namespace {

gap::FreeParameter number(const std::string& name, double low, double high) {
  gap::FreeParameter parameter;
  parameter.name = name;
  parameter.low = low;
  parameter.high = high;
  return parameter;
}

gap::Candidate cause(const std::string& name, std::vector<gap::FreeParameter> parameters, std::vector<double> values) {
  gap::Candidate candidate;
  candidate.hypothesis.name = name;
  candidate.hypothesis.parameters = std::move(parameters);
  candidate.values = std::move(values);
  return candidate;
}

gap::Candidate dirt(std::vector<double> values) {
  return cause("cover-contamination",
               {number("attenuation", 0.0, 1.0), number("azimuth_from_deg", -180.0, 180.0),
                number("azimuth_to_deg", -180.0, 180.0)},
               std::move(values));
}

gap::Candidate light(std::vector<double> values) {
  return cause(
      "blinding",
      {number("azimuth_deg", -180.0, 180.0), number("irradiance", 0.1, 1000.0), number("width_deg", 0.01, 360.0)},
      std::move(values));
}

const gap::Candidate kOffset = cause("range-offset", {number("offset_m", -0.5, 0.5)}, {0.1});

TEST(SameSector, EndsBecomeAMiddleAndAWidthAndStrengthsStay) {
  const auto moved = gap::inSectorOf(dirt({0.3, -4.0, 10.0}), {kOffset, light({50.0, 2.0, 1.0})});
  ASSERT_EQ(moved.size(), 1U);
  EXPECT_EQ(moved.front().hypothesis.name, "blinding");
  EXPECT_EQ(moved.front().values, (std::vector<double>{3.0, 2.0, 14.0}));
}

TEST(SameSector, AMiddleAndAWidthBecomeEnds) {
  const auto moved = gap::inSectorOf(light({3.0, 2.0, 14.0}), {dirt({0.3, 100.0, 120.0})});
  ASSERT_EQ(moved.size(), 1U);
  EXPECT_EQ(moved.front().values, (std::vector<double>{0.3, -4.0, 10.0}));
}

TEST(SameSector, StaysInThePlausibleRange) {
  const auto moved = gap::inSectorOf(light({175.0, 2.0, 20.0}), {dirt({0.3, 0.0, 1.0})});
  ASSERT_EQ(moved.size(), 1U);
  EXPECT_EQ(moved.front().values, (std::vector<double>{0.3, 165.0, 180.0}));
}

// Another form of the same cause was fitted by itself, and what holds on another sensor is in other data.
TEST(SameSector, NeitherFormsOfTheSameCauseNorCausesOfOtherSensorsAreMoved) {
  gap::Candidate of_left = light({50.0, 2.0, 1.0});
  of_left.hypothesis.sensors = {"left"};
  EXPECT_TRUE(gap::inSectorOf(dirt({0.3, -4.0, 10.0}), {dirt({0.1, 0.0, 1.0}), of_left}).empty());
}

// Dirt that takes 0.4 of the light each way leaves as much as a receiver that lost 0.64 of its gain. That one had been
// fitted a beam too wide at either end.
TEST(SameSector, ACauseIsKeptInTheBestOnesSectorWhereItIsNearerToTheData) {
  const test_support::SmallWorld world;
  const auto modelWith = test_support::SmallWorld::modelWith;
  const model::Experiment measured = world.measuredBy(
      modelWith({{"cover-contamination", {{"attenuation", 0.4}, {"azimuth_from_deg", 5.5}, {"azimuth_to_deg", 8.5}}}},
                {}),
      0.4);
  const gap::Replay replay(measured, modelWith({}, {}));
  const gap::Split split = gap::splitOf(replay, 1);
  const gap::Judge judge{replay, split, gap::yardstickOf(replay, split.held_out)};
  const gap::HeldOutGaps gaps(replay, split.held_out.samples, 1);
  const auto all = gap::hypothesesFor(replay, {"cover-contamination", "blinding", "range-offset"});
  std::vector<gap::Candidate> singles{
      {test_support::hypothesisNamed(all, "cover-contamination"), {0.4, 5.5, 8.5}},
      {test_support::hypothesisNamed(all, "blinding", "desensitised"), {7.0, 0.1, 5.0, 0.64}},
      {test_support::hypothesisNamed(all, "range-offset"), {0.01}}};
  for (gap::Candidate& single : singles) judge.hear(single);
  gap::shareTheSector(judge, gaps, gap::whereIn(replay, replay.baseline(), 1), singles, core::SilentProgress());
  ASSERT_EQ(singles[1].hypothesis.name, "blinding");
  EXPECT_NEAR(singles[1].values[2], 3.0, 1.0);  // between the beams beside, which are a degree apart
  EXPECT_EQ(singles[2].values, std::vector<double>{0.01});
}

TEST(SameSector, WhatActsInNoSectorMovesNothing) {
  EXPECT_TRUE(gap::inSectorOf(kOffset, {dirt({0.3, -4.0, 10.0})}).empty());
}

}  // namespace
