#pragma once

#include <span>

#include "model/effects/effect.h"

namespace objects {

/// The blocks of a lidar sensor system, in the order of its signal and data: what a requirement on one of them is
/// about. Detections leave the fifth, objects the last.
/// Names as in the cause-effect graphs (`decomBlock` of PerCollECT, LidarLimbs); effects of the lidar model act in the
/// first five, this folder does the last two. Tracking, existence included, is part of object identification there.
/// Source: Linnhoff et al. 2021 (PerCollECT); functional decomposition: Rosenberger et al. 2022,
/// doi:10.26083/tuprints-00023034.
enum class Block {
  kEmission,
  kSignalPropagation,
  kReception,
  kPreProcessing,
  kDetectionIdentification,
  kFeatureIdentification,
  kObjectIdentification
};

struct BlockInfo {
  Block block;
  const char* name;   ///< as in the graphs
  const char* gives;  ///< what leaves it
  const char* here;   ///< who does it in this program
};
[[nodiscard]] std::span<const BlockInfo> allBlocks();
[[nodiscard]] const BlockInfo& infoOf(Block block);

/// The block in which an effect of that stage acts. What happens at a surface belongs to signal propagation.
[[nodiscard]] Block blockOf(model::Stage stage);

}  // namespace objects
