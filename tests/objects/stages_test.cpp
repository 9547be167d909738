#include "objects/stages.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/thrown_message.h"

namespace {

using nlohmann::json;
using testing::HasSubstr;

objects::Stages parsed(json value) {
  value["format"] = "fidelis-object-stages";
  value["version"] = 1;
  return objects::parseStages(value, "stages.json");
}

std::string refusal(const json& value) {
  return test_support::thrownMessage([&] { (void)parsed(value); });
}

TEST(Stages, AbsentKeysKeepTheirDefaults) {
  const objects::Stages read = parsed(json::object()), usual;
  EXPECT_EQ(read.tracking.increment, 0.2);
  EXPECT_EQ(read.tracking.decrement, 0.055);
  EXPECT_EQ(read.tracking.threshold, 0.5);
  EXPECT_EQ(read.least_detections, 3);
  EXPECT_EQ(read.least_size_m, usual.least_size_m);
  EXPECT_DOUBLE_EQ(read.box.step_rad, usual.box.step_rad);
}

TEST(Stages, EveryKeyIsRead) {
  const objects::Stages read =
      parsed({{"id", "mine"},
              {"ground",
               {{"by", "fit"},
                {"tolerance_m", 0.1},
                {"max_tilt_deg", 5},
                {"least_share", 0.5},
                {"least_spread_m", 2},
                {"least_depth_m", 1},
                {"tries", 50}}},
              {"segments",
               {{"by", "reference"},
                {"distance_m", 0.4},
                {"distance_per_range", 0.03},
                {"vertical_weight", 0.5},
                {"margin_m", 0.2},
                {"least_detections", 4}}},
              {"boxes",
               {{"criterion", "variance"},
                {"step_deg", 2},
                {"closest_m", 0.02},
                {"least_size_m", {1, 2, 3}},
                {"to_ground_m", 0.5}}},
              {"tracking", {{"increment", 0.3}, {"decrement", 0.1}, {"threshold", 0.6}, {"distance_m", 3}}},
              {"rear_axle_share", 0.25},
              {"seed", 7}});
  EXPECT_EQ(read.id, "mine");
  EXPECT_EQ(read.ground_by, objects::GroundBy::kFit);
  EXPECT_EQ(read.ground.tries, 50);
  EXPECT_EQ(read.segments_by, objects::SegmentsBy::kReference);
  EXPECT_EQ(read.nearness.distance_per_range, 0.03);
  EXPECT_EQ(read.margin_m, 0.2);
  EXPECT_EQ(read.least_detections, 4);
  EXPECT_EQ(read.box.criterion, objects::FitCriterion::kVariance);
  EXPECT_EQ(read.least_size_m, (objects::Vector3{1, 2, 3}));
  EXPECT_EQ(read.to_ground_m, 0.5);
  EXPECT_EQ(read.tracking.threshold, 0.6);
  EXPECT_EQ(read.reference.rear_axle_share, 0.25);
  EXPECT_EQ(read.seed, 7u);
}

TEST(Stages, RefusesWhatItDoesNotKnowOrCannotBe) {
  EXPECT_THAT(refusal({{"tracking", {{"treshold", 0.5}}}}), HasSubstr("threshold"));
  EXPECT_THAT(refusal({{"tracking", {{"increment", 0}}}}), HasSubstr("/tracking/increment"));
  EXPECT_THAT(refusal({{"ground", {{"by", "grid"}}}}), HasSubstr("fit"));
  EXPECT_THAT(refusal({{"segments", {{"least_detections", 0}}}}), HasSubstr("/segments/least_detections"));
  EXPECT_THAT(refusal({{"boxes", {{"least_size_m", {1, -1, 0}}}}}), HasSubstr("negative"));
  EXPECT_THAT(refusal({{"boxes", {{"step_deg", 90}}}}), HasSubstr("/boxes/step_deg"));
}

}  // namespace
