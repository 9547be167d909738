#include "tests/model/lab.h"

#include <cmath>
#include <numbers>

#include "core/error.h"

namespace model::lab {

json sensor() {
  return json::parse(R"({
    "format": "fidelis-sensor", "version": 1, "id": "bench",
    "emitter": {"wavelength_nm": 905, "peak_power_w": 75, "pulse_fwhm_ns": 5,
                "divergence_rad": {"horizontal": 0.003, "vertical": 0.003}, "beam_profile": "uniform"},
    "receiver": {"aperture_diameter_m": 0.02, "efficiency": 0.5, "noise_w": 0, "threshold_w": 20e-9},
    "scan": {"frame_rate_hz": 10, "duty": 0.5, "direction": "left-to-right",
             "layers": [{"elevation_deg": 0, "azimuth_deg": {"from": 0, "to": 0, "step": 1}}]},
    "detection": {"max_echoes": 5, "echo_separation_m": 0.5, "range_mode": "peak", "min_range_m": 0.01,
                  "max_range_m": 1000, "output": ["range", "epw", "intensity"]}
  })");
}

json object(const std::string& id, json shape, std::vector<double> position_m, std::vector<double> yaw_pitch_roll_deg,
            const std::string& material) {
  return {{"id", id},
          {"shape", std::move(shape)},
          {"pose", {{"position_m", position_m}, {"yaw_pitch_roll_deg", yaw_pitch_roll_deg}}},
          {"material", material}};
}

json board(double range_m, double size_m, const std::string& material, const std::string& id) {
  return object(id, {{"type", "rectangle"}, {"width_m", size_m}, {"height_m", size_m}}, {range_m, 0, 0}, {0, 0, 0},
                material);
}

json experimentJson(const Case& setup) {
  return {{"format", "fidelis-experiment"},
          {"version", 1},
          {"id", "bench"},
          {"sensor", setup.sensor},
          {"measurands", {{{"name", "range"}, {"column", "range_m"}, {"unit", "m"}, {"resolution", 0.01}}}},
          {"environment", setup.environment},
          {"materials", setup.materials},
          {"scene", setup.scene},
          {"samples", {{{"id", "s"}, {"frames", setup.frames}}}}};
}

json modelJson(const Case& setup) {
  return {{"format", "fidelis-model"},
          {"version", 1},
          {"id", "bench"},
          {"sensor", setup.sensor},
          {"rays_per_beam", setup.rays_per_beam},
          {"seed", setup.seed},
          {"effects", setup.effects}};
}

Experiment experimentOf(const Case& setup) { return parseExperiment(experimentJson(setup), setup.file); }
LidarModel modelOf(const Case& setup) { return parseModel(modelJson(setup), "model.json"); }

core::Detections fire(const Case& setup) { return simulate(experimentOf(setup), modelOf(setup), 0); }

std::vector<Pulse> pulses(const Case& setup) {
  const Experiment experiment = experimentOf(setup);
  const LidarModel model = modelOf(setup);
  const TracedSample traced = traceSample(experiment, model, experiment.samples[0]);
  const SignalChain chain(model.sensor(""), model.effects, traced.situation.environment);
  return chain.pulsesOf(traced.hits, 0, traced.situation.scene);
}

double power_w(const Case& setup) {
  double sum = 0.0;
  for (const Pulse& pulse : pulses(setup)) sum += pulse.power_w;
  return sum;
}

double radarEquation(double range_m, double reflectivity, double cos_incidence) {
  constexpr double kDiameter_m = 0.02, kEfficiency = 0.5;
  const double aperture_m2 = std::numbers::pi * kDiameter_m * kDiameter_m / 4.0;
  return kPeakPower_w * kEfficiency * (reflectivity / std::numbers::pi) * cos_incidence * aperture_m2 /
         (range_m * range_m);
}

double epwLaw(double power_w, double threshold_w) {
  return 0.299792458 * kFwhm_ns * std::sqrt(std::log2(power_w / threshold_w));
}

double mean(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

double deviation(const std::vector<double>& values) {
  const double centre = mean(values);
  double sum = 0.0;
  for (const double value : values) sum += (value - centre) * (value - centre);
  return std::sqrt(sum / static_cast<double>(values.size() - 1));
}

double normalCdf(double z) { return 0.5 * std::erfc(-z / std::numbers::sqrt2); }

std::string refusal(const std::function<void()>& action) {
  try {
    action();
  } catch (const core::InputError& error) {
    return error.what();
  }
  return "";
}

}  // namespace model::lab
