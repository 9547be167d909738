#include "gap/replay/replay.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/physics.h"
#include "gap/replay/data_checks.h"
#include "gap/replay/sample_tracing.h"

namespace gap {

namespace {

constexpr int kBaselineFrames = 6;             // enough for means
constexpr double kPlaceOfAir = 0.02;           // of the pulse's length
constexpr std::size_t kMostBytes = 300000000;  // of remembered geometry
constexpr std::size_t kMostShots = 4000000;    // of the proxy, remembered, 40 bytes each
constexpr std::size_t kMostCells = 4000000;    // of sensors that a world leaves alone, remembered, 56 bytes each

bool couplesBeams(const World& world, const std::string& sensor) {
  return std::any_of(world.model.effects.begin(), world.model.effects.end(), [&](const model::ActiveEffect& effect) {
    return effect.actsOn(sensor) && model::findEffect(effect.name)->make(effect.parameters)->couplesBeams();
  });
}

/// Where an edge cuts a beam the sub-rays decide: a hundredth of a beam beyond an edge is known to 0.4 of itself.
void addShareErrors(ReplaySample& sample) {
  for (std::size_t c = 0; c < sample.power_deviation.size(); ++c) {
    const double share = sample.layout->cells()[c].share;
    if (share < kWholeBeam) sample.power_deviation[c] = std::hypot(sample.power_deviation[c], kShareError / share);
  }
}

/// Echoes that no surface makes lie where the receiver begins to listen to the air, or where a cloud becomes dense:
/// that is known to a small part of the pulse's length, and for all of them alike.
void addToleranceOfAir(ReplaySample& sample, const model::Emitter& emitter, const std::string& sensor) {
  const CellLayout& layout = *sample.layout;
  if (layout.pooled()) return;
  const double within_m = kPlaceOfAir * core::kMetresPerNanosecond * emitter.pulse_fwhm_ns / 2.0;
  Tolerance tolerance{"air before " + sensor, -within_m, within_m, std::vector<float>(layout.cells().size(), 0.0F)};
  bool any = false;
  for (std::size_t c = layout.surfaces(); c < layout.cells().size(); ++c) {
    if (layout.cells()[c].at_edge || sample.statistics[c].count < kOftenDetected * sample.frames) continue;
    tolerance.range_per_unit[c] = 1.0F;
    any = true;
  }
  if (any) sample.tolerances.push_back(std::move(tolerance));
}

bool among(const std::vector<Channel>& channels, Channel channel) {
  return std::find(channels.begin(), channels.end(), channel) != channels.end();
}

}  // namespace

Replay::Replay(const model::Experiment& experiment, const model::LidarModel& baseline, Detail detail,
               std::span<const model::ExternalRun> foreign, const std::vector<std::vector<std::uint32_t>>& chosen)
    : experiment_(experiment), detail_(detail), traced_(kMostBytes), foreign_(foreign) {
  baseline_.model = baseline;
  CommonChannels common;
  for (std::size_t i = 0; i < experiment.samples.size(); ++i) {
    const model::ExternalRun* const run = foreign_.empty() ? nullptr : &foreign_[i];
    samples_.push_back(readSample(experiment, i, baseline, run, [&](const std::vector<model::Beam>& whole_scan) {
      return chosen.empty() ? evenlyOf(whole_scan, detail.most_beams) : chosen[i];
    }));
    common.add(samples_.back().measured);
    if (run != nullptr) common.add(run->detections);
  }
  requireDetections(experiment, samples_);
  for (const Channel channel : {kRange, kEpw, kIntensity}) {
    for (const model::Measurand& measurand : experiment.measurands) {
      if (measurand.column != columnOf(channel) || !common.has(channel)) continue;
      channels_.push_back(channel);
      resolution_[channel] = measurand.resolution;
    }
  }
  for (std::size_t s = 0; s < samples_.size(); ++s) pairWithBaseline(s);
  addJumps();
}

void Replay::pairWithBaseline(std::size_t s) {
  ReplaySample& sample = samples_[s];
  const std::string& sensor = sample.sample->sensor;
  const Geometry geometry = geometryOf(baseline_, s);
  const model::SignalChain chain(baseline_.model.sensor(sensor), baseline_.model.effectsOf(sensor),
                                 geometry->situation.environment);
  sample.scene = geometry->situation.scene;
  const CellLayout::Recorded recorded{.directions = sample.measured.hasDirections(), .widths = among(channels_, kEpw)};
  sample.layout = std::make_unique<CellLayout>(geometry->hits, sample.scene, chain, recorded);
  sample.statistics = sample.layout->statisticsOf(sample.measured, sample.beam_of);
  sample.power_deviation.resize(sample.layout->cells().size());
  sample.jump_variance_m2.resize(sample.layout->cells().size());
  for (const model::Epistemic& epistemic : sample.sample->epistemic) addTolerance(sample, s, epistemic);
  addShareErrors(sample);
  addToleranceOfAir(sample, baseline_.model.sensor(sensor).emitter, sensor);
  sample.baseline = simulate(baseline_, s, kBaselineFrames, seed());
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

void Replay::addJumps() {
  if (!among(channels_, kRange)) return;
  std::map<std::string, std::optional<Comb>> combs;  // by sensor
  for (ReplaySample& sample : samples_) {
    if (sample.tolerances.empty()) continue;
    const std::string& sensor = sample.sample->sensor;
    const auto [known, is_new] = combs.try_emplace(sensor);
    if (is_new) known->second = rangeComb(*this, {sensor});
    const std::optional<Comb>& comb = known->second;
    if (!comb || !comb->shown()) continue;
    const double noise_m = baseline_.model.sensor(sensor).detection.range_noise_m;
    for (std::size_t c = 0; c < sample.jump_variance_m2.size(); ++c)
      sample.jump_variance_m2[c] = jumpVariance(comb->step, sample.rangeDeviation_m(c), noise_m);
  }
}

Replay::Geometry Replay::geometryOf(const World& world, std::size_t sample) const {
  const bool whole = couplesBeams(world, samples_[sample].sample->sensor) && !samples_[sample].taken.empty();
  const std::string key = std::to_string(sample) + (whole ? "*" : ":") + geometryKey(world, *samples_[sample].sample);
  Geometry geometry = traced_.find(key);
  if (geometry) return geometry;
  geometry = traceSample(experiment_, samples_[sample], world, baseline_, detail_);
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
  if (geometry->hits.beams.size() != samples_[s].beams.size()) keepTaken(samples_[s].taken, shots);
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

bool Replay::movesRays(const World& world) const {
  return std::any_of(samples_.begin(), samples_.end(), [&](const ReplaySample& sample) {
    return geometryKey(world, *sample.sample) != geometryKey(baseline_, *sample.sample);
  });
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
  if (!foreign_.empty() && !among(channels_, kEpw)) detections.epw_m.clear();
  if (!foreign_.empty() && !among(channels_, kIntensity)) detections.intensity.clear();
  return detections;
}

std::optional<Comb> rangeComb(const Replay& replay, const std::vector<std::string>& sensors) {
  std::vector<double> ranges;
  double step_m = replay.resolution(kRange);
  for (const ReplaySample& sample : replay.samples()) {
    if (!model::isOn(sensors, sample.sample->sensor)) continue;
    ranges.insert(ranges.end(), sample.measured.range_m.begin(), sample.measured.range_m.end());
    step_m = std::max(step_m, replay.baseline().model.sensor(sample.sample->sensor).detection.range_resolution_m);
  }
  return combOf(std::move(ranges), 0.5 * step_m);
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
