#include "model/signal/signal_chain.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <tuple>
#include <utility>

#include "core/parallel.h"
#include "core/physics.h"
#include "model/sensor/saturation_knee.h"
#include "model/signal/merging.h"

namespace model {

namespace {

bool contains(const std::vector<std::string>& list, const char* name) {
  return std::find(list.begin(), list.end(), name) != list.end();
}

/// So many sub-rays stay in a core's cache from the ray tracer to the echo.
constexpr std::size_t kRaysPerTile = 4096;

std::size_t beamsPerTile(std::size_t rays_per_beam) {
  return std::clamp<std::size_t>(kRaysPerTile / std::max<std::size_t>(1, rays_per_beam), 16, kRaysPerTile);
}

PulseForm formOf(const ChainSettings& settings) {
  return {core::kMetresPerNanosecond * settings.emitter.pulse_fwhm_ns / 2.0, settings.emitter.pulse_shape};
}

core::Random::Key keyOf(const RunOptions& options, int frame, std::uint32_t beam) {
  return {.seed = options.seed,
          .sample = options.sample,
          .frame = static_cast<std::uint32_t>(frame),
          .beam = beam,
          .purpose = core::purposeOf("receiver")};
}

TracedBeams someBeams(const BeamHits& geometry, std::size_t begin, std::size_t end) {
  const std::span<const std::uint32_t> first_second(geometry.first_second);
  return {std::span(geometry.beams).subspan(begin, end - begin),
          geometry.rays,
          geometry.hits,
          begin,
          geometry.second,
          first_second.empty() ? first_second : first_second.subspan(begin),
          geometry.power_w,
          geometry.second_power_w};
}

TracedBeams oneBeam(const BeamHits& geometry, std::size_t beam) { return someBeams(geometry, beam, beam + 1); }

std::vector<Shot> joined(const std::vector<std::vector<Shot>>& pieces) {
  std::vector<std::size_t> first(1, 0);
  for (const auto& piece : pieces) first.push_back(first.back() + piece.size());
  std::vector<Shot> shots(first.back());
  core::parallelFor(pieces.size(), 8, [&](std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end; ++p)
      std::copy(pieces[p].begin(), pieces[p].end(), shots.begin() + static_cast<std::ptrdiff_t>(first[p]));
  });
  return shots;
}

/// Shots in order of their frames, and within a frame as they were (a stable counting sort).
std::vector<Shot> frameByFrame(std::span<const std::vector<Shot>> pieces, const RunOptions& options) {
  const auto indexOf = [&](const Shot& shot) { return static_cast<std::size_t>(shot.frame - options.first_frame); };
  std::vector<std::size_t> position(static_cast<std::size_t>(options.frames) + 1, 0);
  for (const auto& piece : pieces) {
    for (const Shot& shot : piece) ++position[indexOf(shot) + 1];
  }
  for (std::size_t f = 1; f < position.size(); ++f) position[f] += position[f - 1];
  std::vector<Shot> shots(position.back());
  for (const auto& piece : pieces) {
    for (const Shot& shot : piece) shots[position[indexOf(shot)]++] = shot;
  }
  return shots;
}

/// Tiles came one after the other; the result goes frame by frame.
std::vector<Shot> inOneRow(const std::vector<std::vector<Shot>>& tiles, const RunOptions& options) {
  return options.frames == 1 ? joined(tiles) : frameByFrame(tiles, options);
}

/// Shots of lone pulses among those of the tile's other beams: frame by frame, beam by beam, echo by echo, as both
/// come.
std::vector<Shot> merged(const std::vector<Shot>& others, const std::vector<Shot>& lone) {
  std::vector<Shot> shots(others.size() + lone.size());
  std::merge(others.begin(), others.end(), lone.begin(), lone.end(), shots.begin(), [](const Shot& a, const Shot& b) {
    return std::tie(a.frame, a.beam, a.echo) < std::tie(b.frame, b.beam, b.echo);
  });
  return shots;
}

}  // namespace

/// Buffers that one thread reuses from beam to beam.
struct SignalChain::Scratch {
  GeometryPass::Tile tile;
  PowerStage::Scratch power;
  Pulses pulses;
  std::vector<WaveformPart> calm;   ///< parts of the beam's waveform, and
  std::vector<WaveformPart> parts;  ///< of a shot that is disturbed
  LonePulses lone;
  BeamNoise noise;
  std::size_t first_beam = 0;  ///< of the tile
  std::vector<double> gain;
  std::vector<Pulse> of_shot;
  std::vector<Stretch> stretches;
  std::vector<Stretch> of_part;
  std::vector<Echo> echoes;
};

