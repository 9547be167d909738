#include "model/geometry/second_ways.h"

#include <cmath>
#include <gtest/gtest.h>

namespace model {
namespace {

SceneObject wallAt(const std::string& id, double x_m) {
  SceneObject wall;
  wall.id = id;
  wall.shape = Rectangle{40.0, 40.0};
  wall.pose.position_m = {x_m, 0.0, 0.0};
  return wall;
}

/// A pane 2 m ahead that mirrors as well, a wall 5 m ahead, and one 3 m behind the sensor.
Scene paneBetweenWalls() {
  Scene scene;
  scene.objects = {wallAt("pane", 2.0), wallAt("ahead", 5.0), wallAt("behind", -3.0)};
  return scene;
}

Ray rayAt(double angle_rad) { return {{}, {std::cos(angle_rad), std::sin(angle_rad), 0.0}, 0.0}; }

// More rays than a packet holds: each has its own ways, as long as the plane equations say, in the order in which the
// rays began. A step of 0.1 mm leads off the pane.
TEST(WaysOn, OfManyRaysAtOnceAreThoseOfEachAlone) {
  const Scene scene = paneBetweenWalls();
  const RayTracer tracer(scene);
  const SecondWays rules{1, {true, false, false}, {true, false, false}};
  WaysOn ways(tracer, rules);
  EXPECT_TRUE(ways.leadFrom(0));
  EXPECT_FALSE(ways.leadFrom(1));
  constexpr std::uint32_t kRays = 21;
  const auto angleOf = [](std::uint32_t ray) { return 0.05 * (static_cast<double>(ray) - 10.0); };
  for (std::uint32_t r = 0; r < kRays; ++r) {
    const Ray ray = rayAt(angleOf(r));
    RayHit met;
    tracer.trace(std::span(&ray, 1), std::span(&met, 1));
    ASSERT_EQ(met.object, 0);
    ways.begin(ray, met, r);
  }
  std::vector<SecondHit> hits;
  ways.finish(hits);
  ASSERT_EQ(hits.size(), 2U * kRays);
  for (std::uint32_t r = 0; r < kRays; ++r) {
    const double cosine = std::cos(angleOf(r));
    const SecondHit &back = hits[2 * r], &on = hits[2 * r + 1];
    EXPECT_TRUE(back.turns[0].mirrored);
    EXPECT_EQ(back.hit.object, 2);
    EXPECT_NEAR(back.hit.range_m, (2.0 + 5.0) / cosine, 1e-9);
    EXPECT_FALSE(on.turns[0].mirrored);
    EXPECT_EQ(on.hit.object, 1);
    EXPECT_NEAR(on.hit.range_m, 5.0 / cosine, 1e-9);
    for (const SecondHit& hit : {back, on}) {
      EXPECT_EQ(hit.hit.ray, r);
      EXPECT_EQ(hit.turn_count, 1U);
      EXPECT_NEAR(hit.hit.cos_incidence, cosine, 1e-6);
    }
  }
}

// The wall behind mirrors, too: straight on and once reflected, then by both mirrors through the pane to the wall
// ahead.
TEST(WaysOn, EndAfterAsManyTurnsAsTheyMayHave) {
  const Scene scene = paneBetweenWalls();
  const RayTracer tracer(scene);
  const auto lengths = [&](std::size_t most_turns) {
    const SecondWays rules{most_turns, {true, false, false}, {true, false, true}};
    WaysOn ways(tracer, rules);
    const Ray ray = rayAt(0.0);
    RayHit met;
    tracer.trace(std::span(&ray, 1), std::span(&met, 1));
    ways.begin(ray, met, 0);
    std::vector<SecondHit> hits;
    ways.finish(hits);
    std::vector<double> ranges_m;
    for (const SecondHit& hit : hits) ranges_m.push_back(std::round(1e6 * hit.hit.range_m) / 1e6);
    return ranges_m;
  };
  EXPECT_TRUE(lengths(0).empty());
  EXPECT_EQ(lengths(1), (std::vector<double>{7.0, 5.0}));
  EXPECT_EQ(lengths(2), (std::vector<double>{7.0, 12.0, 5.0}));
  EXPECT_EQ(lengths(3), (std::vector<double>{7.0, 12.0, 17.0, 15.0, 5.0}));
}

}  // namespace
}  // namespace model
