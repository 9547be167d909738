#include "objects/segments.h"

#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <numeric>

#include "core/random.h"

namespace {

using objects::clustersOf;
using objects::Nearness;
using objects::Vector3;
using testing::ElementsAre;

std::vector<std::size_t> allOf(const std::vector<Vector3>& points) {
  std::vector<std::size_t> all(points.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  return all;
}

constexpr Nearness kFixed{.distance_m = 1.0, .distance_per_range = 0.0, .vertical_weight = 1.0};

TEST(Segments, ChainsHoldTogetherAndGapsPart) {
  const std::vector<Vector3> points{{5, 0, 0}, {9, 0, 0}, {5, 0.9, 0}, {9, 0.9, 0}, {5, 1.8, 0}, {5, 2.9, 0}};
  EXPECT_THAT(clustersOf(points, allOf(points), kFixed),
              ElementsAre(ElementsAre(0, 2, 4), ElementsAre(1, 3), ElementsAre(5)));
}

// Two points 1.5 m apart: at 10 m of range the reach is 0.5 + 0.2 = 0.7 m, at 60 m it is 1.7 m.
TEST(Segments, TheDistanceGrowsWithRange) {
  const Nearness nearness{.distance_m = 0.5, .distance_per_range = 0.02, .vertical_weight = 1.0};
  EXPECT_EQ(clustersOf(std::vector<Vector3>{{10, 0, 0}, {10, 1.5, 0}}, std::vector<std::size_t>{0, 1}, nearness).size(),
            2u);
  EXPECT_EQ(clustersOf(std::vector<Vector3>{{60, 0, 0}, {60, 1.5, 0}}, std::vector<std::size_t>{0, 1}, nearness).size(),
            1u);
}

TEST(Segments, HeightsCountLess) {
  const std::vector<Vector3> points{{5, 0, 0}, {5, 0, 3.0}};
  EXPECT_EQ(clustersOf(points, allOf(points), kFixed).size(), 2u);
  EXPECT_EQ(
      clustersOf(points, allOf(points), {.distance_m = 1.0, .distance_per_range = 0.0, .vertical_weight = 0.25}).size(),
      1u);
}

TEST(Segments, OnlyTheNamedPointsTakePart) {
  const std::vector<Vector3> points{{5, 0, 0}, {5, 0.9, 0}, {5, 1.8, 0}};
  EXPECT_THAT(clustersOf(points, std::vector<std::size_t>{0, 2}, kFixed), ElementsAre(ElementsAre(0), ElementsAre(2)));
  EXPECT_TRUE(clustersOf(points, {}, kFixed).empty());
}

// The rule written down as it stands, every pair tried: an independent slow implementation.
TEST(Segments, AgreeWithTryingEveryPair) {
  const Nearness nearness;
  core::Random random({.seed = 11});
  std::vector<Vector3> points;
  for (int i = 0; i < 400; ++i) {
    points.push_back({60 * random.uniform(), 40 * random.uniform() - 20, 4 * random.uniform() - 2});
  }
  std::vector<std::size_t> label = allOf(points);
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t i = 0; i < points.size(); ++i) {
      for (std::size_t j = 0; j < points.size(); ++j) {
        const Vector3 &a = points[i], &b = points[j];
        const double range = std::max(std::hypot(a[0], a[1], a[2]), std::hypot(b[0], b[1], b[2]));
        const double apart = std::hypot(a[0] - b[0], a[1] - b[1], 0.25 * (a[2] - b[2]));
        if (apart < 0.5 + 0.02 * range && label[j] < label[i]) {
          label[i] = label[j];
          changed = true;
        }
      }
    }
  }
  const auto clusters = clustersOf(points, allOf(points), nearness);
  std::vector<std::size_t> found(points.size());
  for (const auto& cluster : clusters) {
    for (const std::size_t i : cluster) found[i] = cluster.front();
  }
  EXPECT_EQ(found, label);
  EXPECT_GT(clusters.size(), 10u);
  EXPECT_LT(clusters.size(), 390u);
}

}  // namespace
