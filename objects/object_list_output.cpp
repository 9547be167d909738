#include <array>
#include <cmath>
#include <fmt/format.h>

#include "core/csv.h"
#include "objects/decomposition.h"
#include "objects/object_list.h"

namespace objects {

namespace {

using nlohmann::ordered_json;

/// Never "-0.0000": the sign of nothing.
std::string fixed(double value, int digits) {
  const double scale = std::pow(10.0, digits);
  const double rounded = std::round(value * scale) / scale;
  return fmt::format("{:.{}f}", rounded == 0.0 ? 0.0 : rounded, digits);
}
std::string metres(double value) { return fixed(value, 4); }
std::string radians(double value) { return fixed(value, 6); }

std::string record(const std::vector<std::string>& fields) { return core::csvRecord(fields); }

}  // namespace

// A metric takes x_m, y_m for the middle of length_m by width_m. Where they are another point's, the size goes by
// another name, and a metric of footprints says that it has none instead of comparing boxes that are out of place.
std::string toCsv(const ObjectList& list, const ReferenceChoice& choice, const ReferenceOptions& options) {
  const std::string prefix = choice.name() == "centre" ? "" : "box_";
  std::string text =
      record({"frame", "id", "x_m", "y_m", "z_m", prefix + "length_m", prefix + "width_m", prefix + "height_m",
              prefix + "yaw_rad", "existence", "detections", "age", "class", "reference_point", "object"});
  for (const ListedObject& object : list.objects) {
    const ObjectState state = stateAt(object.box, choice.on(object.box), options);
    text += record({std::to_string(object.frame), std::to_string(object.id), metres(state.position_m[0]),
                    metres(state.position_m[1]), metres(state.position_m[2]), metres(state.length_m),
                    metres(state.width_m), metres(state.height_m), radians(state.yaw_rad), fixed(object.existence, 4),
                    object.detections ? std::to_string(*object.detections) : "", std::to_string(object.age), "none",
                    toString(state.point), object.object});
  }
  return text;
}

std::string toCsv(std::span<const ObjectError> errors) {
  std::string text = record({"frame", "id", "object", "reference_point", "error_x_m", "error_y_m", "error_z_m",
                             "error_length_m", "error_width_m", "error_height_m", "error_yaw_rad", "existence"});
  for (const ObjectError& error : errors) {
    text += record({std::to_string(error.frame), std::to_string(error.id), error.object, toString(error.point),
                    metres(error.position_m[0]), metres(error.position_m[1]), metres(error.position_m[2]),
                    metres(error.length_m), metres(error.width_m), metres(error.height_m), radians(error.yaw_rad),
                    fixed(error.existence, 4)});
  }
  return text;
}

ordered_json toJson(const ObjectList& list, const ReferenceChoice& choice, const ReferenceOptions& options) {
  ordered_json rows = ordered_json::array();
  for (const ListedObject& object : list.objects) {
    const ObjectState state = stateAt(object.box, choice.on(object.box), options);
    rows.push_back({{"frame", object.frame},
                    {"id", object.id},
                    {"reference_point", toString(state.point)},
                    {"position_m", state.position_m},
                    {"size_m", std::array{state.length_m, state.width_m, state.height_m}},
                    {"yaw_rad", state.yaw_rad},
                    {"existence", object.existence},
                    {"detections", object.detections ? ordered_json(*object.detections) : ordered_json()},
                    {"age", object.age},
                    {"class", "none"},
                    {"object", object.object.empty() ? ordered_json() : ordered_json(object.object)}});
  }
  return {{"sample", list.sample}, {"frames", list.frames}, {"objects", rows}};
}

ordered_json toJson(const StageCounts& counts) {
  return {{{"block", infoOf(Block::kDetectionIdentification).name},
           {"detections", counts.detections},
           {"outside_gate", counts.outside_gate}},
          {{"block", infoOf(Block::kFeatureIdentification).name},
           {"ground", counts.ground},
           {"frames_without_ground", counts.frames_without_ground},
           {"without_object", counts.without_object},
           {"segments", counts.segments},
           {"features", counts.features}},
          {{"block", infoOf(Block::kObjectIdentification).name}, {"objects", counts.listed}}};
}

}  // namespace objects
