#include "gap/replay/data_checks.h"

#include <algorithm>
#include <fmt/format.h>
#include <map>

#include "core/error.h"

namespace gap {

namespace {

std::map<std::int32_t, std::size_t> beamsByLayer(const std::vector<model::Beam>& beams) {
  std::map<std::int32_t, std::size_t> count;
  for (const model::Beam& beam : beams) ++count[beam.layer];
  return count;
}

}  // namespace

void requireFrames(const ReplaySample& sample) {
  const auto last = std::max_element(sample.measured.frame.begin(), sample.measured.frame.end());
  if (last == sample.measured.frame.end() || *last < sample.frames) return;
  throw core::InputError({.file = sample.sample->measurements},
                         fmt::format("has a frame {}, but sample '{}' states {} frames, counted from 0.", *last,
                                     sample.sample->id, sample.frames),
                         "Correct `frames` in experiment.json, or leave the further frames out of the file.");
}

void requireSameScan(const model::Experiment& experiment, const ReplaySample& sample,
                     const std::vector<model::Beam>& of_model, const model::LidarModel& model) {
  if (!sample.sample->beams.empty()) return;  // the sample's own list is fired by both
  const auto fired = beamsByLayer(model::beamsFired(experiment, *sample.sample)), scanned = beamsByLayer(of_model);
  if (fired == scanned) return;
  std::string problem;
  if (fired.size() != scanned.size()) {
    problem = fmt::format("the model's sensor has {} layers, the experiment's {}", scanned.size(), fired.size());
  } else {
    const auto [mine, theirs] = std::mismatch(scanned.begin(), scanned.end(), fired.begin());
    problem = mine->first != theirs->first
                  ? fmt::format("the model's sensor has a layer {}, the experiment's {}", mine->first, theirs->first)
                  : fmt::format("the model's sensor fires {} beams in layer {}, the experiment's {}", mine->second,
                                mine->first, theirs->second);
  }
  throw core::InputError({.file = model.file, .item = "sensor"}, problem + ": their beams cannot be paired.",
                         "Give the model the scan of the sensor that measured (" + experiment.file.string() + ").");
}

void requireDetections(const model::Experiment& experiment, const std::vector<ReplaySample>& samples) {
  for (const ReplaySample& sample : samples) {
    if (sample.measured.size() > 0) return;
  }
  throw core::InputError({.file = experiment.file, .item = "/samples"}, "no sample holds a single detection.",
                         "Check the measurement files: nothing can be said about a measurement that is empty.");
}

}  // namespace gap
