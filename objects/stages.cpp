#include "objects/stages.h"

#include <array>
#include <utility>

#include "core/json_object.h"
#include "core/physics.h"

namespace objects {

namespace {

using core::JsonObject;

constexpr core::Bounds kPositive{.min = 0.0, .open_min = true};
constexpr core::Bounds kNotNegative{.min = 0.0};
constexpr core::Bounds kShare{.min = 0.0, .max = 1.0};

/// The value that belongs to the name in the file.
template <typename Value, std::size_t N>
Value choose(JsonObject& object, const std::string& key, const std::array<std::pair<const char*, Value>, N>& choices,
             Value otherwise) {
  std::vector<std::string> names;
  std::string now;
  for (const auto& [name, value] : choices) {
    names.emplace_back(name);
    if (value == otherwise) now = name;
  }
  const std::string chosen = object.choiceOr(key, names, now);
  for (const auto& [name, value] : choices) {
    if (chosen == name) return value;
  }
  return otherwise;
}

void readGround(JsonObject object, Stages& stages) {
  stages.ground_by = choose<GroundBy, 3>(
      object, "by", {{{"reference", GroundBy::kReference}, {"fit", GroundBy::kFit}, {"none", GroundBy::kNone}}},
      stages.ground_by);
  GroundFit& fit = stages.ground;
  fit.tolerance_m = object.numberOr("tolerance_m", fit.tolerance_m, kNotNegative);
  fit.max_tilt_rad = core::kRadPerDeg *
                     object.numberOr("max_tilt_deg", core::kDegPerRad * fit.max_tilt_rad, {.min = 0.0, .max = 45.0});
  fit.least_share = object.numberOr("least_share", fit.least_share, kShare);
  fit.least_spread_m = object.numberOr("least_spread_m", fit.least_spread_m, kNotNegative);
  fit.least_depth_m = object.numberOr("least_depth_m", fit.least_depth_m);
  fit.tries = static_cast<int>(object.integerOr("tries", fit.tries, {.min = 1, .max = 1e6}));
  object.finish();
}

void readSegments(JsonObject object, Stages& stages) {
  stages.segments_by = choose<SegmentsBy, 2>(
      object, "by", {{{"clusters", SegmentsBy::kClusters}, {"reference", SegmentsBy::kReference}}}, stages.segments_by);
  Nearness& nearness = stages.nearness;
  nearness.distance_m = object.numberOr("distance_m", nearness.distance_m, kPositive);
  nearness.distance_per_range = object.numberOr("distance_per_range", nearness.distance_per_range, kShare);
  nearness.vertical_weight = object.numberOr("vertical_weight", nearness.vertical_weight, kShare);
  stages.margin_m = object.numberOr("margin_m", stages.margin_m, kNotNegative);
  stages.least_detections =
      static_cast<int>(object.integerOr("least_detections", stages.least_detections, {.min = 1, .max = 1e9}));
  object.finish();
}

void readBoxes(JsonObject object, Stages& stages) {
  stages.box.criterion = choose<FitCriterion, 3>(
      object, "criterion",
      {{{"area", FitCriterion::kArea}, {"closeness", FitCriterion::kCloseness}, {"variance", FitCriterion::kVariance}}},
      stages.box.criterion);
  stages.box.step_rad = core::kRadPerDeg *
                        object.numberOr("step_deg", core::kDegPerRad * stages.box.step_rad, {.min = 0.01, .max = 15.0});
  stages.box.closest_m = object.numberOr("closest_m", stages.box.closest_m, kPositive);
  if (object.has("least_size_m")) {
    const auto size = object.numbers("least_size_m", 3);
    for (const double side : size) {
      if (side < 0.0) object.fail("least_size_m", "has a negative side.", "Give length, width and height, or 0.");
    }
    stages.least_size_m = {size[0], size[1], size[2]};
  }
  stages.to_ground_m = object.numberOr("to_ground_m", stages.to_ground_m, kNotNegative);
  object.finish();
}

void readTracking(JsonObject object, Tracking& tracking) {
  tracking.increment = object.numberOr("increment", tracking.increment, {.min = 0.0, .max = 1.0, .open_min = true});
  tracking.decrement = object.numberOr("decrement", tracking.decrement, {.min = 0.0, .max = 1.0, .open_min = true});
  tracking.threshold = object.numberOr("threshold", tracking.threshold, kShare);
  tracking.distance_m = object.numberOr("distance_m", tracking.distance_m, kPositive);
  object.finish();
}

}  // namespace

Stages parseStages(const nlohmann::json& json, const std::filesystem::path& file) {
  Stages stages;
  JsonObject object(json, file);
  object.expectFormat("fidelis-object-stages", 1);
  stages.id = object.textOr("id", stages.id);
  if (object.has("ground")) readGround(object.object("ground"), stages);
  if (object.has("segments")) readSegments(object.object("segments"), stages);
  if (object.has("boxes")) readBoxes(object.object("boxes"), stages);
  if (object.has("tracking")) readTracking(object.object("tracking"), stages.tracking);
  stages.reference.rear_axle_share = object.numberOr("rear_axle_share", stages.reference.rear_axle_share, kShare);
  stages.seed = static_cast<std::uint64_t>(
      object.integerOr("seed", static_cast<long long>(stages.seed), {.min = 0.0, .max = 9e15}));
  object.finish();
  return stages;
}

Stages readStages(const std::filesystem::path& file) { return parseStages(core::readJson(file), file); }

}  // namespace objects
