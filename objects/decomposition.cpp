#include "objects/decomposition.h"

namespace objects {

namespace {
constexpr BlockInfo kBlocks[] = {
    {Block::kEmission, "Emission", "pulses", "model: beams, sub-rays"},
    {Block::kSignalPropagation, "Signal propagation", "reflections", "model: geometry pass, materials"},
    {Block::kReception, "Reception", "waveform", "model: signal pass"},
    {Block::kPreProcessing, "Pre-processing", "echoes", "model: signal pass"},
    {Block::kDetectionIdentification, "Detection identification", "detections", "model: signal pass; gates"},
    {Block::kFeatureIdentification, "Feature identification", "segments with boxes",
     "objects: ground removal, segmentation, box fit"},
    {Block::kObjectIdentification, "Object identification", "object list", "objects: tracking, existence"},
};
}  // namespace

std::span<const BlockInfo> allBlocks() { return kBlocks; }

const BlockInfo& infoOf(Block block) { return kBlocks[static_cast<std::size_t>(block)]; }

Block blockOf(model::Stage stage) {
  switch (stage) {
    case model::Stage::kEmission:
      return Block::kEmission;
    case model::Stage::kPropagation:
    case model::Stage::kInteraction:
      return Block::kSignalPropagation;
    case model::Stage::kReception:
      return Block::kReception;
    case model::Stage::kPreProcessing:
      return Block::kPreProcessing;
    case model::Stage::kDetection:
      return Block::kDetectionIdentification;
  }
  return Block::kDetectionIdentification;
}

}  // namespace objects
