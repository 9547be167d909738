#pragma once

#include <span>

#include "model/experiment.h"
#include "objects/points.h"
#include "objects/stages.h"
#include "objects/tracking.h"

namespace objects {

/// What became of detections on their way to objects; sums over frames.
struct StageCounts {
  std::size_t detections = 0;
  std::size_t outside_gate = 0;
  std::size_t ground = 0;
  std::size_t frames_without_ground = 0;  ///< in which ground was sought and not found
  std::size_t without_object = 0;         ///< neither ground nor in a segment that is large enough
  std::size_t segments = 0;
  std::size_t features = 0;  ///< segments with enough detections
  std::size_t listed = 0;    ///< objects that are believed in

  void add(const StageCounts& other);
};

/// The scene's bounded objects that are no ground: what an object list can be about. Indices into the scene.
[[nodiscard]] std::vector<std::size_t> realObjects(const model::Scene& scene);

/// Which object each detection belongs to by reference (index into the scene, none outside of all boxes). A detection
/// in several widened boxes belongs to the one that it lies deepest in.
[[nodiscard]] std::vector<std::optional<std::size_t>> ownersOf(const core::Detections& detections,
                                                               const model::Situation& situation, double margin_m);

/// Everything that features of one frame are made of.
struct FrameInput {
  std::span<const Vector3> points;       ///< of the sample
  std::span<const std::size_t> indices;  ///< of the frame
  const model::Situation& situation;
  const Ground& reference_ground;
  std::span<const std::optional<std::size_t>> owners;  ///< empty unless segments are by reference
  core::Random::Key random;
};

/// Feature identification of one frame: ground removed, segments, boxes. Adds to the counts.
[[nodiscard]] std::vector<Feature> featuresOf(const FrameInput& input, const Stages& stages, StageCounts& counts);

}  // namespace objects
