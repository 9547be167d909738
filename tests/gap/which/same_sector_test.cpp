#include "gap/which/same_sector.h"

#include <gtest/gtest.h>
#include <string>
#include <utility>

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

TEST(SameSector, WhatActsInNoSectorMovesNothing) {
  EXPECT_TRUE(gap::inSectorOf(kOffset, {dirt({0.3, -4.0, 10.0})}).empty());
}

}  // namespace
