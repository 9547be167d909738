#include "gap/replay/replay_sample.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "core/error.h"
#include "gap/replay/data_checks.h"

namespace gap {

namespace {

/// Leaves out all beams but these, with their measured detections.
void take(ReplaySample& sample, std::vector<std::uint32_t> beams) {
  sample.whole_scan = std::move(sample.beams);
  sample.taken = std::move(beams);
  constexpr std::uint32_t kLeftOut = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> place(sample.whole_scan.size(), kLeftOut);
  sample.beams.clear();
  for (const std::uint32_t b : sample.taken) {
    place[b] = static_cast<std::uint32_t>(sample.beams.size());
    sample.beams.push_back(sample.whole_scan[b]);
  }
  std::vector<std::size_t> kept;
  std::vector<std::uint32_t> beam_of;
  for (std::size_t i = 0; i < sample.beam_of.size(); ++i) {
    if (place[sample.beam_of[i]] == kLeftOut) continue;
    kept.push_back(i);
    beam_of.push_back(place[sample.beam_of[i]]);
  }
  sample.measured = core::selected(sample.measured, kept);
  sample.beam_of = std::move(beam_of);
}

/// What a foreign model reported, as shots of these beams. Throws InputError if directions are missing.
ForeignFrames foreignFrames(const model::ExternalRun& run, const ReplaySample& sample, const model::LidarModel& model) {
  const core::Place place{.file = model.file, .item = "sample '" + sample.sample->id + "'"};
  if (!run.detections.hasDirections() && sample.measured.hasDirections()) {
    throw core::InputError(place, "was simulated without directions; the measurement has them.",
                           "Let the model write layer, azimuth_rad and elevation_rad.");
  }
  const auto beam_of = beamsOfDetections(run.detections, sample.beams, model.file);
  const core::Detections& d = run.detections;
  ForeignFrames frames{.shots = {}, .frames = run.frames};
  for (std::size_t i = 0; i < d.size(); ++i) {
    frames.shots.push_back({.beam = beam_of[i],
                            .frame = d.frame[i],
                            .echo = d.echo.empty() ? 1 : d.echo[i],
                            .range_m = d.range_m[i],
                            .epw_m = d.epw_m.empty() ? 0.0 : d.epw_m[i],
                            .intensity_nw = d.intensity.empty() ? 0.0 : d.intensity[i]});
  }
  std::stable_sort(frames.shots.begin(), frames.shots.end(),
                   [](const model::Shot& a, const model::Shot& b) { return a.frame < b.frame; });
  return frames;
}

}  // namespace

ReplaySample readSample(const model::Experiment& experiment, std::size_t index, const model::LidarModel& baseline,
                        const model::ExternalRun* foreign, const BeamChoice& choice) {
  ReplaySample read;
  read.index = index;
  read.sample = &experiment.samples[index];
  read.measured = model::readMeasurements(experiment, *read.sample);
  read.beams = model::beamsOfSample(experiment, baseline, *read.sample);
  requireSameScan(experiment, read, read.beams, baseline);
  read.beam_of = beamsOfDetections(read.measured, read.beams, read.sample->measurements);
  read.frames = read.sample->frames;
  requireFrames(read);
  if (foreign != nullptr) read.foreign = foreignFrames(*foreign, read, baseline);
  if (!read.measured.hasDirections()) return read;
  std::vector<std::uint32_t> beams = choice(read.beams);
  if (beams.empty()) return read;
  take(read, std::move(beams));
  keepTaken(read.taken, read.foreign.shots);
  return read;
}

std::vector<std::uint32_t> evenlyOf(const std::vector<model::Beam>& beams, std::size_t most) {
  const std::size_t stride = (beams.size() + most - 1) / most;
  if (stride < 2) return {};
  // Layers take turns, so that no direction is left out in all of them.
  const auto turnOf = [](const model::Beam& beam) {
    return static_cast<std::size_t>(beam.column) / 2 + static_cast<std::size_t>(beam.layer);
  };
  std::map<std::size_t, std::size_t> turns;  // those that these beams have, numbered
  for (const model::Beam& beam : beams) turns.try_emplace(turnOf(beam));
  std::size_t number = 0;
  for (auto& turn : turns) turn.second = number++;
  std::vector<std::uint32_t> taken;
  for (std::uint32_t b = 0; b < beams.size(); ++b)
    if (turns.at(turnOf(beams[b])) % stride == 0) taken.push_back(b);
  return taken;
}

void keepTaken(const std::vector<std::uint32_t>& taken, std::vector<model::Shot>& shots) {
  const auto placeOf = [&](std::uint32_t beam) { return std::lower_bound(taken.begin(), taken.end(), beam); };
  std::erase_if(shots, [&](const model::Shot& shot) {
    const auto place = placeOf(shot.beam);
    return place == taken.end() || *place != shot.beam;
  });
  for (model::Shot& shot : shots) shot.beam = static_cast<std::uint32_t>(placeOf(shot.beam) - taken.begin());
}

double ReplaySample::rangeDeviation_m(std::size_t cell) const {
  double variance_m2 = 0.0;
  for (const Tolerance& tolerance : tolerances) {
    if (cell >= tolerance.range_per_unit.size()) continue;
    const double slope = static_cast<double>(tolerance.range_per_unit[cell]);
    variance_m2 += slope * slope * tolerance.variance();
  }
  return std::sqrt(variance_m2);
}

void CommonChannels::add(const core::Detections& detections) {
  if (detections.size() == 0) return;
  everywhere_[kEpw] = everywhere_[kEpw] && !detections.epw_m.empty();
  everywhere_[kIntensity] = everywhere_[kIntensity] && !detections.intensity.empty();
}

}  // namespace gap