SignalChain::SignalChain(const SensorProfile& sensor, const std::vector<ActiveEffect>& effects,
                         const Environment& environment)
    : beam_profile_(sensor.emitter.beam_profile) {
  settings_.emitter = sensor.emitter;
  settings_.receiver = sensor.receiver;
  settings_.detection = sensor.detection;
  for (const ActiveEffect& active : effects) {
    effects_.push_back(findEffect(active.name)->make(active.parameters));
    effects_.back()->prepare(settings_, environment);
    const Effect* effect = effects_.back().get();
    all_effects_.push_back(effect);
    const std::uint32_t purpose = core::purposeOf(active.name.c_str());
    if (effect->couplesBeams()) coupling_effects_.push_back(effect);
    if (effect->changesReceiver()) receiver_effects_.push_back(effect);
    if (effect->addsNoise()) noise_effects_.push_back(effect);
    if (effect->changesEchoes()) echo_effects_.push_back(effect);
    if (effect->disturbs()) disturbing_effects_.push_back({effect, purpose});
    if (effect->fluctuates()) fluctuating_effects_.push_back({effect, purpose});
    if (effect->reports()) reporting_effects_.push_back({effect, purpose});
  }
}

SignalChain::~SignalChain() = default;
SignalChain::SignalChain(SignalChain&&) noexcept = default;
SignalChain& SignalChain::operator=(SignalChain&&) noexcept = default;

void SignalChain::aim(std::vector<Beam>& beams) const {
  for (const Effect* effect : all_effects_) effect->aim(beams);
}

SubRays SignalChain::subRays(int horizontal, int vertical, Grid grid) const {
  SubRays rays = subRaysOf(beam_profile_, settings_.divergence, horizontal, vertical, grid);
  for (const Effect* effect : all_effects_) effect->spread(rays, settings_);
  return rays;
}

SecondWays SignalChain::secondWays(const Scene& scene) const {
  SecondWays ways;
  for (const SceneObject& object : scene.objects) {
    const Material& material = scene.materials[object.material];
    const auto any = [&](auto asks) { return std::any_of(all_effects_.begin(), all_effects_.end(), asks); };
    ways.through.push_back(any([&](const Effect* effect) { return effect->letsThrough(material); }));
    ways.mirrored.push_back(any([&](const Effect* effect) { return effect->mirrors(material); }));
    if (ways.through.back() || ways.mirrored.back()) {
      ways.most_turns = static_cast<std::size_t>(settings_.most_crossings);
    }
  }
  return ways;
}

std::vector<Pulse> SignalChain::pulsesOf(const BeamHits& geometry, std::size_t beam, const Scene& scene) const {
  const PowerStage power(settings_, all_effects_, scene);
  PowerStage::Scratch scratch;
  Pulses pulses;
  power.receive(oneBeam(geometry, beam), scratch, pulses);
  return pulses.pulses;
}

double SignalChain::noiseOf_w(const BeamView& view, const Receiver& receiver) const {
  if (noise_effects_.empty()) return receiver.noise_w;
  double noise_w2 = receiver.noise_w * receiver.noise_w;
  for (const Effect* effect : noise_effects_) noise_w2 += effect->addedNoise_w2(view);
  return std::sqrt(std::max(0.0, noise_w2));
}

Receiver SignalChain::receiverOf(const BeamView& view) const {
  Receiver receiver = settings_.receiver;
  for (const Effect* effect : receiver_effects_) effect->receive(view.beam, receiver);
  receiver.noise_w = noiseOf_w(view, receiver);
  return receiver;
}

/// The tails below the lowest level are cut off; a tenth of the threshold keeps that cut away from the crossings.
double SignalChain::lowestLevel(const Receiver& receiver) const {
  const double share = 1.0 - kLargestNoise;
  const double spread = fluctuating_effects_.empty() ? 1.0 : 0.1;  // a bright fluctuation lowers the level further
  return receiver.threshold_w * share * spread;
}

