#include "tests/gap/small_world.h"

#include "core/json_object.h"
#include "model/simulate.h"

namespace test_support {

using nlohmann::json;

namespace {

json sensorJson() {
  json layers = json::array();
  for (const double elevation : {-1.2, -0.4, 0.4, 1.2}) {
    layers.push_back({{"elevation_deg", elevation}, {"azimuth_deg", {{"from", 20}, {"to", -20}, {"step", 1.0}}}});
  }
  return {{"format", "fidelis-sensor"},
          {"version", 1},
          {"id", "small"},
          {"emitter",
           {{"wavelength_nm", 905},
            {"peak_power_w", 50},
            {"pulse_fwhm_ns", 4.5},
            {"divergence_rad", {{"horizontal", 0.002}, {"vertical", 0.004}}},
            {"beam_profile", "uniform"}}},
          {"receiver", {{"aperture_diameter_m", 0.02}, {"efficiency", 0.6}, {"noise_w", 2e-9}, {"threshold_w", 2e-8}}},
          {"scan", {{"frame_rate_hz", 12.5}, {"duty", 0.4}, {"direction", "left-to-right"}, {"layers", layers}}},
          {"detection",
           {{"max_echoes", 3},
            {"echo_separation_m", 0.8},
            {"range_mode", "peak"},
            {"min_range_m", 0.3},
            {"max_range_m", 150},
            {"range_resolution_m", 0.01},
            {"epw_resolution_m", 0.04},
            {"intensity_resolution", 5},
            {"range_noise_m", 0.015},
            {"epw_noise_m", 0.05},
            {"output", {"range", "epw", "intensity"}}}}};
}

/// A pane of glass as large as the wall, between it and the sensor.
void addPane(json& experiment, double at_m) {
  json pane = experiment["scene"][0];
  pane["id"] = "pane";
  pane["material"] = "glass";
  pane["pose"]["position_m"][0] = at_m;
  experiment["scene"].push_back(pane);
  experiment["materials"]["glass"] = {{"reflectivity", 0.1}, {"transmission", 0.7}, {"refractive_index", 1.52}};
}

json experimentJson(double reflectivity, double width_m, const std::map<std::string, double>& offset_m) {
  json samples = json::array();
  const std::map<double, std::string> roles = {{8, "calibration"},  {13, "validation"}, {19, "prediction"},
                                               {27, "calibration"}, {36, "prediction"}, {46, "validation"}};
  for (const auto& [range_m, role] : roles) {
    const std::string id = "r" + std::to_string(static_cast<int>(range_m));
    const auto offset = offset_m.find(id);
    const double placed_m = range_m + (offset == offset_m.end() ? 0.0 : offset->second);
    samples.push_back({{"id", id},
                       {"role", role},
                       {"parameters", {{"stand_off_m", range_m}}},
                       {"patch", {{{"op", "replace"}, {"path", "/scene/0/pose/position_m/0"}, {"value", placed_m}}}},
                       {"frames", 20},
                       {"measurements", "measurements/" + id + ".csv"}});
  }
  return {{"format", "fidelis-experiment"},
          {"version", 1},
          {"id", "small"},
          {"source", "synthetic"},
          {"sensor", sensorJson()},
          {"measurands",
           {{{"name", "range"}, {"column", "range_m"}, {"unit", "m"}, {"resolution", 0.01}},
            {{"name", "epw"}, {"column", "epw_m"}, {"unit", "m"}, {"resolution", 0.04}},
            {{"name", "intensity"}, {"column", "intensity"}, {"unit", "nW"}, {"resolution", 5}}}},
          {"materials", {{"plaster", {{"reflectivity", reflectivity}}}}},
          {"scene",
           {{{"id", "wall"},
             {"shape", {{"type", "rectangle"}, {"width_m", width_m}, {"height_m", 12}}},
             {"pose", {{"position_m", {10, 0, 0}}, {"yaw_pitch_roll_deg", {0, 0, 0}}}},
             {"material", "plaster"}}}},
          {"samples", samples}};
}

}  // namespace

model::LidarModel SmallWorld::withRays(int in_a_row, const Effects& effects,
                                       const std::map<std::string, double>& sensor) {
  nlohmann::json value = modelWith(effects, sensor).json;
  value["rays_per_beam"] = {in_a_row, in_a_row};
  return model::parseModel(value, "small-model.json");
}

model::LidarModel SmallWorld::modelWith(const Effects& effects, const std::map<std::string, double>& sensor) {
  json value = {{"format", "fidelis-model"},
                {"version", 1},
                {"id", "small"},
                {"sensor", sensorJson()},
                {"rays_per_beam", {7, 7}},
                {"seed", 1},
                {"effects", {{"beam-divergence", json::object()}}}};
  for (const auto& [name, parameters] : effects) value["effects"][name] = parameters;
  for (const auto& [pointer, number] : sensor) value[json::json_pointer(pointer)] = number;
  return model::parseModel(value, "small-model.json");
}

model::Experiment SmallWorld::measuredBy(const model::LidarModel& truth, double true_reflectivity,
                                         const std::map<std::string, double>& offset_m) const {
  core::SilentProgress progress;
  const auto real = model::parseExperiment(withThings(true_reflectivity, offset_m), folder_ / "experiment.json");
  const auto measured =
      folder_ / ("measured-" + std::to_string(std::distance(std::filesystem::directory_iterator(folder_.path()),
                                                            std::filesystem::directory_iterator())));
  model::simulatePackage(real, truth, measured, seed_, progress);
  json recorded = withThings(reflectivity_, {});
  for (json& sample : recorded["samples"]) {
    if (known_to_within_m_ <= 0.0) continue;
    sample["epistemic"] = {
        {{"path", "/scene/0/pose/position_m/0"}, {"offset_interval", {-known_to_within_m_, known_to_within_m_}}}};
  }
  core::writeJson(measured / "experiment.json", recorded);
  return model::readExperiment(measured);
}

json SmallWorld::recorded(const std::map<std::string, double>& offset_m) const {
  return withThings(reflectivity_, offset_m);
}

json SmallWorld::withThings(double reflectivity, const std::map<std::string, double>& offset_m) const {
  json experiment = experimentJson(reflectivity, wall_width_m_, offset_m);
  experiment["scene"][0]["pose"]["yaw_pitch_roll_deg"][1] = pitch_deg_;
  if (pane_at_m_ > 0.0) addPane(experiment, pane_at_m_);
  return experiment;
}

SmallWorld& SmallWorld::measuredUnder(std::uint64_t seed) {
  seed_ = seed;
  return *this;
}

SmallWorld& SmallWorld::withAWallOf(double width_m) {
  wall_width_m_ = width_m;
  return *this;
}

SmallWorld& SmallWorld::leaning(double pitch_deg) {
  pitch_deg_ = pitch_deg;
  return *this;
}

SmallWorld& SmallWorld::behindAPane(double at_m) {
  pane_at_m_ = at_m;
  return *this;
}

SmallWorld& SmallWorld::knownToWithin(double half_m) {
  known_to_within_m_ = half_m;
  return *this;
}

}  // namespace test_support
