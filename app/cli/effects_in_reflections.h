#pragma once

#include <ostream>

#include "core/text.h"
#include "model/reflections.h"

namespace app {

/// Says which effects of the model do nothing, because reflections from elsewhere stand in for their work.
inline void writeEffectsInReflections(const model::LidarModel& lidar, std::ostream& messages) {
  const std::vector<std::string> names = model::effectsInReflections(lidar);
  if (!names.empty()) messages << "taken to be in the reflections already: " << core::join(names) << "\n";
}

}  // namespace app