namespace {

/// Stretches of a part of one shot above a level, as they are before what is returned multiplies them.
double addStretches(const WaveformPart& part, double level_w, const Fluctuation& fluctuation,
                    std::vector<Stretch>& out) {
  const bool apart = part.mixed() && fluctuation.of_surfaces != 1.0;
  const double gain = part.ofSurface() && !apart ? fluctuation.ofSurface() : fluctuation.of_all;
  if (gain <= 0.0 || std::isinf(level_w)) return gain;
  const double least_w = std::max(level_w / gain, part.lowest_level_w());
  if (apart) {
    part.withSurfacesAt(fluctuation.of_surfaces).stretchesAbove(least_w, out);
  } else {
    part.stretchesAbove(least_w, out);
  }
  return gain;
}

}  // namespace

/// Step 4 of the chain: where the waveform with its noise exceeds the threshold.
void SignalChain::listenTo(const std::vector<WaveformPart>& parts, const Receiver& receiver,
                           const Fluctuation& fluctuation, const core::Random::Key& key, Scratch& scratch,
                           ShotRecord* record) const {
  scratch.stretches.clear();
  scratch.echoes.clear();
  if (parts.size() == 1 && parts.front().lone() && settings_.emitter.pulse_shape.isGaussian()) {
    const ShotNoise noise = scratch.noise.of(key.frame, 0);
    if (record) record->noise_w.push_back(receiver.noise_w * static_cast<double>(noise.power));
    const Pulse& pulse = *parts.front().lone();
    if (const auto echo = loneEcho(pulse, receiver, settings_, fluctuation.of(pulse), noise)) {
      scratch.echoes.push_back(*echo);
    }
    return;
  }
  std::uint32_t number = 0;
  for (const WaveformPart& part : parts) {
    const double drawn_w = receiver.noise_w * static_cast<double>(scratch.noise.of(key.frame, number++).power);
    const double noise_w = std::min(drawn_w, kLargestNoise * receiver.threshold_w);
    if (record) record->noise_w.push_back(noise_w);
    scratch.of_part.clear();
    const double level_w = receivedFor_w(receiver.threshold_w - noise_w, receiver);
    const double gain = addStretches(part, level_w, fluctuation, scratch.of_part);
    for (Stretch& stretch : scratch.of_part) {
      stretch.peak_w = gain * stretch.peak_w + noise_w;  // from here on with noise, so that merged echoes keep it
      stretch.noise_w = noise_w;
      scratch.stretches.push_back(stretch);
    }
  }
  const std::vector<Stretch> separate = record ? scratch.stretches : std::vector<Stretch>();
  mergeNearStretches(scratch.stretches, settings_.detection.echo_separation_m);
  for (const Stretch& stretch : scratch.stretches)
    scratch.echoes.push_back(echoOf(stretch, settings_.detection.range_mode));
  for (const Stretch& stretch : separate) {
    const bool kept = std::any_of(scratch.stretches.begin(), scratch.stretches.end(),
                                  [&](const Stretch& s) { return s.peak_m == stretch.peak_m; });
    if (kept) continue;
    record->echoes.push_back(echoOf(stretch, settings_.detection.range_mode));
    record->echoes.back().fate = Fate::kMerged;
  }
}

/// Counters are coarse, outputs are rounded, and nobody reports what lies outside the window.
void SignalChain::count(Echo& echo) const {
  const DetectionStage& stage = settings_.detection;
  const CounterSteps& counters = settings_.counters;
  const double peak_nw = std::min(kWattToNanowatt * echo.peak_w, counters.intensity_full_scale_nw);
  echo.range_m = toStep(toStep(echo.range_m, counters.range_m), stage.range_resolution_m);
  echo.epw_m = std::max(0.0, toStep(toStep(echo.epw_m, counters.epw_m), stage.epw_resolution_m));
  echo.peak_w = toStep(toStep(peak_nw, counters.intensity_nw), stage.intensity_resolution_nw) / kWattToNanowatt;
  if (!insideWindow(echo)) echo.fate = Fate::kOutsideWindow;
}

bool SignalChain::insideWindow(const Echo& echo) const {
  return echo.range_m >= settings_.detection.min_range_m && echo.range_m <= settings_.detection.max_range_m;
}

