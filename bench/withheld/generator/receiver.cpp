#include "bench/withheld/generator/receiver.h"

#include <algorithm>
#include <cmath>

#include "bench/withheld/generator/vec.h"

namespace withheld {

namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kPlanckTimesC_Wsm = 1.98644586e-25;
constexpr double kFilter_nm = 12.0, kExcessNoise = 3.0;
constexpr double kOnUprightSurface = 1.0 / 3.0;  // of the irradiance of level ground

// 0 outside, 1 inside an interval of angles [deg], linear over a quarter of a degree at its ends.
double softSector(double at, double from, double to) {
  constexpr double kEdge = 0.25;
  return std::clamp((at - from) / kEdge + 0.5, 0.0, 1.0) * std::clamp((to - at) / kEdge + 0.5, 0.0, 1.0);
}

}  // namespace

double darkCurrentRatio(double temperature_degC) {
  constexpr double kGapOverTwiceBoltzmann_K = 1.12 / (2.0 * 8.617333e-5);
  const double t0 = 293.15, t = 273.15 + temperature_degC;
  return std::pow(t / t0, 1.5) * std::exp(kGapOverTwiceBoltzmann_K * (1.0 / t0 - 1.0 / t));
}

double circleOverlap(double a, double b, double d) {
  if (d >= a + b) return 0.0;
  if (d <= std::abs(a - b)) return b >= a ? 1.0 : (b * b) / (a * a);
  const double at_a = std::acos((d * d + a * a - b * b) / (2 * d * a)),
               at_b = std::acos((d * d + b * b - a * a) / (2 * d * b));
  const double lens = a * a * (at_a - 0.5 * std::sin(2 * at_a)) + b * b * (at_b - 0.5 * std::sin(2 * at_b));
  return lens / (kPi * a * a);
}

Receiver::Receiver(const Profile& profile, const Effects& effects, const Environment& environment, std::uint64_t seed)
    : profile_(profile), effects_(effects), environment_(environment) {
  const std::string name = "photo-response-nonuniformity";
  int layers = 0;
  for (const Beam& beam : profile.scan) layers = std::max(layers, beam.layer + 1);
  layer_gain_.assign(static_cast<std::size_t>(std::max(layers, 1)), 1.0);
  if (!effects.on(name)) return;
  const std::vector<double> given = effects.list(name, "gain_per_layer");
  const double spread = effects.number(name, "stddev", 0.1), width = std::sqrt(std::log1p(spread * spread));
  Dice dice(seed, Use::pattern, {static_cast<std::uint64_t>(effects.number(name, "pattern", 1.0))});
  for (std::size_t i = 0; i < layer_gain_.size(); ++i) {
    const double drawn = std::exp(width * dice.normal() - 0.5 * width * width);
    layer_gain_[i] = given.empty() ? drawn : given[std::min(i, given.size() - 1)];
  }
}

double Receiver::gain(const Beam& beam) const {
  const double azimuth = beam.azimuth_rad / kDegree;
  double gain = beam.gain * layer_gain_[std::min(static_cast<std::size_t>(beam.layer), layer_gain_.size() - 1)];
  if (const std::string name = "cover-contamination"; effects_.on(name)) {
    const double inside = softSector(azimuth, effects_.number(name, "azimuth_from_deg", -180.0),
                                     effects_.number(name, "azimuth_to_deg", 180.0));
    const double passed = 1.0 - inside * effects_.number(name, "attenuation", 0.3);
    gain *= passed * passed;
  }
  if (effects_.on("x-gain-ramp")) gain *= std::exp(effects_.number("x-gain-ramp", "per_degree", 0.0) * azimuth);
  if (const std::string name = "blinding"; effects_.on(name)) {
    const double full = effects_.number(name, "saturation_irradiance", 10.0);
    gain *= std::max(0.0, 1.0 - blinded(beam) * effects_.number(name, "irradiance", 1.0) / full);
  }
  return gain;
}

double Receiver::blinded(const Beam& beam) const {
  const double middle = effects_.number("blinding", "azimuth_deg", 0.0);
  const double half = 0.5 * effects_.number("blinding", "width_deg", 5.0);
  return effects_.on("blinding") ? softSector(beam.azimuth_rad / kDegree, middle - half, middle + half) : 0.0;
}

