#pragma once

#include <string>
#include <vector>

#include "model/scene/scene.h"
#include "model/scene/traffic.h"

namespace model {

/// One piece of an object's outline.
struct OutlinePart {
  std::string name;  ///< "body", "wheel-front-left", …
  Shape shape;
  Pose pose;             ///< in the object's frame, origin in the centre of its bounding box
  std::string material;  ///< of trafficMaterials()
};

/// An object as a few primitives in place of its bounding box, because a lidar sees the difference: a car's bonnet and
/// boot lie lower than its roof, its floor lets beams through, its wheels stand out, a pedestrian has no corners.
///
///         ┌───cabin──┐             car: body up to the belt line (0.62 H), cabin above it (0.55 L, 0.85 W, a little
///     ┌───┴──────────┴───┐         behind the middle), four wheels; nothing between them below the floor
///     └─(o)────body──(o)─┘
///
/// The union keeps the bounding box's length, width and height exactly: that is what the trace states. Axles, wheel
/// radius and ground clearance are the trace's where it gives them. Everything else are round figures read off side
/// views of common vehicles, ours and from no standard: take a mesh where an outline matters to the centimetre. A head
/// takes 1/8 of a standing person's height (the artists' canon), the body is a cylinder of the box's mean width.
[[nodiscard]] std::vector<OutlinePart> outlineOf(const TrafficObject& object);

/// The bounding box itself, one part.
[[nodiscard]] std::vector<OutlinePart> boxOutlineOf(const TrafficObject& object);

/// The materials that parts name, with reflectivities near 905 nm to start from: round figures, to be replaced by
/// measured ones.
struct TrafficMaterial {
  std::string name;
  double reflectivity;
};
[[nodiscard]] const std::vector<TrafficMaterial>& trafficMaterials();

}  // namespace model
