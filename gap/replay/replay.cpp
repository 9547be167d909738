#include "gap/replay/replay.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/error.h"
#include "core/physics.h"
#include "gap/replay/data_checks.h"
#include "gap/replay/joined_hits.h"

namespace gap {

namespace {

constexpr int kBaselineFrames = 6;             // enough for means
constexpr int kFewestRays = 9;                 // per direction, whatever the model has
constexpr std::size_t kMostBytes = 300000000;  // of remembered geometry
constexpr std::size_t kMostShots = 4000000;    // of the proxy, remembered, 40 bytes each
constexpr std::size_t kMostCells = 4000000;    // of sensors that a world leaves alone, remembered, 56 bytes each

/// About so many beams, in pairs of neighbouring columns; empty if that is all of them.
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

/// The shots of the beams taken, numbered among these.
void keep(const std::vector<std::uint32_t>& taken, std::vector<model::Shot>& shots) {
  const auto placeOf = [&](std::uint32_t beam) { return std::lower_bound(taken.begin(), taken.end(), beam); };
  std::erase_if(shots, [&](const model::Shot& shot) {
    const auto place = placeOf(shot.beam);
    return place == taken.end() || *place != shot.beam;
  });
  for (model::Shot& shot : shots) shot.beam = static_cast<std::uint32_t>(placeOf(shot.beam) - taken.begin());
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

bool couplesBeams(const World& world, const std::string& sensor) {
  return std::any_of(world.model.effects.begin(), world.model.effects.end(), [&](const model::ActiveEffect& effect) {
    return effect.actsOn(sensor) && model::findEffect(effect.name)->make(effect.parameters)->couplesBeams();
  });
}

/// The corners of the beam, without power: a surface that ends between them and the outermost rays of an even grid
/// would seem to catch the whole beam.
void addCorners(model::SubRays& rays, model::BeamProfile profile, const model::AngularSize& divergence) {
  const model::SubRays halfway = model::subRaysOf(profile, divergence, 2, 2);
  for (std::size_t i = 0; i < halfway.size(); ++i) rays.add(2.0 * halfway.left_rad[i], 2.0 * halfway.up_rad[i], 0.0);
}

/// Whether a beam meets faces of one object that stand at an angle to each other, as at the corner of a box: how much
/// comes back depends on where it is parted between them.
bool isFolded(const model::HitsOfBeam& hits) {
  constexpr float kFold = 0.05F;  // on a plane the cosine changes by less than the beam is wide [rad]
  float least = 1.0F, most = 0.0F;
  for (const model::Hit& hit : hits) {
    least = std::min(least, hit.cos_incidence);
    most = std::max(most, hit.cos_incidence);
  }
  return most - least > kFold;
}

/// The beams whose sub-rays do not all meet one face of one object.
std::vector<std::uint32_t> partlyHit(const model::BeamHits& hits) {
  std::vector<std::uint32_t> partly;
  for (std::uint32_t b = 0; b < hits.beams.size(); ++b) {
    const auto of_beam = hits.of(b);
    if (of_beam.empty() && hits.rays.size() > 1) continue;
    bool whole = of_beam.size() == hits.rays.size() && !isFolded(of_beam);
    for (std::size_t i = 0; whole && i < of_beam.size(); ++i) whole = of_beam[i].object == of_beam[0].object;
    if (!whole) partly.push_back(b);
  }
  return partly;
}

/// Where an edge cuts a beam the sub-rays decide: a hundredth of a beam beyond an edge is known to 0.4 of itself.
void addShareErrors(ReplaySample& sample) {
  for (std::size_t c = 0; c < sample.power_deviation.size(); ++c) {
    const double share = sample.layout->cells()[c].share;
    if (share < kWholeBeam) sample.power_deviation[c] = std::hypot(sample.power_deviation[c], kShareError / share);
  }
}

}  // namespace

Replay::Replay(const model::Experiment& experiment, const model::LidarModel& baseline, Detail detail,
               std::span<const model::ExternalRun> foreign, const std::vector<std::vector<std::uint32_t>>& chosen)
    : experiment_(experiment), detail_(detail), traced_(kMostBytes), foreign_(foreign) {
  baseline_.model = baseline;
  std::array<bool, kChannels> everywhere{true, true, true};
  for (std::size_t i = 0; i < experiment.samples.size(); ++i) {
    ReplaySample replay;
    replay.index = i;
    replay.sample = &experiment.samples[i];
    replay.measured = model::readMeasurements(experiment, experiment.samples[i]);
    replay.beams = model::beamsOfSample(experiment, baseline, experiment.samples[i]);
    requireSameScan(experiment, replay, replay.beams, baseline);
    replay.beam_of = beamsOfDetections(replay.measured, replay.beams, experiment.samples[i].measurements);
    replay.frames = experiment.samples[i].frames;
    requireFrames(replay);
    if (!foreign_.empty()) replay.foreign = foreignFrames(foreign[i], replay, baseline);
    if (replay.measured.hasDirections()) {
      auto beams = chosen.empty() ? evenlyOf(replay.beams, detail.most_beams) : chosen[i];
      if (!beams.empty()) take(replay, std::move(beams));
    }
    if (!foreign_.empty() && !replay.taken.empty()) keep(replay.taken, replay.foreign.shots);
    if (replay.measured.size() > 0) {
      everywhere[kEpw] = everywhere[kEpw] && !replay.measured.epw_m.empty();
      everywhere[kIntensity] = everywhere[kIntensity] && !replay.measured.intensity.empty();
    }
    if (!foreign_.empty() && foreign[i].detections.size() > 0) {
      everywhere[kEpw] = everywhere[kEpw] && !foreign[i].detections.epw_m.empty();
      everywhere[kIntensity] = everywhere[kIntensity] && !foreign[i].detections.intensity.empty();
    }
    samples_.push_back(std::move(replay));
  }
  requireDetections(experiment, samples_);
  for (const Channel channel : {kRange, kEpw, kIntensity}) {
    for (const model::Measurand& measurand : experiment.measurands) {
      if (measurand.column != columnOf(channel) || !everywhere[channel]) continue;
      channels_.push_back(channel);
      resolution_[channel] = measurand.resolution;
    }
  }
  for (std::size_t s = 0; s < samples_.size(); ++s) {
    const Geometry geometry = geometryOf(baseline_, s);
    const model::SignalChain chain(baseline.sensor(samples_[s].sample->sensor),
                                   baseline.effectsOf(samples_[s].sample->sensor), geometry->situation.environment);
    samples_[s].scene = geometry->situation.scene;
    samples_[s].layout =
        std::make_unique<CellLayout>(geometry->hits, samples_[s].scene, chain, samples_[s].measured.hasDirections());
    samples_[s].statistics = samples_[s].layout->statisticsOf(samples_[s].measured, samples_[s].beam_of);
    samples_[s].power_deviation.resize(samples_[s].layout->cells().size());
    for (const model::Epistemic& epistemic : samples_[s].sample->epistemic) {
      addTolerance(samples_[s], s, epistemic);
    }
    addShareErrors(samples_[s]);
    samples_[s].baseline = simulate(baseline_, s, kBaselineFrames, seed());
  }
}

void Replay::addTolerance(ReplaySample& sample, std::size_t index, const model::Epistemic& epistemic) const {
  const CellLayout& layout = *sample.layout;
  const double width = epistemic.high - epistemic.low;
  if (width <= 0.0 || layout.pooled()) return;
  const auto seenAt = [&](double offset) {
    World moved = baseline_;
    moved.references.push_back({epistemic.path, offset, {}});
    return layout.seenIn(geometryOf(moved, index)->hits);
  };
  Tolerance tolerance{epistemic.path, epistemic.low, epistemic.high, std::vector<float>(layout.surfaces(), 0.0F)};
  const auto low = seenAt(epistemic.low), high = seenAt(epistemic.high);
  for (std::size_t c = 0; c < low.size(); ++c) {
    if (std::isfinite(low[c].range_m) && std::isfinite(high[c].range_m))
      tolerance.range_per_unit[c] = static_cast<float>((high[c].range_m - low[c].range_m) / width);
    const double most = std::max(low[c].power, high[c].power), difference = std::abs(high[c].power - low[c].power);
    const double deviation = most > 0.0 ? difference / most / std::sqrt(12.0) : 0.0;  // as of an even distribution
    sample.power_deviation[c] = std::hypot(sample.power_deviation[c], deviation);
  }
  sample.tolerances.push_back(std::move(tolerance));
}

Replay::Geometry Replay::trace(const World& world, std::size_t s) const {
  const model::Sample& sample = *samples_[s].sample;
  auto traced = std::make_shared<model::TracedSample>();
  traced->situation = situationIn(world, experiment_, sample);
  const model::SensorProfile& sensor = world.model.sensor(sample.sensor);
  const model::SignalChain chain(sensor, world.model.effectsOf(sample.sensor), traced->situation.environment);
  const model::ChainSettings& settings = chain.settings();
  const bool whole = chain.couplesBeams() && !samples_[s].taken.empty();
  std::vector<model::Beam> beams = whole ? samples_[s].whole_scan : samples_[s].beams;
  chain.aim(beams);
  // Of the recorded pulse: worlds that differ in theirs share their hits.
  const double pulse_ns = baseline_.model.sensor(sample.sensor).emitter.pulse_fwhm_ns;
  const double range_bin_m = core::kMetresPerNanosecond * pulse_ns / 2.0 / 40.0;
  const double left_bin_rad = std::max(1e-4, settings.divergence.horizontal_rad / 4.0);
  if (detail_.edge_rays == 0) {
    traced->hits = model::traceWith(chain, traced->situation.scene, std::move(beams),
                                    chain.subRays(world.model.rays_horizontal, world.model.rays_vertical));
    if (detail_.joined) traced->hits = joined(traced->hits, {}, {}, range_bin_m, left_bin_rad);
    return traced;
  }
  const int horizontal = std::max(kFewestRays, world.model.rays_horizontal);
  const int vertical = std::max(kFewestRays, world.model.rays_vertical);
  const model::Scene& scene = traced->situation.scene;
  model::SubRays rays = chain.subRays(horizontal, vertical);
  addCorners(rays, sensor.emitter.beam_profile, settings.divergence);
  const model::BeamHits all = model::traceWith(chain, scene, std::move(beams), std::move(rays));
  const auto edges = partlyHit(all);
  std::vector<model::Beam> edge_beams;
  for (const std::uint32_t b : edges) edge_beams.push_back(all.beams[b]);
  const model::BeamHits dense =
      model::traceWith(chain, scene, std::move(edge_beams),
                       chain.subRays(std::max(detail_.edge_rays, horizontal), std::max(detail_.edge_rays, vertical),
                                     model::Grid::kSheared));
  traced->hits = joined(all, edges, dense, range_bin_m, left_bin_rad);
  return traced;
}

Replay::Geometry Replay::geometryOf(const World& world, std::size_t sample) const {
  const bool whole = couplesBeams(world, samples_[sample].sample->sensor) && !samples_[sample].taken.empty();
  const std::string key = std::to_string(sample) + (whole ? "*" : ":") + geometryKey(world, *samples_[sample].sample);
  Geometry geometry = traced_.find(key);
  if (geometry) return geometry;
  geometry = trace(world, sample);
  traced_.remember(key, geometry);
  return geometry;
}

Replay Replay::thinner(std::size_t most_beams) const {
  std::vector<std::vector<std::uint32_t>> beams;
  for (const ReplaySample& sample : samples_) {
    beams.push_back(evenlyOf(sample.beams, most_beams));
    if (!beams.back().empty() || sample.taken.empty()) continue;
    beams.back().resize(sample.beams.size());
    std::iota(beams.back().begin(), beams.back().end(), 0U);
  }
  return only(std::move(beams), {most_beams, detail_.edge_rays, detail_.joined});
}

Replay Replay::only(std::vector<std::vector<std::uint32_t>> beams, Detail detail) const {
  for (std::size_t s = 0; s < samples_.size(); ++s) {
    const std::vector<std::uint32_t>& taken = samples_[s].taken;
    for (std::uint32_t& beam : beams[s]) beam = taken.empty() ? beam : taken[beam];
  }
  return Replay(experiment_, baseline_.model, detail, foreign_, beams);
}

bool Replay::thinned() const {
  return std::any_of(samples_.begin(), samples_.end(), [](const ReplaySample& s) { return !s.taken.empty(); });
}

std::vector<model::Shot> Replay::fire(const World& world, std::size_t s, int frames, std::uint64_t seed) const {
  if (foreign_.empty()) return fireBuiltIn(world, s, frames, seed);
  // The recorded frames as they are under the model's own seed: everything is compared with these.
  const std::uint64_t drawn = seed == this->seed() ? 0 : std::max<std::uint64_t>(1, seed);
  const ReplaySample& sample = samples_[s];
  return transported(framesFrom(sample.foreign, frames, drawn), *proxyShots(s, frames, seed),
                     fireBuiltIn(world, s, frames, seed), *sample.layout,
                     {seed, static_cast<std::uint32_t>(sample.index)});
}

Replay::Shots Replay::proxyShots(std::size_t s, int frames, std::uint64_t seed) const {
  const std::string key = std::to_string(s) + ":" + std::to_string(frames) + ":" + std::to_string(seed);
  {
    const std::lock_guard lock(mutex_);
    const auto found = fired_.find(key);
    if (found != fired_.end()) return found->second;
  }
  auto shots = std::make_shared<const std::vector<model::Shot>>(fireBuiltIn(baseline_, s, frames, seed));
  const std::lock_guard lock(mutex_);
  if (remembered_shots_ + shots->size() <= kMostShots && fired_.emplace(key, shots).second)
    remembered_shots_ += shots->size();
  return shots;
}

std::vector<model::Shot> Replay::fireBuiltIn(const World& world, std::size_t s, int frames, std::uint64_t seed) const {
  const Geometry geometry = geometryOf(world, s);
  const model::Sample& sample = *samples_[s].sample;
  model::Scene scene = geometry->situation.scene;
  for (model::Material& material : scene.materials) {
    const auto found = world.reflectivity.find(material.name);
    if (found != world.reflectivity.end()) material.reflectivity = found->second;
  }
  const model::SignalChain chain(world.model.sensor(sample.sensor), world.model.effectsOf(sample.sensor),
                                 geometry->situation.environment);
  std::vector<model::Shot> shots = chain.run(
      geometry->hits, scene, {.seed = seed, .sample = static_cast<std::uint32_t>(samples_[s].index), .frames = frames});
  if (geometry->hits.beams.size() != samples_[s].beams.size()) keep(samples_[s].taken, shots);
  return shots;
}

bool Replay::untouched(const World& world, const std::string& sensor) const {
  if (experiment_.sensors.size() < 2 || !world.references.empty() || !world.reflectivity.empty()) return false;
  const auto profileIn = [&](const World& one) {  // an unnamed one is that of all sensors
    const nlohmann::json& file = one.model.json;
    return file.contains("sensors") ? file.at("sensors").value(sensor, nlohmann::json()) : file.at("sensor");
  };
  const auto sameEffect = [](const model::ActiveEffect& a, const model::ActiveEffect& b) {
    return a.name == b.name && a.parameters.numbers == b.parameters.numbers &&
           a.parameters.texts == b.parameters.texts && a.parameters.lists == b.parameters.lists;
  };
  const auto effects = world.model.effectsOf(sensor), before = baseline_.model.effectsOf(sensor);
  return std::equal(effects.begin(), effects.end(), before.begin(), before.end(), sameEffect) &&
         profileIn(world) == profileIn(baseline_);
}

std::vector<CellStatistics> Replay::simulate(const World& world, std::size_t s, int frames, std::uint64_t seed) const {
  const auto simulated = [&] { return samples_[s].layout->statisticsOf(fire(world, s, frames, seed)); };
  if (!untouched(world, samples_[s].sample->sensor)) return simulated();
  const auto key = std::make_tuple(s, frames, seed);
  {
    const std::lock_guard lock(mutex_);
    const auto found = untouched_.find(key);
    if (found != untouched_.end()) return found->second;
  }
  auto statistics = simulated();
  const std::lock_guard lock(mutex_);
  if (remembered_cells_ + statistics.size() <= kMostCells && untouched_.emplace(key, statistics).second)
    remembered_cells_ += statistics.size();
  return statistics;
}

bool Replay::mirrors(const World& world, std::size_t sample) const {
  const Geometry geometry = geometryOf(world, sample);
  const auto& ways = geometry->hits.second;
  return std::any_of(ways.begin(), ways.end(), [](const model::SecondHit& way) {
    const auto end = way.turns.begin() + static_cast<std::ptrdiff_t>(way.turn_count);
    return std::any_of(way.turns.begin(), end, [](const model::Turn& turn) { return turn.mirrored; });
  });
}

core::Detections Replay::detections(const World& world, std::size_t s, std::uint64_t seed) const {
  return reported(fire(world, s, samples_[s].frames, seed), world, s);
}

core::Detections Replay::builtInDetections(const World& world, std::size_t s, std::uint64_t seed) const {
  return reported(fireBuiltIn(world, s, samples_[s].frames, seed), world, s);
}

core::Detections Replay::reported(const std::vector<model::Shot>& shots, const World& world, std::size_t s) const {
  const ReplaySample& sample = samples_[s];
  core::Detections detections = model::toDetections(shots, sample.beams, world.model.sensor(sample.sample->sensor));
  // A column that was not compared is none: a foreign model may lack one that the profile has.
  const auto compared = [&](Channel channel) {
    return std::find(channels_.begin(), channels_.end(), channel) != channels_.end();
  };
  if (!foreign_.empty() && !compared(kEpw)) detections.epw_m.clear();
  if (!foreign_.empty() && !compared(kIntensity)) detections.intensity.clear();
  return detections;
}

std::vector<SetUp> setupsOf(const Replay& replay, const std::vector<std::size_t>& samples) {
  std::vector<SetUp> setups;
  for (const std::size_t s : samples) {
    const std::string& name = replay.samples()[s].sample->setup;
    auto known = std::find_if(setups.begin(), setups.end(), [&](const SetUp& setup) { return setup.name == name; });
    if (known == setups.end()) known = setups.insert(setups.end(), {name, {}});
    known->samples.push_back(s);
  }
  return setups;
}

std::vector<SetUp> setupsOf(const Replay& replay) {
  std::vector<std::size_t> all(replay.samples().size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  return setupsOf(replay, all);
}

std::vector<std::string> objectsOf(const Replay& replay) {
  std::vector<std::string> ids;
  for (const ReplaySample& sample : replay.samples()) {
    for (const model::SceneObject& object : sample.scene.objects) {
      if (std::find(ids.begin(), ids.end(), object.id) == ids.end()) ids.push_back(object.id);
    }
  }
  return ids;
}

double azimuthStep_deg(const Replay& replay) {
  constexpr double kWhole_deg = 360.0;
  const auto& beams = replay.samples().front().beams;
  double step_deg = kWhole_deg;
  for (std::size_t i = 1; i < beams.size(); ++i) {
    const double difference = std::abs(beams[i].azimuth_rad - beams[i - 1].azimuth_rad) * core::kDegPerRad;
    if (beams[i].layer == beams[i - 1].layer && difference > 1e-6) step_deg = std::min(step_deg, difference);
  }
  return step_deg < kWhole_deg ? step_deg : 1.0;
}

}  // namespace gap
