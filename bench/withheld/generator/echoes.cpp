#include "bench/withheld/generator/echoes.h"

#include <algorithm>
#include <cmath>

#include "bench/withheld/generator/vec.h"

namespace withheld {

namespace {

double toStep(double value, double step) { return step > 0.0 ? step * std::round(value / step) : value; }

double metres(double time_ns) { return 0.5 * kLight_m_ns * time_ns; }

}  // namespace

Echoes::Echoes(const Profile& profile, const Effects& effects, const Environment& environment, const Pulse& pulse)
    : profile_(profile),
      effects_(effects),
      pulse_(pulse),
      above_20_degC_(environment.temperature_degC.value_or(20.0) - 20.0),
      from_m_(effects.number("range-gating", "from_m", profile.min_range_m)),
      to_m_(effects.number("range-gating", "to_m", profile.max_range_m)) {}

// Each is compared with the one before it; a group lasts from its first rise to its last fall and has the highest peak.
void Echoes::merge(std::vector<Waveform::Stretch>& stretches) const {
  const double least_m = effects_.number("echo-merging", "separation_m", profile_.separation_m);
  std::sort(stretches.begin(), stretches.end(), [](const auto& a, const auto& b) { return a.peak_ns < b.peak_ns; });
  std::vector<Waveform::Stretch> groups;
  double last_peak_ns = -1e300;
  for (const Waveform::Stretch& stretch : stretches) {
    if (!groups.empty() && metres(stretch.peak_ns - last_peak_ns) < least_m) {
      Waveform::Stretch& group = groups.back();
      group.rise_ns = std::min(group.rise_ns, stretch.rise_ns);
      group.fall_ns = std::max(group.fall_ns, stretch.fall_ns);
      if (stretch.peak_w > group.peak_w) group.peak_w = stretch.peak_w, group.peak_ns = stretch.peak_ns;
    } else {
      groups.push_back(stretch);
    }
    last_peak_ns = stretch.peak_ns;
  }
  stretches = std::move(groups);
}

void Echoes::blindAfterEcho(std::vector<Waveform::Stretch>& stretches) const {
  if (!effects_.on("dead-time")) return;
  const double blind_ns = effects_.number("dead-time", "dead_time_ns", 1.0);
  double ready_ns = -1e300;
  std::erase_if(stretches, [&](const Waveform::Stretch& stretch) {
    const bool blind = stretch.rise_ns < ready_ns;
    ready_ns = stretch.rise_ns + blind_ns;  // also by one that is not seen
    return blind;
  });
}

// Amann et al. 2001, doi:10.1117/1.1330700: the crossing comes late by the part of the front below the threshold.
double Echoes::rangeOf(const Waveform::Stretch& stretch, double threshold_w) const {
  const std::string walk = "range-walk";
  const double by_mode = profile_.mode == RangeMode::peak     ? metres(stretch.peak_ns)
                         : profile_.mode == RangeMode::centre ? metres(0.5 * (stretch.rise_ns + stretch.fall_ns))
                                                              : metres(stretch.rise_ns);
  if (!effects_.on(walk)) return by_mode;
  const auto coefficient = effects_.number(walk, "coefficient_m"), snr = effects_.number(walk, "calibrated_at_snr");
  if (coefficient) {
    const double over = std::max(1.0, stretch.peak_w / threshold_w);
    return by_mode + *coefficient / over;
  }
  return metres(stretch.rise_ns) + (snr ? metres(pulse_.riseFrom(*snr)) : 0.0);
}

void Echoes::driftAndOffset(Detection& detection) const {
  if (const std::string name = "clock-drift"; effects_.on(name)) {
    const double ppm =
        effects_.number(name, "scale_ppm", 0.0) + effects_.number(name, "per_kelvin_ppm", 0.0) * above_20_degC_;
    detection.range_m /= 1.0 - ppm * 1e-6;
    detection.epw_m /= 1.0 - ppm * 1e-6;
  }
  detection.range_m += effects_.number("range-offset", "offset_m", 0.0);
}

void Echoes::unknownErrors(Detection& detection, const Beam& beam, Dice& outputs) const {
  const auto given = [&](const char* effect, const char* parameter, double otherwise = 0.0) {
    return effects_.number(effect, parameter, otherwise);
  };
  constexpr double kTurn = 2.0 * std::numbers::pi;
  // phase interpolation inside one clock period
  detection.range_m += given("x-range-ripple", "amplitude_m") *
                       std::sin(kTurn * detection.range_m / given("x-range-ripple", "period_m", 1.0));
  // mirror facets at different distances: columns alternate
  const double facets = given("x-facet-wobble", "facets", 2.0);
  detection.range_m +=
      given("x-facet-wobble", "amplitude_m") * std::cos(kTurn * std::fmod(beam.column, facets) / facets);
  detection.range_m += given("x-layer-range", "amplitude_m") * (beam.layer % 2 == 0 ? 1.0 : -1.0);
  detection.range_m += given("x-warm-up", "range_m") * std::exp(-detection.frame / given("x-warm-up", "frames", 10.0));
  if (effects_.on("x-range-scatter")) {
    detection.range_m += given("x-range-scatter", "per_metre") * detection.range_m * outputs.normal();
  }
  detection.epw_m *= 1.0 + given("x-epw-temperature", "per_kelvin") * above_20_degC_;
  detection.epw_m += given("x-layer-skew", "epw_per_layer_m") * beam.layer;
  if (effects_.on("x-epw-compression")) {
    const double over = detection.epw_m - given("x-epw-compression", "knee_m", 0.0);
    if (over > 0.0) detection.epw_m -= (1.0 - given("x-epw-compression", "slope", 1.0)) * over;
  }
}

void Echoes::quantise(Detection& detection) const {
  const std::string name = "quantisation";
  if (!effects_.on(name)) return;
  if (const double step = effects_.number(name, "epw_step_m", 0.0); step > 0.0) {
    const double rise_m = 2.0 * detection.range_m - 0.5 * detection.epw_m;  // both edges on the axis c·t
    detection.epw_m = toStep(rise_m + detection.epw_m, step) - toStep(rise_m, step);
  }
  detection.range_m = toStep(detection.range_m, effects_.number(name, "range_step_m", 0.0));
  if (const auto bits = effects_.number(name, "intensity_bits")) {
    const double full_nw = effects_.number(name, "intensity_full_scale_nw", 1e5);
    const double step_nw = full_nw / (std::exp2(*bits) - 1.0);
    detection.intensity_nw = toStep(std::min(detection.intensity_nw, full_nw), step_nw);
  }
}

bool Echoes::lost(const Beam& beam, Dice& losses) const {
  bool lost = effects_.on("detection-loss") && losses.uniform() < effects_.number("detection-loss", "probability", 0.0);
  if (const std::string name = "x-dropout-stripes"; effects_.on(name)) {
    const double period = effects_.number(name, "period_deg", 10.0);
    const double place = beam.azimuth_rad / kDegree + 1000.0 * period;
    const bool inside = std::fmod(place, period) < effects_.number(name, "width_deg", 0.0);
    lost |= inside && losses.uniform() < effects_.number(name, "probability", 1.0);
  }
  return lost;
}

std::vector<Detection> Echoes::read(std::vector<Waveform::Stretch> stretches, const Beam& beam, int frame,
                                    double threshold_w, Dice& outputs, Dice& losses) const {
  merge(stretches);
  blindAfterEcho(stretches);
  std::vector<Detection> detections;
  for (const Waveform::Stretch& stretch : stretches) {
    Detection detection{frame,
                        0,
                        1,
                        rangeOf(stretch, threshold_w),
                        kLight_m_ns * (stretch.fall_ns - stretch.rise_ns),
                        stretch.peak_w * 1e9};
    driftAndOffset(detection);
    unknownErrors(detection, beam, outputs);
    detection.range_m += profile_.range_noise_m * outputs.normal();
    detection.epw_m = std::max(0.0, detection.epw_m + profile_.epw_noise_m * outputs.normal());
    quantise(detection);
    detection.range_m = toStep(detection.range_m, profile_.range_step_m);
    detection.epw_m = toStep(detection.epw_m, profile_.epw_step_m);
    detection.intensity_nw = toStep(detection.intensity_nw, profile_.intensity_step_nw);
    if (detection.range_m < from_m_ || detection.range_m > to_m_ || lost(beam, losses)) continue;
    detection.echo = static_cast<int>(detections.size()) + 1;
    if (detection.echo <= profile_.max_echoes) detections.push_back(detection);
  }
  return detections;
}

}  // namespace withheld
