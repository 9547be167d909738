#pragma once

#include <string>
#include <vector>

#include "gap/candidates.h"

namespace gap {

// --- data that cannot be diagnosed: InputError that says what to do
/// Throws if a detection's frame is beyond the sample's.
void requireFrames(const ReplaySample& sample);
/// Throws if the model scans otherwise than the sensor that measured: another number of layers, or of beams in one.
void requireSameScan(const model::Experiment& experiment, const ReplaySample& sample,
                     const std::vector<model::Beam>& of_model, const model::LidarModel& model);
/// Throws if no sample holds a single detection.
void requireDetections(const model::Experiment& experiment, const std::vector<ReplaySample>& samples);

// --- data that can, but tell little
/// Why the data are too few to be sure of anything, a clause each ("there is one sample only …"); empty if they are
/// not.
[[nodiscard]] std::vector<std::string> limitsOf(const Replay& replay, const Split& split);

/// The most that a verdict from data with so many limits may be believed, whatever else speaks for it: a half with one,
/// less with each further one. A choice, not a calibration: below 0.5 nobody takes a cause for found.
[[nodiscard]] double mostConfidence(std::size_t limits);

/// What a person should know of the data, whatever the verdict: measurands left out, empty samples, detections where
/// the scene has nothing, roles that could not be kept. Sentences.
[[nodiscard]] std::vector<std::string> notesOn(const Replay& replay);

}  // namespace gap
