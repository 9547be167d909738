#include "bench/withheld/generator/effects.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "bench/withheld/generator/bad_input.h"

namespace withheld {

namespace {

constexpr double kAny = 1e12;

Parameter place(const char* name) { return {name, 0, 0, Parameter::Kind::place}; }
Parameter list(const char* name) { return {name, 0, 0, Parameter::Kind::list}; }
Parameter law(const char* name) { return {name, 0, 0, Parameter::Kind::law}; }

std::vector<std::string> namesOf(const EffectEntry& entry) {
  std::vector<std::string> names{"sensors"};
  for (const Parameter& parameter : entry.parameters) names.push_back(parameter.name);
  return names;
}

const EffectEntry& entryOf(const std::string& name, const std::string& place) {
  const auto& all = allEffects();
  const auto found = std::find_if(all.begin(), all.end(), [&](const EffectEntry& e) { return e.name == name; });
  if (found != all.end()) return *found;
  std::vector<std::string> names;
  for (const EffectEntry& entry : all) names.push_back(entry.name);
  throw BadInput(place + "/" + name, "is no effect that this generator knows.",
                 fmt::format("The nearest known effect is '{}'.", nearestOf(name, names)));
}

void checkBounds(const Parameter& parameter, const Fields& fields) {
  using Kind = Parameter::Kind;
  if (!fields.find(parameter.name)) return;
  if (parameter.kind == Kind::law) (void)fields.oneOf(parameter.name, {"lambertian", "oren-nayar", "phong"}, "");
  if (parameter.kind == Kind::place) (void)fields.numbers(parameter.name, 3);
  if (parameter.kind == Kind::list) (void)fields.numbers(parameter.name);
  if (parameter.kind != Kind::number) return;
  const double number = fields.number(parameter.name);
  if (number < parameter.low || number > parameter.high) {
    throw BadInput(fields.placeOf(parameter.name),
                   fmt::format("{} is not in [{}, {}].", number, parameter.low, parameter.high),
                   "Give a number in between.");
  }
}

}  // namespace

const std::vector<EffectEntry>& allEffects() {
  static const std::vector<EffectEntry> all = {
      // emission
      {"beam-divergence", {{"horizontal_rad", 0, 0.2}, {"vertical_rad", 0, 0.2}}},
      {"aperture-offset", {{"offset_m", 0, 0.1}}},
      {"stray-radiation", {{"fraction", 0, 0.01}, {"half_angle_rad", 0.002, 0.1}}},
      {"mounting-error", {{"yaw_deg", -5, 5}, {"pitch_deg", -5, 5}, {"roll_deg", -5, 5}, place("position_m")}},
      {"pulse-jitter", {{"duration_stddev_ns", 0, 1}, {"power_stddev", 0, 0.2}}},
      // propagation
      {"atmospheric-attenuation",
       {{"visibility_m", 20, 20000}, {"rain_rate_mm_h", 0, 100}, {"extinction_1_m", 0, 0.2}}},
      {"atmospheric-backscatter", {{"visibility_m", 20, 20000}, {"backscatter_1_m_sr", 1e-7, 0.1}}},
      {"precipitation-clutter", {{"rain_rate_mm_h", 0, 100}, {"snow_rate_mm_h", 0, 20}, {"window_m", 0.001, 0.1}}},
      {"road-spray",
       {{"density", 0, 10},
        {"plume_length_m", 1, 50},
        {"plume_width_m", 0.5, 6},
        {"plume_height_m", 0.2, 5},
        {"extinction_1_m", 0.001, 1},
        {"least_speed_m_s", 1, 25}}},
      {"exhaust-cloud", {{"extinction_1_m", 0, 10}, {"size_m", 0.1, 10}, {"albedo", 0, 1}, place("centre")}},
      {"crosstalk", {{"rate_1_s", 0, 1e6}}},
      {"spoofing",
       {{"azimuth_deg", -180, 180}, {"range_m", 0, 300}, {"width_deg", 0.01, 360}, {"power_w", 1e-10, 1e-3}}},
      {"blinding",
       {{"azimuth_deg", -180, 180},
        {"irradiance", 0, 1000},
        {"width_deg", 0.01, 360},
        {"saturation_irradiance", 0.01, 1000}}},
      // interaction
      {"angular-reflection",
       {{"roughness_rad", 0, 1.6}, {"diffuse_fraction", 0, 1}, {"exponent", 1, 1000}, law("model")}},
      {"surface-moisture", {{"wetness", 0, 1}}},
      {"retroreflection", {{"gain", 10, 1e5}, {"half_width_rad", 0.01, 1.5}}},
      {"transmission", {{"transmission", 0, 1}, {"refractive_index", 1, 4}}},
      {"multipath", {{"max_bounces", 2, 4}, {"specular_fraction", 0, 1}}},
      {"pulse-broadening", {}},
      {"speckle", {{"looks", 1, 100}}},
      {"motion-scan", {{"ego_speed_m_s", -80, 80}}},
      // reception
      {"cover-contamination", {{"attenuation", 0, 1}, {"azimuth_from_deg", -180, 180}, {"azimuth_to_deg", -180, 180}}},
      {"photo-response-nonuniformity", {{"stddev", 0, 0.5}, {"pattern", 0, 1e6}, list("gain_per_layer")}},
      {"background-light",
       {{"irradiance_w_m2_nm", 0, 1}, {"sun_azimuth_deg", -180, 180}, {"sun_elevation_deg", -90, 90}}},
      {"thermal-noise", {{"temperature_degC", -40, 85}, {"dark_share", 0, 1}}},
      {"saturation", {{"saturation_w", 1e-10, 1e-3}, {"recovery_ns", 0, 50}}},
      {"blooming", {{"fraction", 0, 0.1}, {"neighbours", 1, 20}}},
      {"dead-time", {{"dead_time_ns", 1, 100}}},
      // pre-processing
      {"range-walk", {{"coefficient_m", -2, 2}, {"calibrated_at_snr", 1, 1e6}}},
      {"dynamic-threshold", {{"factor", 1, 50}, {"window", 0, 100}}},
      {"quantisation",
       {{"range_step_m", 0, 2}, {"epw_step_m", 0, 2}, {"intensity_bits", 1, 24}, {"intensity_full_scale_nw", 1, 1e9}}},
      {"range-gating", {{"from_m", 0, 1000}, {"to_m", 0, 1000}}},
      {"echo-merging", {{"separation_m", 0, 10}}},
      {"latency", {{"delay_s", 0, 0.5}}},
      {"clock-drift", {{"scale_ppm", -2000, 2000}, {"per_kelvin_ppm", -200, 200}}},
      {"range-offset", {{"offset_m", -0.5, 0.5}}},
      // detection
      {"angle-clipping", {}},
      {"false-alarm", {{"rate_per_beam", 0, 0.1}}},
      {"detection-loss", {{"probability", 0, 1}}},
      // outside the library
      {"x-range-ripple", {{"amplitude_m", -kAny, kAny}, {"period_m", 1e-3, kAny}}},
      {"x-facet-wobble", {{"amplitude_m", -kAny, kAny}, {"facets", 2, 16}}},
      {"x-epw-temperature", {{"per_kelvin", -1, 1}}},
      {"x-layer-skew", {{"epw_per_layer_m", -kAny, kAny}}},
      {"x-epw-compression", {{"knee_m", 0, kAny}, {"slope", 0, 10}}},
      {"x-dropout-stripes", {{"period_deg", 1e-3, 360}, {"width_deg", 0, 360}, {"probability", 0, 1}}},
      {"x-gain-ramp", {{"per_degree", -1, 1}}},
      {"x-range-scatter", {{"per_metre", 0, 1}}},
      {"x-warm-up", {{"range_m", -kAny, kAny}, {"frames", 1e-3, kAny}}},
      {"x-layer-range", {{"amplitude_m", -kAny, kAny}}},
      {"x-noise-echoes", {}},
  };
  return all;
}

Effects::Effects(const Json& json, const std::string& place) {
  if (!json.is_object()) throw BadInput(place, "is not an object.", "Write {\"effect\": {parameters}, …}.");
  for (const auto& [name, parameters] : json.items()) {
    const EffectEntry& entry = entryOf(name, place);
    const Fields fields(parameters, place + "/" + name, namesOf(entry));
    for (const Parameter& parameter : entry.parameters) checkBounds(parameter, fields);
    given_[name] = parameters;
  }
}

Effects Effects::of(const std::string& sensor) const {
  Effects own = *this;
  std::erase_if(own.given_, [&](const auto& entry) {
    if (!entry.second.contains("sensors")) return false;
    const auto sensors = entry.second["sensors"].template get<std::vector<std::string>>();
    return std::find(sensors.begin(), sensors.end(), sensor) == sensors.end();
  });
  return own;
}

std::optional<double> Effects::number(const std::string& effect, const std::string& parameter) const {
  const auto found = given_.find(effect);
  if (found == given_.end()) return {};
  const auto value = found->second.find(parameter);
  return value == found->second.end() || value->is_null() ? std::nullopt : std::optional(value->get<double>());
}

std::vector<double> Effects::list(const std::string& effect, const std::string& parameter) const {
  const auto found = given_.find(effect);
  if (found == given_.end() || !found->second.contains(parameter)) return {};
  return found->second[parameter].get<std::vector<double>>();
}

std::string Effects::text(const std::string& effect, const std::string& parameter) const {
  const auto found = given_.find(effect);
  if (found == given_.end() || !found->second.contains(parameter)) return {};
  return found->second[parameter].get<std::string>();
}

}  // namespace withheld
