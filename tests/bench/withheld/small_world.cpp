#include "tests/bench/withheld/small_world.h"

#include <numbers>
#include <sstream>

namespace small_world {

using nlohmann::json;

json sensor() {
  json layers = json::array();
  for (const double elevation : {-1.5, -0.5, 0.5, 1.5}) {
    layers.push_back({{"elevation_deg", elevation}, {"azimuth_deg", {{"from", 10}, {"to", -10}, {"step", 1}}}});
  }
  return {{"format", "fidelis-sensor"},
          {"version", 1},
          {"id", "small"},
          {"title", "small"},
          {"source", "invented for tests"},
          {"emitter",
           {{"wavelength_nm", 905},
            {"peak_power_w", 50},
            {"pulse_fwhm_ns", 4},
            {"divergence_rad", {{"horizontal", 0.002}, {"vertical", 0.008}}},
            {"beam_profile", "gaussian"}}},
          {"receiver",
           {{"aperture_diameter_m", 0.025},
            {"efficiency", 0.8},
            {"axis_offset_m", 0.0},
            {"field_of_view_rad", {{"horizontal", 0.006}, {"vertical", 0.012}}},
            {"noise_w", 0},
            {"threshold_w", 2.5e-8}}},
          {"scan", {{"frame_rate_hz", 20}, {"duty", 0.5}, {"direction", "left-to-right"}, {"layers", layers}}},
          {"detection",
           {{"max_echoes", 3},
            {"echo_separation_m", 0.6},
            {"range_mode", "peak"},
            {"min_range_m", 0.5},
            {"max_range_m", 150},
            {"range_resolution_m", 1e-6},
            {"epw_resolution_m", 1e-6},
            {"intensity_resolution", 1e-6},
            {"range_noise_m", 0},
            {"epw_noise_m", 0},
            {"output", {"range", "epw", "intensity"}}}}};
}

json experiment(const std::vector<double>& ranges_m, int frames) {
  json samples = json::array();
  for (std::size_t i = 0; i < ranges_m.size(); ++i) {
    const std::string id = "s" + std::to_string(i);
    samples.push_back({{"id", id},
                       {"role", "validation"},
                       {"parameters", {{"range_m", ranges_m[i]}}},
                       {"patch", {{{"op", "replace"}, {"path", "/scene/0/pose/position_m/0"}, {"value", ranges_m[i]}}}},
                       {"frames", frames},
                       {"measurements", "measurements/" + id + ".csv.gz"}});
  }
  const auto measurand = [](const char* name, const char* column, double resolution) {
    return json{{"name", name}, {"column", column}, {"unit", "m"}, {"scale", "interval"}, {"resolution", resolution}};
  };
  return {{"format", "fidelis-experiment"},
          {"version", 1},
          {"id", "small"},
          {"title", "board"},
          {"source", "synthetic"},
          {"sensor", sensor()},
          {"measurands", {measurand("range", "range_m", 0.01), measurand("epw", "epw_m", 0.03)}},
          {"environment", {{"temperature_degC", 20}}},
          {"materials", {{"board", {{"reflectivity", 0.5}, {"brdf", {{"model", "lambertian"}}}}}}},
          {"scene",
           {{{"id", "target"},
             {"shape", {{"type", "rectangle"}, {"width_m", 40}, {"height_m", 40}}},
             {"pose", {{"position_m", {10, 0, 0}}, {"yaw_pitch_roll_deg", {0, 0, 0}}}},
             {"material", "board"}}}},
          {"samples", samples}};
}

json model(const json& effects) {
  return {{"format", "fidelis-model"}, {"version", 1}, {"id", "world"},     {"sensor", sensor()},
          {"rays_per_beam", {21, 21}}, {"seed", 3},    {"effects", effects}};
}

double boardPower_w(double range_m) {
  const double area_m2 = std::numbers::pi / 4 * 0.025 * 0.025;
  return 50.0 * 0.8 * area_m2 * 0.5 / std::numbers::pi / (range_m * range_m);
}

Table parsed(const std::string& csv) {
  std::istringstream lines(csv);
  std::string line, cell;
  std::getline(lines, line);
  std::vector<std::string> names;
  for (std::istringstream header(line); std::getline(header, cell, ',');) names.push_back(cell);
  Table table;
  for (const std::string& name : names) table[name];
  while (std::getline(lines, line)) {
    std::istringstream cells(line);
    for (const std::string& name : names) {
      std::getline(cells, cell, ',');
      table[name].push_back(std::stod(cell));
    }
  }
  return table;
}

Table generated(const json& experiment, const json& model, const json& truth) {
  const test_support::TemporaryFolder folder;
  folder.write("package/experiment.json", experiment.dump());
  const auto world_file = folder.write("world.json", model.dump());
  const std::string truth_file = truth.is_null() ? "" : folder.write("truth.json", truth.dump()).string();
  const withheld::World world = withheld::readWorld(world_file, "");
  const withheld::Package package = withheld::readPackage(folder / "package", truth_file, world.seed);
  return parsed(withheld::simulate(package, world, world.seed, 1).front());
}

}  // namespace small_world
