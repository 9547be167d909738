#include "model/explanation.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/physics.h"
#include "model/signal/power_stage.h"

namespace model {

namespace {

constexpr double kSamplesPerWidth = 16.0;
constexpr double kWidthsAround = 2.0;

/// Received signal around every pulse; neighbouring pulses share their samples.
std::vector<WaveformSample> waveformOf(std::vector<Pulse> pulses, const Fluctuation& fluctuation,
                                       const Emitter& emitter) {
  const double width_m = core::kMetresPerNanosecond * emitter.pulse_fwhm_ns / 2.0;
  const double step_m = width_m / kSamplesPerWidth;
  std::sort(pulses.begin(), pulses.end(), [](const Pulse& a, const Pulse& b) { return a.range_m < b.range_m; });
  std::vector<WaveformSample> samples;
  double from_m = -std::numeric_limits<double>::infinity();
  for (const Pulse& pulse : pulses) {
    double r = std::max(from_m, std::floor((pulse.range_m - kWidthsAround * width_m) / step_m) * step_m);
    for (; r <= pulse.range_m + kWidthsAround * width_m; r += step_m) {
      double power_w = 0.0;
      for (const Pulse& other : pulses)
        power_w += fluctuation.of(other) * other.power_w * emitter.pulse_shape.at((r - other.range_m) / width_m);
      samples.push_back({r, power_w});
    }
    from_m = r;
  }
  return samples;
}

Reason reasonOf(Fate fate) {
  switch (fate) {
    case Fate::kDetected:
      return Reason::kDetected;
    case Fate::kBlinded:
      return Reason::kBlinded;
    case Fate::kLost:
      return Reason::kLost;
    case Fate::kOutsideWindow:
      return Reason::kOutsideWindow;
    case Fate::kBelowThreshold:
    case Fate::kMerged:  // never alone: the echo that it became part of has a fate of its own
    case Fate::kTooMany:
      break;
  }
  return Reason::kBelowThreshold;
}

}  // namespace

std::string toString(Reason reason) {
  switch (reason) {
    case Reason::kDetected:
      return "detected";
    case Reason::kNoHit:
      return "no hit";
    case Reason::kBelowThreshold:
      return "below threshold";
    case Reason::kBlinded:
      return "blinded";
    case Reason::kLost:
      return "lost";
    case Reason::kOutsideWindow:
      return "gated";
  }
  return "";
}

std::string toString(Fate fate) {
  if (fate == Fate::kMerged) return "merged";
  if (fate == Fate::kTooMany) return "too many echoes";
  return toString(reasonOf(fate));
}

Explainer::Explainer(const Experiment& experiment, const LidarModel& model, std::size_t sample,
                     std::optional<std::uint64_t> seed)
    : traced_(traceSample(experiment, model, experiment.samples.at(sample))),
      chain_(model.sensor(experiment.samples[sample].sensor), model.effectsOf(experiment.samples[sample].sensor),
             traced_.situation.environment),
      options_{.seed = seed.value_or(model.seed),
               .sample = static_cast<std::uint32_t>(sample),
               .frames = experiment.samples[sample].frames} {}

std::size_t Explainer::beamNear(std::optional<int> layer, double azimuth_rad) const {
  std::size_t best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t b = 0; b < beams().size(); ++b) {
    if (layer && beams()[b].layer != *layer) continue;
    const double distance = std::abs(std::remainder(beams()[b].azimuth_rad - azimuth_rad, 2.0 * std::acos(-1.0)));
    if (distance >= least) continue;
    least = distance;
    best = b;
  }
  return best;
}

ShotRecord Explainer::recordOf(std::size_t beam, int frame) const {
  return chain_.record(traced_.hits, beam, traced_.situation.scene, options_, frame);
}

Reason Explainer::reasonOf(std::size_t beam, const ShotRecord& shot) const {
  const auto detected = std::find_if(shot.echoes.begin(), shot.echoes.end(),
                                     [](const Echo& echo) { return echo.fate == Fate::kDetected; });
  if (detected != shot.echoes.end()) return Reason::kDetected;
  if (!shot.echoes.empty()) return model::reasonOf(shot.echoes.front().fate);
  return traced_.hits.of(beam).empty() && shot.pulses.empty() ? Reason::kNoHit : Reason::kBelowThreshold;
}

Reason Explainer::reasonOf(std::size_t beam, int frame) const { return reasonOf(beam, recordOf(beam, frame)); }

std::vector<SubRayExplanation> Explainer::raysOf(std::size_t b) const {
  const BeamHits& hits = traced_.hits;
  const Scene& scene = traced_.situation.scene;
  const PowerStage power(chain_.settings(), chain_.effects(), scene);
  std::vector<double> powers_w;
  power.powersOf({std::span(hits.beams).subspan(b, 1), hits.rays, hits.hits, b, {}, {}}, powers_w);
  std::vector<SubRayExplanation> rays;
  const auto explain = [&](std::uint32_t ray) {
    const Vector3 d = directionOf(hits.beams[b], hits.rays.left_rad[ray], hits.rays.up_rad[ray]);
    SubRayExplanation explained;
    explained.azimuth_rad = std::atan2(d[1], d[0]);
    explained.elevation_rad = std::asin(std::clamp(d[2], -1.0, 1.0));
    explained.weight = hits.rays.weight[ray];
    return explained;
  };
  const auto met = [&](SubRayExplanation& explained, const Hit& hit, double power_w) {
    const SceneObject& object = scene.objects[static_cast<std::size_t>(hit.object)];
    explained.object = object.id;
    explained.material = scene.materials[object.material].name;
    explained.range_m = hit.range_m;
    explained.incidence_rad = std::acos(std::min(1.0F, hit.cos_incidence));
    explained.power_w = power_w;
  };
  for (std::uint32_t ray = 0; ray < hits.rays.size(); ++ray) rays.push_back(explain(ray));
  std::size_t next = 0;
  for (const Hit& hit : hits.of(b)) met(rays[hit.ray], hit, powers_w[next++]);
  for (const SecondHit& second : hits.secondOf(b)) {
    rays.push_back(explain(second.hit.ray));
    met(rays.back(), second.hit, power.powerOf(hits.beams[b], hits.rays, second));
    rays.back().turns = static_cast<int>(second.turn_count);
  }
  return rays;
}

BeamExplanation Explainer::explain(std::size_t beam, int frame) const {
  BeamExplanation result;
  result.beam = beams()[beam];
  result.shot = recordOf(beam, frame);
  result.reason = reasonOf(beam, result.shot);
  result.rays = raysOf(beam);
  result.waveform = waveformOf(result.shot.pulses, result.shot.fluctuation, chain_.settings().emitter);
  return result;
}

}  // namespace model