/// Everything behind the detection of echoes: time base, noise, losses, rounding, window, numbering.
void SignalChain::finish(const Receiver& receiver, const core::Random::Key& key, Scratch& scratch,
                         ShotRecord* record) const {
  const DetectionStage& stage = settings_.detection;
  std::vector<Echo>& echoes = scratch.echoes;
  const auto dropLost = [&] {
    std::erase_if(echoes, [&](const Echo& echo) {
      if (echo.fate != Fate::kDetected && record) record->echoes.push_back(echo);
      return echo.fate != Fate::kDetected;
    });
  };
  for (std::size_t e = 0; e < echoes.size(); ++e) {
    for (const Effect* effect : echo_effects_) effect->process(echoes[e], receiver, settings_);
    blur(echoes[e], settings_, scratch.noise.of(key.frame, static_cast<std::uint32_t>(e)));
  }
  for (const DrawingEffect& drawing : reporting_effects_) {
    core::Random own(drawing.keyOf(key));
    const std::size_t known = echoes.size();
    drawing.effect->report(echoes, settings_, own);
    mergeIntruders(echoes, known, stage);
    dropLost();
  }
  for (Echo& echo : echoes) count(echo);
  dropLost();
  std::stable_sort(echoes.begin(), echoes.end(), [](const Echo& a, const Echo& b) { return a.range_m < b.range_m; });
  for (std::size_t e = static_cast<std::size_t>(stage.max_echoes); e < echoes.size(); ++e) {
    echoes[e].fate = Fate::kTooMany;
  }
  dropLost();
  if (record) record->echoes.insert(record->echoes.begin(), echoes.begin(), echoes.end());
}

Fluctuation SignalChain::fluctuationOf(const Beam& beam, const core::Random::Key& shot) const {
  Fluctuation fluctuation;
  for (const DrawingEffect& drawing : fluctuating_effects_) {
    core::Random own(drawing.keyOf(shot));
    double& factor = drawing.effect->fluctuatesOnSurfaces() ? fluctuation.of_surfaces : fluctuation.of_all;
    factor *= drawing.effect->fluctuation(beam, own);
  }
  return fluctuation;
}

/// Most shots are disturbed by nothing: a drop is in few of them, a plume in few beams.
void SignalChain::fireShot(const Loaded& beam, const Receiver& receiver, const core::Random::Key& key,
                           const Disturbances& disturbances, Scratch& scratch, ShotRecord* record) const {
  bool calm = true;
  if (!disturbing_effects_.empty()) {
    scratch.of_shot.assign(beam.pulses.begin(), beam.pulses.end());
    disturbances.disturb(beam.view, key, scratch.of_shot);
    calm = std::equal(scratch.of_shot.begin(), scratch.of_shot.end(), beam.pulses.begin(), beam.pulses.end());
    if (record) record->pulses = scratch.of_shot;
    if (!calm) scratch.parts = partsOf(scratch.of_shot, formOf(settings_), lowestLevel(receiver));
  }
  const Fluctuation fluctuation = fluctuationOf(beam.view.beam, key);
  if (record) record->fluctuation = fluctuation;
  listenTo(calm ? scratch.calm : scratch.parts, receiver, fluctuation, key, scratch, record);
  finish(receiver, key, scratch, record);
}

/// Hears what the beam receives where nothing disturbs it.
void SignalChain::load(const Loaded& beam, const Receiver& receiver, Scratch& scratch) const {
  scratch.of_shot.assign(beam.pulses.begin(), beam.pulses.end());
  scratch.calm = partsOf(scratch.of_shot, formOf(settings_), lowestLevel(receiver));
}

void SignalChain::fireBeam(const Loaded& beam, const RunOptions& options, const Disturbances& disturbances,
                           Scratch& scratch, std::vector<Shot>& out) const {
  const Receiver receiver = receiverOf(beam.view);
  load(beam, receiver, scratch);
  if (scratch.calm.empty() && reporting_effects_.empty() && disturbing_effects_.empty()) return;
  scratch.noise.begin(keyOf(options, options.first_frame, beam.index), static_cast<std::size_t>(options.frames));
  for (int frame = options.first_frame; frame < options.first_frame + options.frames; ++frame) {
    fireShot(beam, receiver, keyOf(options, frame, beam.index), disturbances, scratch, nullptr);
    std::int32_t number = 0;
    for (const Echo& echo : scratch.echoes) {
      out.push_back({beam.index, frame, ++number, echo.range_m, echo.epw_m, kWattToNanowatt * echo.peak_w});
    }
  }
}

