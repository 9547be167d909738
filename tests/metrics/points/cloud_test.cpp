#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limits>

#include "core/error.h"
#include "metrics/points/cloud_to_cloud.h"
#include "metrics/points/extent.h"
#include "metrics/points/hausdorff.h"
#include "metrics/points/nearest_points.h"
#include "tests/metrics/points/random_clouds.h"

namespace {

using metrics::BoundingBoxError;
using metrics::CloudPair;
using metrics::Hausdorff;
using metrics::Position;
using metrics_test::Cloud;
using metrics_test::RandomClouds;
using metrics_test::repeated;
using metrics_test::shifted;

double hausdorffDistance(const Cloud& a, const Cloud& b) {
  return metrics::hausdorff({.simulated = a, .measured = b}).distance();
}

TEST(NearestDistances, AreTheLeastOfAllPairs) {
  RandomClouds cases(20);
  for (int k = 0; k < 50; ++k) {
    const Cloud from = cases.anySize(60);
    Cloud to = cases.anySize(60);
    if (k % 2 == 0) to = repeated(to, 3);  // equal points: more than fit into one leaf
    const std::vector<double> nearest = metrics::nearestDistances(from, to);
    for (std::size_t i = 0; i < from.size(); ++i) {
      double least = std::numeric_limits<double>::infinity();
      for (const Position& p : to) least = std::min(least, distance(from[i], p));
      EXPECT_DOUBLE_EQ(nearest[i], least);
    }
  }
}

TEST(Hausdorff, IsTheDistanceOfTheOutlier) {
  const Cloud measured{{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}};
  const Cloud simulated{{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {1.0, 3.0, 4.0}};
  const Hausdorff farthest = metrics::hausdorff({.simulated = simulated, .measured = measured});
  EXPECT_EQ(farthest.of_simulated, 5.0);
  EXPECT_EQ(farthest.of_measured, 0.0);
  EXPECT_EQ(farthest.distance(), 5.0);
}

TEST(Hausdorff, IsAMetricOnFiniteSets) {
  RandomClouds cases(21);
  for (int k = 0; k < 300; ++k) {
    const Cloud a = cases.anySize(9);
    const Cloud b = cases.anySize(9);
    const Cloud c = cases.anySize(9);
    EXPECT_EQ(hausdorffDistance(a, repeated(a, 2)), 0.0);
    EXPECT_EQ(hausdorffDistance(a, b), hausdorffDistance(b, a));
    EXPECT_LE(hausdorffDistance(a, c), hausdorffDistance(a, b) + hausdorffDistance(b, c) + 1e-12);
  }
}

TEST(CloudToCloud, SumGrowsWithTheNumberOfPointsAndTheMeanDoesNot) {
  RandomClouds cases(22);
  const Cloud a = cases.cloud(10);
  const Cloud b = cases.cloud(6);
  const metrics::CloudToCloud once = metrics::cloudToCloud({.simulated = a, .measured = b});
  const Cloud many = repeated(a, 4);
  const metrics::CloudToCloud four_times = metrics::cloudToCloud({.simulated = many, .measured = b});
  EXPECT_NEAR(four_times.sum_of_simulated, 4.0 * once.sum_of_simulated, 1e-12);
  EXPECT_NEAR(four_times.mean_of_simulated, once.mean_of_simulated, 1e-13);
  EXPECT_NEAR(four_times.sum_of_measured, once.sum_of_measured, 1e-13);
}

TEST(CloudToCloud, MeanIsAtMostTheDirectedHausdorffDistance) {
  RandomClouds cases(23);
  for (int k = 0; k < 100; ++k) {
    const Cloud a = cases.anySize(20);
    const Cloud b = cases.anySize(20);
    const CloudPair clouds{.simulated = a, .measured = b};
    EXPECT_LE(metrics::cloudToCloud(clouds).mean_of_simulated, metrics::hausdorff(clouds).of_simulated + 1e-12);
    EXPECT_LE(metrics::cloudToCloud(clouds).mean_of_measured, metrics::hausdorff(clouds).of_measured + 1e-12);
  }
}

TEST(CentreOfGravityDistance, OfAShiftIsItsLength) {
  RandomClouds cases(24);
  const Cloud cloud = cases.cloud(50);
  const Cloud moved = shifted(cloud, {2.0, -3.0, 6.0});
  EXPECT_NEAR(metrics::centreOfGravityDistance({.simulated = moved, .measured = cloud}), 7.0, 1e-12);
}

TEST(CentreOfGravityDistance, IsBlindToShape) {
  const Cloud narrow{{-1.0, 0.0, 0.0}, {1.0, 0.0, 0.0}};
  const Cloud wide{{-5.0, 0.0, 0.0}, {0.0, 2.0, 0.0}, {0.0, -2.0, 0.0}, {5.0, 0.0, 0.0}};
  EXPECT_EQ(metrics::centreOfGravityDistance({.simulated = narrow, .measured = wide}), 0.0);
}

// Measured: the unit cube at the origin's corner. Simulated: [-1, 2] x [0, 1] x [0.5, 1.5].
TEST(BoundingBoxError, TellsSizeFromPlace) {
  const Cloud measured{{0.0, 0.0, 0.0}, {1.0, 1.0, 1.0}, {0.5, 0.5, 0.5}};
  const Cloud simulated{{-1.0, 0.0, 0.5}, {2.0, 1.0, 1.5}};
  const BoundingBoxError error = metrics::boundingBoxError({.simulated = simulated, .measured = measured});
  EXPECT_EQ(error.size.x_m, 2.0);
  EXPECT_EQ(error.size.y_m, 0.0);
  EXPECT_EQ(error.size.z_m, 0.0);
  EXPECT_EQ(error.centre.x_m, 0.0);
  EXPECT_EQ(error.centre.y_m, 0.0);
  EXPECT_EQ(error.centre.z_m, 0.5);
  EXPECT_EQ(error.face, 1.0);
}

TEST(BoundingBoxError, ChangesSignWithTheSidesAndObeysTheTriangle) {
  RandomClouds cases(25);
  for (int k = 0; k < 100; ++k) {
    const Cloud a = cases.anySize(9);
    const Cloud b = cases.anySize(9);
    const Cloud c = cases.anySize(9);
    const BoundingBoxError there = metrics::boundingBoxError({.simulated = a, .measured = b});
    const BoundingBoxError back = metrics::boundingBoxError({.simulated = b, .measured = a});
    EXPECT_EQ(there.size.x_m, -back.size.x_m);
    EXPECT_EQ(there.centre.z_m, -back.centre.z_m);
    EXPECT_EQ(there.face, back.face);
    const double around = there.face + metrics::boundingBoxError({.simulated = b, .measured = c}).face;
    EXPECT_LE(metrics::boundingBoxError({.simulated = a, .measured = c}).face, around + 1e-12);
  }
}

TEST(PointCountRatio, CountsAndIsUndefinedWithoutMeasurement) {
  const Cloud three(3);
  const Cloud two(2);
  EXPECT_EQ(metrics::pointCountRatio({.simulated = three, .measured = two}), 1.5);
  EXPECT_EQ(metrics::pointCountRatio({.simulated = {}, .measured = two}), 0.0);
  EXPECT_TRUE(std::isnan(metrics::pointCountRatio({.simulated = three, .measured = {}})));
}

TEST(CloudPair, NamesTheRowThatIsNotFinite) {
  const Cloud good(4);
  Cloud bad(4);
  bad[2].y_m = std::nan("");
  try {
    (void)metrics::hausdorff({.simulated = good, .measured = bad});
    FAIL() << "took NaN";
  } catch (const core::InputError& error) {
    EXPECT_EQ(error.place().item, "measured point 3");
  }
}

TEST(CloudPair, RefusesAnEmptySide) {
  const Cloud one(1);
  EXPECT_THROW((void)metrics::hausdorff({.simulated = one, .measured = {}}), core::InputError);
  EXPECT_THROW((void)metrics::boundingBoxError({.simulated = {}, .measured = one}), core::InputError);
  EXPECT_THROW((void)metrics::centreOfGravityDistance({.simulated = {}, .measured = {}}), core::InputError);
}

}  // namespace
