#include "tests/objects/street.h"

namespace test_objects {

json sensor() {
  json value = json::parse(R"({
    "format": "fidelis-sensor", "version": 1, "id": "street-scanner",
    "emitter": {"wavelength_nm": 905, "peak_power_w": 75, "pulse_fwhm_ns": 5,
                "divergence_rad": {"horizontal": 0.001, "vertical": 0.001}, "beam_profile": "uniform"},
    "receiver": {"aperture_diameter_m": 0.05, "efficiency": 0.9, "noise_w": 0, "threshold_w": 1e-9},
    "scan": {"frame_rate_hz": 10, "duty": 0.5, "direction": "left-to-right", "layers": []},
    "detection": {"max_echoes": 1, "echo_separation_m": 0.5, "range_mode": "peak", "min_range_m": 0.1,
                  "max_range_m": 100, "output": ["range", "epw", "intensity"]}
  })");
  for (int layer = 0; layer < 30; ++layer) {
    value["scan"]["layers"].push_back(
        {{"elevation_deg", -12.0 + 0.5 * layer}, {"azimuth_deg", {{"from", 40}, {"to", -40}, {"step", 0.2}}}});
  }
  return value;
}

json car(const std::string& id, double x_m, double y_m, double yaw_deg) {
  return {{"id", id},
          {"shape", {{"type", "box"}, {"size_m", {4.5, 1.8, 1.5}}}},
          {"pose", {{"position_m", {x_m, y_m, -0.75}}, {"yaw_pitch_roll_deg", {yaw_deg, 0, 0}}}},
          {"material", "grey"}};
}

json streetJson(int frames) {
  return {{"format", "fidelis-experiment"},
          {"version", 1},
          {"id", "street"},
          {"source", "synthetic"},
          {"sensor", sensor()},
          {"measurands", {{{"name", "range"}, {"column", "range_m"}, {"unit", "m"}, {"resolution", 0.01}}}},
          {"materials", {{"grey", {{"reflectivity", 0.5}}}}},
          {"scene",
           {{{"id", "street"},
             {"shape", {{"type", "plane"}}},
             {"pose", {{"position_m", {0, 0, -1.5}}, {"yaw_pitch_roll_deg", {0, 0, 0}}}},
             {"material", "grey"}},
            car("near", 15, -4, 20),
            car("far", 25, 5, 0)}},
          {"gates", {{{"id", "near-car"}, {"object", "near"}, {"margin_m", 0.1}}}},
          {"samples", {{{"id", "s"}, {"frames", frames}, {"measurements", "measurements/s.csv"}}}}};
}

json modelJson() {
  return {{"format", "fidelis-model"}, {"version", 1}, {"id", "street-scanner"},   {"sensor", sensor()},
          {"rays_per_beam", {1, 1}},   {"seed", 1},    {"effects", json::object()}};
}

model::Experiment experimentOf(const json& value) { return model::parseExperiment(value, "experiment.json"); }

core::Detections fire(const model::Experiment& experiment) {
  return model::simulate(experiment, model::parseModel(modelJson(), "model.json"), 0);
}

}  // namespace test_objects
