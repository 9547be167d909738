#include "model/signal/signal_chain.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/parallel.h"
#include "core/physics.h"

namespace model {

namespace {

constexpr double kWattToNanowatt = 1e9;
/// The noise lowers the level by at most this share of the threshold (formats.md section 3, step 4).
constexpr double kLargestNoise = 0.9;

double rounded(double value, double step) { return step > 0.0 ? std::round(value / step) * step : value; }

/// Stretches whose peaks lie closer than the separation are one echo, each compared with the one before it.
void mergeNearStretches(std::vector<Stretch>& stretches, double separation_m) {
  std::sort(stretches.begin(), stretches.end(), [](const Stretch& a, const Stretch& b) { return a.peak_m < b.peak_m; });
  std::size_t kept = 0;
  double last_peak_m = 0.0;
  for (const Stretch& stretch : stretches) {
    if (kept > 0 && stretch.peak_m - last_peak_m < separation_m) {
      Stretch& merged = stretches[kept - 1];
      merged.rise_m = std::min(merged.rise_m, stretch.rise_m);
      merged.fall_m = std::max(merged.fall_m, stretch.fall_m);
      if (stretch.peak_w > merged.peak_w) {
        merged.peak_w = stretch.peak_w;
        merged.peak_m = stretch.peak_m;
      }
    } else {
      stretches[kept++] = stretch;
    }
    last_peak_m = stretch.peak_m;
  }
  stretches.resize(kept);
}

bool contains(const std::vector<std::string>& list, const char* name) {
  return std::find(list.begin(), list.end(), name) != list.end();
}

}  // namespace

/// Buffers that one thread reuses from beam to beam.
struct SignalChain::Scratch {
  std::vector<Stretch> stretches;
  std::vector<Stretch> of_part;
  std::vector<Echo> echoes;
};

core::Random SignalChain::Drawing::stream(core::Random::Key key) const {
  key.purpose = purpose;
  return core::Random(key);
}

SignalChain::SignalChain(const SensorProfile& sensor, const std::vector<ActiveEffect>& effects,
                         const Environment& environment) {
  settings_.emitter = sensor.emitter;
  settings_.receiver = sensor.receiver;
  settings_.detection = sensor.detection;
  for (const ActiveEffect& active : effects) {
    effects_.push_back(findEffect(active.name)->make(active.parameters));
    const Effect* effect = effects_.back().get();
    effect->prepare(settings_, environment);
    const std::uint32_t purpose = core::purposeOf(active.name.c_str());
    if (effect->changesPower()) power_effects_.push_back(effect);
    if (effect->fluctuates()) fluctuating_effects_.push_back({effect, purpose});
    if (effect->reports()) reporting_effects_.push_back({effect, purpose});
  }
}

SignalChain::~SignalChain() = default;
SignalChain::SignalChain(SignalChain&&) noexcept = default;
SignalChain& SignalChain::operator=(SignalChain&&) noexcept = default;

void SignalChain::aim(std::vector<Beam>& beams) const {
  for (const auto& effect : effects_) effect->aim(beams);
}

std::vector<Pulse> SignalChain::pulsesOf(const Beam& beam, std::span<const Hit> hits, const Scene& scene) const {
  const double aperture_m2 =
      std::numbers::pi / 4.0 * settings_.receiver.aperture_diameter_m * settings_.receiver.aperture_diameter_m;
  const double constant =
      settings_.emitter.peak_power_w * settings_.receiver.efficiency * aperture_m2 / std::numbers::pi;
  std::vector<Pulse> pulses;
  std::vector<std::int32_t> objects;
  for (const Hit& hit : hits) {
    const Material& material = scene.materials[scene.objects[static_cast<std::size_t>(hit.object)].material];
    double power_w = constant * hit.weight * material.reflectivity * hit.cos_incidence / (hit.range_m * hit.range_m);
    const Reflection reflection{beam, hit.azimuth_rad, hit.range_m, hit.cos_incidence, material};
    for (const Effect* effect : power_effects_) power_w *= effect->powerFactor(reflection);
    if (settings_.broadens_pulses) {
      pulses.push_back({hit.range_m, power_w});
      continue;
    }
    const auto known = std::find(objects.begin(), objects.end(), hit.object) - objects.begin();
    if (known == static_cast<std::ptrdiff_t>(objects.size())) {
      objects.push_back(hit.object);
      pulses.push_back({});
    }
    Pulse& pulse = pulses[static_cast<std::size_t>(known)];
    pulse.range_m += power_w * hit.range_m;  // divided by the power below
    pulse.power_w += power_w;
  }
  if (!settings_.broadens_pulses) {
    for (Pulse& pulse : pulses) {
      if (pulse.power_w > 0.0) pulse.range_m /= pulse.power_w;
    }
  }
  return pulses;
}

Echo SignalChain::toEcho(const Stretch& stretch) const {
  Echo echo;
  switch (settings_.detection.range_mode) {
    case RangeMode::kPeak:
      echo.range_m = stretch.peak_m;
      break;
    case RangeMode::kLeadingEdge:
      echo.range_m = stretch.rise_m;
      break;
    case RangeMode::kCentre:
      echo.range_m = 0.5 * (stretch.rise_m + stretch.fall_m);
      break;
  }
  echo.epw_m = 2.0 * (stretch.fall_m - stretch.rise_m);  // r = c t / 2, so c·Δt = 2·Δr
  echo.peak_w = stretch.peak_w;
  return echo;
}

void SignalChain::fireFrame(const Beam& beam, const std::vector<WaveformPart>& parts, const core::Random::Key& key,
                            Scratch& scratch) const {
  const Receiver& receiver = settings_.receiver;
  core::Random random(key);
  double gain = 1.0;
  for (const Drawing& drawing : fluctuating_effects_) {
    core::Random own = drawing.stream(key);
    gain *= drawing.effect->fluctuation(beam, own);
  }
  scratch.stretches.clear();
  scratch.echoes.clear();
  for (const WaveformPart& part : parts) {
    const double noise_w = std::min(receiver.noise_w * random.normal(), kLargestNoise * receiver.threshold_w);
    scratch.of_part.clear();
    if (gain > 0.0)
      part.stretchesAbove(std::max((receiver.threshold_w - noise_w) / gain, part.lowest_level_w()), scratch.of_part);
    for (Stretch& stretch : scratch.of_part) {
      stretch.peak_w = gain * stretch.peak_w + noise_w;  // from here on with noise, so that merged echoes keep it
      scratch.stretches.push_back(stretch);
    }
  }
  mergeNearStretches(scratch.stretches, settings_.detection.echo_separation_m);
  for (const Stretch& stretch : scratch.stretches) scratch.echoes.push_back(toEcho(stretch));
  finish(scratch.echoes, random, key);
}

/// Everything behind the detection of echoes: time base, noise, losses, rounding, window, numbering.
void SignalChain::finish(std::vector<Echo>& echoes, core::Random& random, const core::Random::Key& key) const {
  const DetectionStage& stage = settings_.detection;
  for (Echo& echo : echoes) {
    for (const auto& effect : effects_) effect->process(echo, settings_);
    echo.range_m = settings_.range_scale * echo.range_m + settings_.range_offset_m;
    const double range_noise = random.normal(), epw_noise = random.normal();
    echo.range_m += stage.range_noise_m * range_noise;
    echo.epw_m += stage.epw_noise_m * epw_noise;
  }
  for (const Drawing& drawing : reporting_effects_) {
    core::Random own = drawing.stream(key);
    drawing.effect->report(echoes, settings_, own);
  }
  for (Echo& echo : echoes) {
    echo.range_m = rounded(echo.range_m, stage.range_resolution_m);
    echo.epw_m = std::max(0.0, rounded(echo.epw_m, stage.epw_resolution_m));
    echo.peak_w = rounded(kWattToNanowatt * echo.peak_w, stage.intensity_resolution_nw) / kWattToNanowatt;
  }
  std::erase_if(echoes, [&](const Echo& e) { return e.range_m < stage.min_range_m || e.range_m > stage.max_range_m; });
  std::stable_sort(echoes.begin(), echoes.end(), [](const Echo& a, const Echo& b) { return a.range_m < b.range_m; });
  if (echoes.size() > static_cast<std::size_t>(stage.max_echoes))
    echoes.resize(static_cast<std::size_t>(stage.max_echoes));
}

void SignalChain::fireBeam(std::uint32_t index, const BeamHits& geometry, const Scene& scene, const RunOptions& options,
                           Scratch& scratch, std::vector<Shot>& out) const {
  const Beam& beam = geometry.beams[index];
  std::vector<Pulse> pulses = pulsesOf(beam, geometry.of(index), scene);
  // The tails below the lowest level are cut off; a tenth of the threshold keeps that cut away from the crossings.
  const double share = 1.0 - kLargestNoise;
  const double spread = fluctuating_effects_.empty() ? 1.0 : 0.1;  // a bright fluctuation lowers the level further
  const double width_m = core::kMetresPerNanosecond * settings_.emitter.pulse_fwhm_ns / 2.0;
  const auto parts = partsOf(pulses, width_m, settings_.receiver.threshold_w * share * spread);
  if (parts.empty() && reporting_effects_.empty()) return;
  for (int frame = 0; frame < options.frames; ++frame) {
    const core::Random::Key key{.seed = options.seed,
                                .sample = options.sample,
                                .frame = static_cast<std::uint32_t>(frame),
                                .beam = index,
                                .purpose = core::purposeOf("receiver")};
    fireFrame(beam, parts, key, scratch);
    std::int32_t number = 0;
    for (const Echo& echo : scratch.echoes) {
      out.push_back({index, frame, ++number, echo.range_m, echo.epw_m, kWattToNanowatt * echo.peak_w});
    }
  }
}

std::vector<Shot> SignalChain::run(const BeamHits& geometry, const Scene& scene, const RunOptions& options) const {
  constexpr std::size_t kGrain = 64;
  const std::size_t count = geometry.beams.size();
  std::vector<std::vector<Shot>> pieces((count + kGrain - 1) / kGrain);
  core::parallelFor(count, kGrain, [&](std::size_t begin, std::size_t end) {
    Scratch scratch;
    for (std::size_t b = begin; b < end; ++b) {
      fireBeam(static_cast<std::uint32_t>(b), geometry, scene, options, scratch, pieces[begin / kGrain]);
    }
  });
  // Beams came one after the other; the result goes frame by frame (a stable counting sort).
  std::vector<std::size_t> position(static_cast<std::size_t>(options.frames) + 1, 0);
  for (const auto& piece : pieces) {
    for (const Shot& shot : piece) ++position[static_cast<std::size_t>(shot.frame) + 1];
  }
  for (std::size_t f = 1; f < position.size(); ++f) position[f] += position[f - 1];
  std::vector<Shot> shots(position.back());
  for (const auto& piece : pieces) {
    for (const Shot& shot : piece) shots[position[static_cast<std::size_t>(shot.frame)]++] = shot;
  }
  return shots;
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
