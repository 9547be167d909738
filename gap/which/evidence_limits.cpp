#include "gap/which/evidence_limits.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "core/text.h"

namespace gap {

namespace {

constexpr int kFewFrames = 3;           // below, no spread within a beam is known
constexpr std::size_t kFewCells = 20;   // surfaces seen by beams, in all samples together
constexpr double kFewDetections = 100;  // in all samples together
constexpr double kMuchBeside = 0.2;     // share of the detections where the scene has nothing, that is worth a note
constexpr double kMostBeside = 0.5;     // from which on nothing is believed
constexpr double kMostWithOne = 0.5;    // confidence
constexpr double kFurtherLimit = 0.7;   // factor

double detectionsIn(const ReplaySample& sample, std::size_t begin, std::size_t end) {
  double sum = 0.0;
  for (std::size_t c = begin; c < end; ++c) sum += sample.statistics[c].count;
  return sum;
}

double onSurfaces(const ReplaySample& sample) { return detectionsIn(sample, 0, sample.layout->surfaces()); }
double besideSurfaces(const ReplaySample& sample) {
  return detectionsIn(sample, sample.layout->surfaces(), sample.layout->cells().size());
}

/// Of all detections, those where the scene has no surface.
double shareBeside(const Replay& replay) {
  double on = 0.0, beside = 0.0;
  for (const ReplaySample& sample : replay.samples()) {
    on += onSurfaces(sample);
    beside += besideSurfaces(sample);
  }
  return beside > 0.0 ? beside / (on + beside) : 0.0;
}

std::vector<std::string> idsOf(const Replay& replay, bool (*wanted)(const ReplaySample&)) {
  std::vector<std::string> ids;
  for (const ReplaySample& sample : replay.samples()) {
    if (wanted(sample)) ids.push_back(sample.sample->id);
  }
  return ids;
}

std::string samplesText(std::vector<std::string> ids) {
  constexpr std::size_t kNamed = 4;
  const std::size_t more = ids.size() > kNamed ? ids.size() - kNamed : 0;
  ids.resize(std::min(ids.size(), kNamed));
  return (ids.size() == 1 ? "sample " : "samples ") + core::join(ids) +
         (more > 0 ? fmt::format(" and {} more", more) : "");
}

bool isPrediction(const ReplaySample& sample) { return sample.sample->role == model::Role::kPrediction; }

/// Which measurands take no part, and why.
void noteMeasurands(const Replay& replay, std::vector<std::string>& notes) {
  for (const model::Measurand& measurand : replay.experiment().measurands) {
    const bool a_channel =
        measurand.column == "range_m" || measurand.column == "epw_m" || measurand.column == "intensity";
    if (!a_channel) {
      notes.push_back(fmt::format("{} is not compared: the causes are told by range, echo pulse width and intensity.",
                                  measurand.name));
      continue;
    }
    std::vector<std::string> without;
    for (const ReplaySample& sample : replay.samples()) {
      const std::vector<double>* values = sample.measured.values(measurand.column);
      if (sample.measured.size() > 0 && (!values || values->empty())) without.push_back(sample.sample->id);
    }
    if (without.empty()) continue;
    notes.push_back(fmt::format("{} is not compared in any sample: the column {} is missing in {}.", measurand.name,
                                measurand.column, samplesText(without)));
  }
}

}  // namespace

std::vector<std::string> limitsOf(const Replay& replay, const Split& split, Stray stray) {
  std::vector<std::string> limits;
  const auto& samples = replay.samples();
  std::size_t cells = 0;
  double detections = 0.0, held_out = 0.0;
  int frames = 0;
  bool pooled = false;
  for (const ReplaySample& sample : samples) {
    cells += sample.layout->surfaces();
    detections += static_cast<double>(sample.measured.size());
    frames = std::max(frames, sample.frames);
    pooled = pooled || sample.layout->pooled();
  }
  for (const std::size_t s : split.held_out.samples) held_out += static_cast<double>(samples[s].measured.size());
  if (samples.size() == 1) limits.emplace_back("there is one sample only, and nothing shows what the setting changes");
  if (split.weak && pooled) {
    limits.emplace_back("no sample is held out and directions were not recorded, so what was fitted judges itself");
  } else if (split.weak && samples.size() == 2) {
    limits.emplace_back("two samples are too few to hold one out, so beams of the same samples judge");
  }
  if (frames < kFewFrames) {
    limits.push_back(fmt::format("no sample has more than {} frame{}, so the scatter of a beam is not known", frames,
                                 frames == 1 ? "" : "s"));
  }
  if (!pooled && cells < kFewCells)
    limits.push_back(fmt::format("only {} beams meet a surface, all samples together", cells));
  if (detections < kFewDetections) limits.push_back(fmt::format("there are only {} detections", detections));
  if (stray == Stray::kUnexplained && shareBeside(replay) > kMostBeside)
    limits.emplace_back(
        "most of the measured detections lie where the scene has no surface, so hardly any can be paired");
  if (held_out <= 0.0) limits.emplace_back("the held-out samples hold no detection");
  return limits;
}

double mostConfidence(std::size_t limits) {
  return limits == 0 ? 1.0 : kMostWithOne * std::pow(kFurtherLimit, static_cast<double>(limits - 1));
}

std::vector<std::string> notesOn(const Replay& replay, Stray stray) {
  std::vector<std::string> notes;
  noteMeasurands(replay, notes);
  const auto empty = idsOf(replay, [](const ReplaySample& s) { return s.measured.size() == 0; });
  if (!empty.empty()) {
    notes.push_back("No detection in " + samplesText(empty) +
                    ": taken as if the sensor saw nothing. If a file is not complete, take the sample out.");
  }
  const auto pooled = idsOf(replay, [](const ReplaySample& s) { return s.layout->pooled(); });
  if (!pooled.empty()) {
    notes.push_back("Directions were not recorded in " + samplesText(pooled) +
                    ": compared as a whole, without missing and extra echoes.");
  }
  const double beside = shareBeside(replay);
  if (stray == Stray::kUnexplained && beside > kMuchBeside) {
    notes.push_back(
        fmt::format("{:.0f} % of the measured detections lie where the scene has no surface. Check the "
                    "poses of the scene, the unit of the ranges and which way the azimuth counts.",
                    100.0 * beside));
  }
  const auto thinned = idsOf(replay, [](const ReplaySample& s) { return !s.taken.empty(); });
  if (!thinned.empty()) {
    const auto& sample = *std::find_if(replay.samples().begin(), replay.samples().end(),
                                       [](const ReplaySample& s) { return !s.taken.empty(); });
    notes.push_back(fmt::format("{} of {} beams, spread evenly over the scan, took part in {}.", sample.beams.size(),
                                sample.whole_scan.size(), samplesText(thinned)));
  }
  const auto prediction = idsOf(replay, isPrediction);
  if (prediction.size() == replay.samples().size() && prediction.size() > 1) {
    notes.emplace_back("All samples have the role prediction: some of them were fitted all the same.");
  }
  return notes;
}

}  // namespace gap
