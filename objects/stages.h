#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>

#include "objects/box_fit.h"
#include "objects/ground.h"
#include "objects/reference_point.h"
#include "objects/segments.h"
#include "objects/tracking.h"

namespace objects {

enum class GroundBy {
  kReference,  ///< the planes and flat rectangles of the scene
  kFit,        ///< a plane fitted to the detections of each frame
  kNone        ///< nothing is ground
};
enum class SegmentsBy {
  kClusters,  ///< detections near each other
  kReference  ///< detections in the widened boxes of the scene's objects: what perfect segmentation would give
};

/// What is done with detections until they are objects, and its numbers (docs/formats.md, "Stages of the object
/// level"). The defaults of tracking, of least_detections and of the least length and width are those of the public
/// profiles of SCALA 1 and Ibeo LUX; their least height of 2.0 m suits scanners of few layers, ours is off.
struct Stages {
  std::string id = "default";
  // Feature identification: detections in, boxes out.
  GroundBy ground_by = GroundBy::kReference;
  GroundFit ground;
  SegmentsBy segments_by = SegmentsBy::kClusters;
  Nearness nearness;
  double margin_m = 0.3;  ///< by which reference boxes are widened
  BoxFit box;
  int least_detections = 3;             ///< a segment of fewer is no object
  Vector3 least_size_m{0.8, 0.5, 0.0};  ///< length, width, height
  double to_ground_m = 1.0;             ///< a box whose foot is no higher above known ground stands on it
  // Object identification: boxes in, object list out.
  Tracking tracking;
  ReferenceOptions reference;
  std::uint64_t seed = 1;
};

/// Reads a file of format fidelis-object-stages; absent keys keep their defaults. Throws InputError with JSON Pointer.
[[nodiscard]] Stages readStages(const std::filesystem::path& file);
[[nodiscard]] Stages parseStages(const nlohmann::json& json, const std::filesystem::path& file);

}  // namespace objects
