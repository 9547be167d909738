#include "metrics/points/point_wasserstein.h"

#include <cmath>
#include <gtest/gtest.h>

#include "core/error.h"
#include "core/parallel.h"
#include "metrics/samples/wasserstein.h"
#include "tests/metrics/points/random_clouds.h"

namespace {

using metrics::pointWassersteinDistance;
using metrics::Position;
using metrics::slicedWassersteinDistance;
using metrics::Slices;
using metrics_test::Cloud;
using metrics_test::RandomClouds;
using metrics_test::repeated;
using metrics_test::shifted;

double exact(const Cloud& simulated, const Cloud& measured, double order = 1.0) {
  return pointWassersteinDistance({.simulated = simulated, .measured = measured}, order);
}

double sliced(const Cloud& simulated, const Cloud& measured, double order = 1.0, const Slices& slices = {}) {
  return slicedWassersteinDistance({.simulated = simulated, .measured = measured}, order, slices);
}

TEST(PointWasserstein, OfAShiftIsItsLength) {
  RandomClouds cases(10);
  for (int k = 0; k < 50; ++k) {
    const Cloud cloud = cases.anySize(20);
    const Position by = cases.position();
    const double length = metrics::distance(by, {});
    EXPECT_NEAR(exact(shifted(cloud, by), cloud, 1.0), length, 1e-12);
    EXPECT_NEAR(exact(shifted(cloud, by), cloud, 2.0), length, 1e-12);
  }
}

TEST(PointWasserstein, OnALineIsTheDistanceOfSamples) {
  RandomClouds cases(11);
  for (int k = 0; k < 100; ++k) {
    Cloud clouds[2] = {cases.anySize(15), cases.anySize(15)};
    std::vector<double> values[2];
    for (int side : {0, 1}) {
      for (Position& p : clouds[side]) {
        p.y_m = p.z_m = 0.5;
        values[side].push_back(p.x_m);
      }
    }
    const double expected =
        metrics::wassersteinDistance({.simulated = metrics::Edf(values[0]), .measured = metrics::Edf(values[1])});
    EXPECT_NEAR(exact(clouds[0], clouds[1]), expected, 1e-12);
  }
}

TEST(PointWasserstein, IsAMetricOnClouds) {
  RandomClouds cases(12);
  for (int k = 0; k < 200; ++k) {
    const Cloud a = cases.anySize(7);
    const Cloud b = cases.anySize(7);
    const Cloud c = cases.anySize(7);
    for (const double order : {1.0, 2.0}) {
      EXPECT_EQ(exact(a, a, order), 0.0);
      EXPECT_NEAR(exact(a, b, order), exact(b, a, order), 1e-12);
      EXPECT_LE(exact(a, c, order), exact(a, b, order) + exact(b, c, order) + 1e-12);
    }
  }
}

TEST(PointWasserstein, DoesNotSeeRepetition) {
  RandomClouds cases(13);
  for (int k = 0; k < 50; ++k) {
    const Cloud a = cases.anySize(8);
    const Cloud b = cases.anySize(8);
    EXPECT_NEAR(exact(repeated(a, 3), b), exact(a, b), 1e-12);
    EXPECT_NEAR(exact(a, repeated(b, 2)), exact(a, b), 1e-12);
  }
}

// All mass of a point must go to every measured point alike, so the plan has no choice.
TEST(PointWasserstein, OfOnePointIsTheMeanPowerOfItsDistances) {
  const Cloud origin{{0.0, 0.0, 0.0}};
  const Cloud others{{3.0, 4.0, 0.0}, {0.0, 0.0, 1.0}};
  EXPECT_NEAR(exact(origin, others, 1.0), 3.0, 1e-15);
  EXPECT_NEAR(exact(origin, others, 2.0), std::sqrt(13.0), 1e-15);
}

TEST(PointWasserstein, RefusesWhatItCannotDoExactly) {
  const Cloud one(1);
  const Cloud many(metrics::kMostPointsOfExactWasserstein + 1);
  EXPECT_THROW(exact(many, one), core::InputError);
  EXPECT_THROW(exact(one, many), core::InputError);
  EXPECT_THROW(exact(one, one, 0.5), core::InputError);
  EXPECT_THROW(exact(one, one, std::nan("")), core::InputError);
  EXPECT_NO_THROW((void)sliced(many, one));
  EXPECT_THROW(sliced(one, one, 1.0, {.lines = 0}), core::InputError);
}

// |u . d| of a uniform direction is uniform on (0, |d|): mean |d|/2, variance |d|^2/12; its square has the mean |d|^2/3
// and the variance 4/45 |d|^4. Tolerance: 4 standard errors of 4000 lines.
TEST(SlicedWasserstein, OfAShiftIsTheMeanProjection) {
  RandomClouds cases(14);
  const Cloud cloud = cases.cloud(5);
  const Position by{2.0, -1.0, 2.0};
  const Slices slices{.lines = 4000, .seed = 5};
  EXPECT_NEAR(sliced(shifted(cloud, by), cloud, 1.0, slices), 1.5, 4.0 * 3.0 / std::sqrt(12.0 * 4000.0));
  EXPECT_NEAR(std::pow(sliced(shifted(cloud, by), cloud, 2.0, slices), 2.0), 3.0,
              4.0 * 9.0 * std::sqrt(4.0 / 45.0 / 4000.0));
}

TEST(SlicedWasserstein, NeverExceedsTheExactDistance) {
  RandomClouds cases(15);
  for (int k = 0; k < 50; ++k) {
    const Cloud a = cases.anySize(12);
    const Cloud b = cases.anySize(12);
    for (const double order : {1.0, 2.0}) EXPECT_LE(sliced(a, b, order), exact(a, b, order) + 1e-12);
  }
}

TEST(SlicedWasserstein, IsTheSameForAnyNumberOfThreads) {
  RandomClouds cases(16);
  const Cloud a = cases.cloud(50);
  const Cloud b = cases.cloud(31);
  core::limitThreads(1);
  const double alone = sliced(a, b);
  core::limitThreads(0);
  EXPECT_EQ(sliced(a, b), alone);
  EXPECT_NE(sliced(a, b, 1.0, {.seed = 2}), alone);
}

}  // namespace