/// Beams with one pulse, of a surface, are fired all at once, where nothing but their echo's own noise is random.
void SignalChain::fireLone(const TracedBeams& traced, const RunOptions& options, Scratch& scratch,
                           std::vector<Shot>& out) const {
  LonePulses& lone = scratch.lone;
  out.reserve(lone.size() * static_cast<std::size_t>(options.frames));
  scratch.gain.assign(lone.size(), 1.0);
  for (int frame = options.first_frame; frame < options.first_frame + options.frames; ++frame) {
    const core::Random::Key key = keyOf(options, frame, 0);
    for (std::size_t i = 0; i < lone.size() && !fluctuating_effects_.empty(); ++i) {
      core::Random::Key shot = key;
      shot.beam = lone.beam(i);
      scratch.gain[i] = fluctuationOf(traced.beams[lone.beam(i) - scratch.first_beam], shot).ofSurface();
    }
    lone.fire(settings_, key, scratch.gain);
    for (const Effect* effect : echo_effects_) {
      const double least_w = effect->processesAbove_w(settings_.receiver);
      for (std::size_t i = 0; i < lone.size(); ++i) {
        if (!lone.detected(i)) continue;
        Echo echo = lone.echo(i);
        if (echo.signal_w() <= least_w) continue;
        effect->process(echo, settings_.receiver, settings_);
        lone.setEcho(i, echo);
      }
    }
    lone.blur(settings_);
    lone.count(settings_);
    for (std::size_t i = 0; i < lone.size(); ++i) {
      const Echo echo = lone.echo(i);
      if (!lone.detected(i) || !insideWindow(echo)) continue;
      out.push_back({lone.beam(i), frame, 1, echo.range_m, echo.epw_m, kWattToNanowatt * echo.peak_w});
    }
  }
}

void SignalChain::fireTile(const TracedBeams& traced, const Pulses& pulses, const PowerStage& power,
                           std::size_t first_beam, const RunOptions& options, const Disturbances& disturbances,
                           Scratch& scratch, std::vector<Shot>& out) const {
  const bool closed_form = settings_.emitter.pulse_shape.isGaussian() && disturbing_effects_.empty() &&
                           receiver_effects_.empty() && reporting_effects_.empty();
  scratch.lone.clear();
  scratch.first_beam = first_beam;
  for (std::size_t b = 0; b < traced.beams.size(); ++b) {
    const auto index = static_cast<std::uint32_t>(first_beam + b);
    const std::span<const Pulse> of_beam = pulses.of(b);
    if (closed_form && of_beam.empty()) continue;
    const HitsOfBeam hits = traced.hitsOf(b);
    const BeamView view = power.viewOf(traced.beams[b], hits, traced.rays);
    if (closed_form && of_beam.size() == 1 && of_beam.front().of_surface) {
      scratch.lone.add(index, of_beam.front(), noiseOf_w(view, settings_.receiver));
      continue;
    }
    fireBeam({index, view, of_beam}, options, disturbances, scratch, out);
  }
  if (scratch.lone.size() == 0) return;
  std::vector<Shot> of_lone;
  fireLone(traced, options, scratch, of_lone);
  out = out.empty() ? std::move(of_lone) : merged(frameByFrame(std::span(&out, 1), options), of_lone);
}

std::vector<Shot> SignalChain::run(const GeometryPass& pass, const Scene& scene, const RunOptions& options) const {
  const PowerStage power(settings_, all_effects_, scene);
  const Disturbances disturbances(disturbing_effects_, scene, settings_, keyOf(options, options.first_frame, 0),
                                  options.frames);
  const std::size_t grain = beamsPerTile(pass.rays().size());
  std::vector<std::vector<Shot>> pieces((pass.beams().size() + grain - 1) / grain);
  core::parallelFor(pass.beams().size(), grain, [&](std::size_t begin, std::size_t end) {
    static thread_local Scratch scratch;  // buffers only; every tile overwrites them
    pass.trace(begin, end, scratch.tile);
    const TracedBeams traced{pass.beams().subspan(begin, end - begin),
                             pass.rays(),
                             scratch.tile.hits,
                             0,
                             scratch.tile.second,
                             scratch.tile.first_second};
    power.receive(traced, scratch.power, scratch.pulses);
    fireTile(traced, scratch.pulses, power, begin, options, disturbances, scratch, pieces[begin / grain]);
  });
  return inOneRow(pieces, options);
}

