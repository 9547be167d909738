#pragma once

#include <optional>

#include "gap/candidates/candidates.h"

namespace gap {

/// What all detections of a frame have in common. Nearly all effects, parameters and references act alike in all frames
/// of a sample, or on every detection for itself; a sensor that jumps, drifts or swings from frame to frame does
/// neither, and poses as noise.
struct FrameMode {
  Channel channel = kRange;  ///< in which it stands out most
  double stddev = 0.0;       ///< of the common deviation, over frames [m, m, nW]
  double z = 0.0;            ///< above that of detections that scatter for themselves, in standard deviations
  /// Of the held-out discrepancy beyond that of a right model: what is gone once the measurement is rid of it.
  double share_of_gap = 0.0;
  /// From the least to the largest common deviation of the frames of one number in all samples, if they are alike
  /// there: a sensor that warms up or drifts. 0 otherwise.
  double span_in_all_samples = 0.0;
};

/// On all samples, its share on those held out; nothing where it does not stand out beyond doubt, or does so in the
/// baseline or with the cause, if one is named, as well: clouds of spray are new in every frame.
[[nodiscard]] std::optional<FrameMode> frameModeOf(const Judge& judge, const std::optional<World>& with_cause);

/// Whether a cause, which is the same in all frames, mostly moves the channel in which frames deviate alike in all
/// samples, and moves it by so little that they deviate by a good part of that: then it is their mean that it explains.
[[nodiscard]] bool explainsTheirMean(const Judge& judge, const FrameMode& frames, const World& with_cause);

}  // namespace gap
