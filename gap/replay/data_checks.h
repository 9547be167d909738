#pragma once

#include <vector>

#include "gap/replay/replay_sample.h"

namespace gap {

// Data that cannot be diagnosed: InputError that says what to do.

/// Throws if a detection's frame is beyond the sample's.
void requireFrames(const ReplaySample& sample);
/// Throws if the model scans otherwise than the sensor that measured: another number of layers, or of beams in one.
void requireSameScan(const model::Experiment& experiment, const ReplaySample& sample,
                     const std::vector<model::Beam>& of_model, const model::LidarModel& model);
/// Throws if no sample holds a single detection.
void requireDetections(const model::Experiment& experiment, const std::vector<ReplaySample>& samples);

}  // namespace gap