std::vector<Shot> SignalChain::run(const BeamHits& geometry, const Scene& scene, const RunOptions& options) const {
  const PowerStage power(settings_, all_effects_, scene);
  const Pulses coupled = couplesBeams() ? coupledPulses(geometry, power) : Pulses();
  const Disturbances disturbances(disturbing_effects_, scene, settings_, keyOf(options, options.first_frame, 0),
                                  options.frames);
  const std::size_t grain = beamsPerTile(geometry.hits.size() / std::max<std::size_t>(1, geometry.beams.size()));
  std::vector<std::vector<Shot>> pieces((geometry.beams.size() + grain - 1) / grain);
  core::parallelFor(geometry.beams.size(), grain, [&](std::size_t begin, std::size_t end) {
    Scratch scratch;
    const TracedBeams traced = someBeams(geometry, begin, end);
    if (couplesBeams()) {
      for (std::size_t b = begin; b < end; ++b) scratch.pulses.add(coupled.of(b));
    } else {
      power.receive(traced, scratch.power, scratch.pulses);
    }
    fireTile(traced, scratch.pulses, power, begin, options, disturbances, scratch, pieces[begin / grain]);
  });
  return inOneRow(pieces, options);
}

Pulses SignalChain::coupledPulses(const BeamHits& geometry, const PowerStage& power) const {
  PowerStage::Scratch scratch;
  Pulses straight;
  power.receive(someBeams(geometry, 0, geometry.beams.size()), scratch, straight);
  std::vector<std::vector<Pulse>> of_beams;
  for (std::size_t b = 0; b < geometry.beams.size(); ++b) {
    of_beams.emplace_back(straight.of(b).begin(), straight.of(b).end());
  }
  for (const Effect* effect : coupling_effects_) effect->couple(geometry.beams, settings_, of_beams);
  Pulses coupled;
  for (const std::vector<Pulse>& pulses : of_beams) coupled.add(pulses);
  return coupled;
}

ShotRecord SignalChain::record(const BeamHits& geometry, std::size_t beam, const Scene& scene,
                               const RunOptions& options, int frame) const {
  const PowerStage power(settings_, all_effects_, scene);
  const std::vector<Pulse> pulses = pulsesOf(geometry, beam, scene);
  const Pulses coupled = couplesBeams() ? coupledPulses(geometry, power) : Pulses();
  const HitsOfBeam hits = geometry.of(beam);
  const BeamView view = power.viewOf(geometry.beams[beam], hits, geometry.rays);
  const Loaded loaded{static_cast<std::uint32_t>(beam), view, couplesBeams() ? coupled.of(beam) : std::span(pulses)};
  ShotRecord record;
  record.pulses.assign(loaded.pulses.begin(), loaded.pulses.end());
  record.receiver = receiverOf(view);
  Scratch scratch;
  load(loaded, record.receiver, scratch);
  const core::Random::Key key = keyOf(options, frame, loaded.index);
  scratch.noise.begin(key, 1);
  const Disturbances disturbances(disturbing_effects_, scene, settings_, key, 1);
  fireShot(loaded, record.receiver, key, disturbances, scratch, &record);
  return record;
}

core::Detections toDetections(const std::vector<Shot>& shots, const std::vector<Beam>& beams,
                              const SensorProfile& sensor) {
  const bool epw = contains(sensor.detection.output, "epw");
  const bool intensity = contains(sensor.detection.output, "intensity");
  core::Detections detections;
  for (const Shot& shot : shots) {
    const Beam& beam = beams[shot.beam];
    detections.frame.push_back(shot.frame);
    detections.time_s.push_back(beam.time_s);
    detections.layer.push_back(beam.layer);
    detections.azimuth_rad.push_back(beam.azimuth_rad);
    detections.elevation_rad.push_back(beam.elevation_rad);
    detections.echo.push_back(shot.echo);
    detections.range_m.push_back(shot.range_m);
    if (epw) detections.epw_m.push_back(shot.epw_m);
    if (intensity) detections.intensity.push_back(shot.intensity_nw);
  }
  return detections;
}

}  // namespace model
