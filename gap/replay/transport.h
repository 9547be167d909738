#pragma once

#include <cstdint>
#include <vector>

#include "gap/replay/cells.h"

namespace gap {

/// Frames of a model that is not ours, in the shape of the built-in one's.
struct ForeignFrames {
  std::vector<model::Shot> shots;  ///< in the order of their frames
  int frames = 1;
};

/// `wanted` frames of a recording. `seed` 0 gives them in order, from the start again when they run out; any other one
/// gives another measurement of the same thing: frames drawn twice with replacement (as a bootstrap of a bootstrap), so
/// that two of them, or one and the recording itself, differ in their means as two recordings would: by twice the
/// variance of one.
[[nodiscard]] std::vector<model::Shot> framesFrom(const ForeignFrames& recording, int wanted, std::uint64_t seed);

/// What decides which detections are lost: each sample loses others.
struct TransportNoise {
  std::uint64_t seed = 0;
  std::uint32_t sample = 0;
};

/// The influence of a change of the world, seen by the built-in lidar, applied to foreign shots: cell by cell
/// (cells.h), `from` the built-in lidar's baseline and `to` its changed world, both of `frames` frames under the same
/// random numbers.
///
///   rate      fewer detections: each foreign one is kept with probability n_to / n_from (losses multiply);
///             more: the surplus (n_to - n_from) is added, taken from `to` and moved by what foreign − `from` is there
///   values    q-th quantile of the foreign cell + (q-th of `to` − q-th of `from`); intensities, whose unit a foreign
///             model may have for itself, are multiplied by the ratio of the two
///
/// Where `from` and `to` are alike nothing changes, to the bit. Exact if the foreign model's cell is the built-in one's
/// but for a constant per channel and independent losses; an approximation otherwise. Detections where the scene has no
/// surface keep their values.
[[nodiscard]] std::vector<model::Shot> transported(const std::vector<model::Shot>& foreign,
                                                   const std::vector<model::Shot>& from,
                                                   const std::vector<model::Shot>& to, const CellLayout& layout,
                                                   TransportNoise noise);

}  // namespace gap