double Receiver::overlap(double range_m) const {
  if (!effects_.on("aperture-offset")) return 1.0;
  const double apart = effects_.number("aperture-offset", "offset_m", profile_.axis_offset_m);
  const double beam = std::max(1e-6, 0.5 * profile_.divergence_h_rad * range_m);
  return circleOverlap(beam, 0.5 * profile_.aperture_m + 0.5 * profile_.fov_h_rad * range_m, apart);
}

// 2 hν F B P: the variance of the power that shot noise of the light P looks like, at the input.
double Receiver::shotVariance(double light_w) const {
  const double photon_J = kPlanckTimesC_Wsm / (profile_.wavelength_nm * 1e-9);
  const double bandwidth_hz = 0.44 / (profile_.fwhm_ns * 1e-9);
  return 2.0 * photon_J * kExcessNoise * bandwidth_hz * light_w;
}

double Receiver::backgroundLight_w(const Beam& beam, double reflectivity) const {
  const std::string name = "background-light";
  const double irradiance = effects_.number(name, "irradiance_w_m2_nm", environment_.irradiance_w_m2_nm.value_or(0.0));
  double radiance = kOnUprightSurface * irradiance * reflectivity / kPi;
  const auto height = effects_.number(name, "sun_elevation_deg");
  if (height && *height > 0.0) {
    const Vec sun = direction(effects_.number(name, "sun_azimuth_deg", 0.0) * kDegree, *height * kDegree);
    const double away = std::acos(std::clamp(dot(sun, direction(beam.azimuth_rad, beam.elevation_rad)), -1.0, 1.0));
    radiance += irradiance * std::exp(-away / (6.0 * kDegree));
  }
  const double area_m2 = kPi / 4.0 * profile_.aperture_m * profile_.aperture_m;
  return radiance * kFilter_nm * area_m2 * profile_.efficiency * profile_.fov_h_rad * profile_.fov_v_rad;
}

double Receiver::noise_w(const Beam& beam, double reflectivity) const {
  double variance = profile_.noise_w * profile_.noise_w;
  if (const std::string name = "thermal-noise"; effects_.on(name)) {
    const double share = effects_.number(name, "dark_share", 1.0);
    const double temperature = effects_.number(name, "temperature_degC", environment_.temperature_degC.value_or(20.0));
    variance *= 1.0 - share + share * darkCurrentRatio(temperature);
  }
  if (effects_.on("background-light")) variance += shotVariance(backgroundLight_w(beam, reflectivity));
  if (const double inside = blinded(beam); inside > 0.0) {
    const double area_m2 = kPi / 4.0 * profile_.aperture_m * profile_.aperture_m;
    variance += shotVariance(inside * effects_.number("blinding", "irradiance", 1.0) * area_m2 * profile_.efficiency);
  }
  return std::sqrt(variance);
}

double Receiver::threshold_w(double range_m, double noise_w) const {
  const std::string name = "dynamic-threshold";
  if (!effects_.on(name)) return profile_.threshold_w;
  const double level = effects_.number(name, "factor", 5.0) * noise_w, near = effects_.number(name, "window", 0.0);
  return range_m > 0.0 && range_m < near ? level * near * near / (range_m * range_m) : level;
}

double Receiver::noiseEchoes(double noise_w) const {
  if (!effects_.on("x-noise-echoes")) return 0.0;
  const auto rate = [&](double sigma, double threshold) {
    return sigma > 0.0 ? std::exp(-0.5 * threshold * threshold / (sigma * sigma)) : 0.0;
  };
  const double crossings_1_ns = 0.44 / profile_.fwhm_ns / std::sqrt(3.0);
  const double listening_ns = 2.0 * profile_.max_range_m / kLight_m_ns;
  const double more =
      rate(noise_w, threshold_w(profile_.max_range_m, noise_w)) - rate(profile_.noise_w, profile_.threshold_w);
  return std::clamp(crossings_1_ns * listening_ns * more, 0.0, 50.0);
}

}  // namespace withheld
