#pragma once

#include <span>

#include "core/detections.h"
#include "model/sensor/beams.h"

namespace model {

/// Gives detections with directions but without layers (point clouds, OSI traces) the layer of the nearest beam, by the
/// angle between the directions. Does nothing to others.
void addLayers(core::Detections& detections, std::span<const Beam> beams);

}  // namespace model
