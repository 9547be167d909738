#include "objects/tracking.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace {

using objects::Feature;
using objects::Tracker;
using objects::Tracking;
using testing::ElementsAre;
using testing::Pair;

Feature at(double x, double y, std::string object = "") {
  return {.box = {.centre_m = {x, y, 0}}, .detections = 5, .object = std::move(object)};
}

std::vector<int> idsOf(const std::vector<objects::TrackedObject>& list) {
  std::vector<int> ids;
  for (const auto& object : list) ids.push_back(object.id);
  return ids;
}

// By hand: 0.2, 0.4, 0.6, 0.8, 1.0, 1.0; listed from 0.5 on, hence in the third frame.
TEST(Existence, GrowsByTwoTenthsUntilItIsCertain) {
  Tracker tracker{{}};
  const double expected[] = {0.2, 0.4, 0.6, 0.8, 1.0, 1.0, 1.0};
  for (int frame = 0; frame < 7; ++frame) {
    tracker.step(std::vector{at(10, 0)});
    ASSERT_EQ(tracker.all().size(), 1u);
    EXPECT_NEAR(tracker.all()[0].existence, expected[frame], 1e-12) << frame;
    EXPECT_EQ(tracker.listed().size(), frame >= 2 ? 1u : 0u) << frame;
    EXPECT_EQ(tracker.all()[0].age, frame + 1);
  }
}

// By hand: from 1, nine frames without it leave 1 - 9·0.055 = 0.505, ten leave 0.45; 1/0.055 = 18.2, so the 19th
// forgets it, and who comes back is a new object.
TEST(Existence, FadesAndIsForgotten) {
  Tracker tracker{{}};
  for (int frame = 0; frame < 5; ++frame) tracker.step(std::vector{at(10, 0)});
  for (int gone = 1; gone <= 19; ++gone) {
    tracker.step({});
    if (gone < 19) {
      ASSERT_EQ(tracker.all().size(), 1u) << gone;
      EXPECT_NEAR(tracker.all()[0].existence, 1.0 - gone * 0.055, 1e-12);
      EXPECT_FALSE(tracker.all()[0].seen);
    }
    EXPECT_EQ(tracker.listed().size(), gone <= 9 ? 1u : 0u) << gone;
  }
  EXPECT_TRUE(tracker.all().empty());
  tracker.step(std::vector{at(10, 0)});
  EXPECT_EQ(tracker.all()[0].id, 2);
}

// 0.25 twice is the threshold itself: reached.
TEST(Existence, TheThresholdItselfIsEnough) {
  Tracker tracker{{.increment = 0.25}};
  tracker.step(std::vector{at(10, 0)});
  EXPECT_TRUE(tracker.listed().empty());
  tracker.step(std::vector{at(10, 0)});
  EXPECT_EQ(tracker.listed().size(), 1u);
}

TEST(Tracking, ObjectsKeepTheirIdsAsTheyMove) {
  Tracker tracker{{}};
  for (int frame = 0; frame < 6; ++frame) {
    // Two cars that pass each other on two lanes, named in changing order.
    const Feature there = at(10 + 2.0 * frame, 2), back = at(20 - 2.0 * frame, -2);
    tracker.step(frame % 2 ? std::vector{there, back} : std::vector{back, there});
  }
  ASSERT_THAT(idsOf(tracker.listed()), ElementsAre(1, 2));
  EXPECT_EQ(tracker.listed()[0].feature.box.centre_m[1], -2.0);
  EXPECT_EQ(tracker.listed()[1].feature.box.centre_m[1], 2.0);
}

TEST(Tracking, WhatIsTooFarIsAnotherObject) {
  Tracker tracker{{.distance_m = 2.5}};
  tracker.step(std::vector{at(10, 0)});
  tracker.step(std::vector{at(12.6, 0)});
  EXPECT_THAT(idsOf(tracker.all()), ElementsAre(1, 2));
}

TEST(Tracking, NamedObjectsAreFollowedByName) {
  Tracker tracker{{}};
  tracker.step(std::vector{at(10, 0, "a"), at(11, 0, "b")});
  tracker.step(std::vector{at(11, 0, "a"), at(90, 0, "b")});
  EXPECT_THAT(idsOf(tracker.all()), ElementsAre(1, 2));
  EXPECT_EQ(tracker.all()[0].feature.box.centre_m[0], 11.0);
  EXPECT_EQ(tracker.all()[1].feature.box.centre_m[0], 90.0);
}

TEST(NearestPairs, NearestFirstEachOnce) {
  const std::vector<objects::Box> a{at(0, 0).box, at(1, 0).box}, b{at(1.1, 0).box, at(2.9, 0).box};
  EXPECT_THAT(objects::nearestPairs(a, b, 5.0), ElementsAre(Pair(1, 0), Pair(0, 1)));
  EXPECT_THAT(objects::nearestPairs(a, b, 1.0), ElementsAre(Pair(1, 0)));
}

}  // namespace
