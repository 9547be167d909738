#include "gap/replay/comb.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "core/random.h"

// The step of a counter, read from the values that it reports.
namespace {

constexpr double kRounding_m = 0.001;

double rounded(double value, double step) { return step * std::round(value / step); }

/// Ranges from 4 to 24 m, as a counter of this step tells them, written down in steps of 2 mm, or of twice
/// `rounding_m`.
std::vector<double> ranges(double step_m, double rounding_m = kRounding_m) {
  core::Random random({.seed = 7});
  std::vector<double> values;
  for (int i = 0; i < 400; ++i) {
    const double range_m = 4.0 + 20.0 * random.uniform();
    const double counted_m = step_m > 0.0 ? rounded(range_m, step_m) : range_m;
    values.push_back(rounding_m > 0.0 ? rounded(counted_m, 2.0 * rounding_m) : counted_m);
  }
  return values;
}

// The smallest distance of two would be 0.010 m, which puts a range of 24 m onto the 400th multiple beside it.
TEST(Comb, TellsTheStepFromAllValuesThoughTheyAreRounded) {
  const auto comb = gap::combOf(ranges(0.0117), kRounding_m);
  ASSERT_TRUE(comb && comb->shown());
  EXPECT_NEAR(comb->step, 0.0117, comb->uncertain);
  EXPECT_LT(comb->uncertain, 5e-6);
}

// Multiples of 0.0419 m in steps of 0.02 m: 0.04, 0.08, 0.12, 0.16 or 0.18, ...
TEST(Comb, TellsAStepThatTheProfilesOwnStepsBlur) {
  const auto comb = gap::combOf(ranges(0.0419, 0.01), 0.01);
  ASSERT_TRUE(comb && comb->shown());
  EXPECT_NEAR(comb->step, 0.0419, comb->uncertain);
}

// Eight targets, three steps of 0.0482 m each: too few to be aligned by more than chance, but none lies between.
TEST(Comb, TellsAStepFromFewValuesOfWhichNoneLiesBetween) {
  std::vector<double> values;
  for (const int first : {178, 229, 271, 366, 455, 556, 650, 811})
    for (int step = 0; step < 3; ++step) values.push_back(rounded(0.0482 * (first + step), 0.02));
  const auto comb = gap::combOf(values, 0.01);
  ASSERT_TRUE(comb && comb->shown());
  EXPECT_NEAR(comb->step, 0.0482, 2.0 * comb->uncertain);
}

// A target 58.4 m away is the 218th step: 0.0003 m more a step would put it 0.065 m beside where it is told.
TEST(Comb, KnowsTheStepAsWellAsTheFarthestValueTellsIt) {
  std::vector<double> values;
  for (const int first : {25, 30, 39, 47, 54, 70, 84, 103, 130, 153, 176, 218})
    for (int step = 0; step < 2; ++step) values.push_back(rounded(0.268 * (first + step), 0.005));
  const auto comb = gap::combOf(values, 0.0025);
  ASSERT_TRUE(comb && comb->shown());
  EXPECT_NEAR(comb->step, 0.268, comb->uncertain);
  EXPECT_LE(comb->uncertain, 0.0025 / 218.0);
}

TEST(Comb, SeesNoneInFewValuesWhoseRoundingLeavesRoomForManyCombs) {
  core::Random random({.seed = 11});
  std::vector<double> values{4.0};
  for (int i = 0; i < 14; ++i) values.push_back(rounded(values.back() + 0.04 + 0.06 * random.uniform(), 0.02));
  EXPECT_FALSE(gap::combOf(values, 0.01));
}

TEST(Comb, SeesNoneInValuesThatAreOnlyRounded) { EXPECT_FALSE(gap::combOf(ranges(0.0), kRounding_m)); }

TEST(Comb, SeesNoneInFewValuesThatHappenToLieApart) {
  EXPECT_FALSE(gap::combOf({3.0, 3.1, 3.2, 3.3}, kRounding_m));
  EXPECT_FALSE(
      gap::combOf({3.004, 3.116, 3.25, 3.402, 3.506, 3.632, 3.78, 3.894, 4.038, 4.152, 4.3, 4.426}, kRounding_m));
}

// Nine walls that a counter of 0.771 m tells in steps of 0.0375 m: seven others in a thousand lie as well on some comb.
TEST(Comb, SuggestsAStepWhereTheValuesAreTooFewToShowIt) {
  std::vector<double> values;
  for (const int steps : {7, 8, 10, 12, 15, 20, 27, 34, 46}) values.push_back(rounded(0.771 * steps, 0.0375));
  const auto comb = gap::combOf(values, 0.01875);
  ASSERT_TRUE(comb);
  EXPECT_FALSE(comb->shown());
  EXPECT_NEAR(comb->step, 0.771, comb->uncertain);
  EXPECT_LT(comb->uncertain, 0.001);
}

TEST(Comb, SeesNoneInNothing) { EXPECT_FALSE(gap::combOf({}, kRounding_m)); }

TEST(Comb, KnowsMultiplesOfAStepFromOtherValues) {
  EXPECT_TRUE(gap::lieOnSteps(ranges(0.0419, 0.01), 0.02));
  EXPECT_FALSE(gap::lieOnSteps(ranges(0.0419, 0.0), 0.02));
  EXPECT_TRUE(gap::lieOnSteps(ranges(0.0419, 0.0), 0.0));
  EXPECT_TRUE(gap::lieOnSteps({}, 0.02));
}

/// Mean of what a counter tells of a range under normal noise: each of its steps with the probability of it.
double meanTold(double range, double step, double noise) {
  const auto below = [&](double edge) { return 0.5 * std::erfc((range - edge) / (noise * std::sqrt(2.0))); };
  const double first = std::floor((range - 9.0 * noise) / step), last = std::ceil((range + 9.0 * noise) / step);
  double mean = 0.0;
  for (double n = first; n <= last; n += 1.0) mean += n * step * (below((n + 0.5) * step) - below((n - 0.5) * step));
  return mean;
}

/// Mean square of how far a target's normal move takes that mean, wherever in a step it stands.
double meanSquareTold(double step, double moved, double noise) {
  constexpr int kPlaces = 200000;
  core::Random random({.seed = 3});
  double sum = 0.0;
  for (int i = 0; i < kPlaces; ++i) {
    const double range = 40.0 * step + step * random.uniform();
    const double by = meanTold(range + moved * random.normal(), step, noise) - meanTold(range, step, noise);
    sum += by * by / kPlaces;
  }
  return sum;
}

TEST(Comb, AMoveOfTheTargetTakesTheMeanOfItsValuesToTheNextStepNowAndThen) {
  constexpr double kStep_m = 0.2, kMoved_m = 0.003;
  EXPECT_NEAR(gap::jumpVariance(kStep_m, kMoved_m, 0.0), kStep_m * kMoved_m * std::sqrt(2.0 / std::numbers::pi), 1e-9);
  for (const double noise_m : {1e-4, 0.001, 0.003, 0.01, 0.03}) {
    const double told = meanSquareTold(kStep_m, kMoved_m, noise_m);
    EXPECT_NEAR(gap::jumpVariance(kStep_m, kMoved_m, noise_m) / told, 1.0, 0.08) << noise_m;
  }
  EXPECT_EQ(gap::jumpVariance(kStep_m, 0.0, 0.01), 0.0);
}

}  // namespace
