#include "tests/acceptance/small_project.h"

#include <fmt/format.h>

namespace acceptance_test {

namespace {

constexpr int kFrames = 40;

constexpr const char* kSensor = R"({
  "format": "fidelis-sensor", "version": 1, "id": "one-beam", "title": "one beam", "source": "made up",
  "emitter": {"wavelength_nm": 905, "peak_power_w": 50.0, "pulse_fwhm_ns": 4.5,
              "divergence_rad": {"horizontal": 0.0014, "vertical": 0.014}, "beam_profile": "uniform"},
  "receiver": {"aperture_diameter_m": 0.025, "efficiency": 0.8, "axis_offset_m": 0.0,
               "field_of_view_rad": {"horizontal": 0.003, "vertical": 0.02},
               "noise_w": 1.0e-9, "threshold_w": 5.0e-9, "saturation_w": null},
  "scan": {"frame_rate_hz": 12.5, "duty": 0.4, "direction": "left-to-right",
           "layers": [{"elevation_deg": 0.0, "azimuth_deg": {"from": 0, "to": 0, "step": 1}}]},
  "detection": {"max_echoes": 3, "echo_separation_m": 1.5, "range_mode": "peak", "min_range_m": 0.3,
                "max_range_m": 200, "range_resolution_m": 0.01, "epw_resolution_m": 0.04, "intensity_resolution": 1,
                "range_noise_m": 0.01, "epw_noise_m": 0.03, "output": ["range", "epw"]}})";

std::string sampleJson(double range_m, const std::string& role) {
  return fmt::format(
      R"({{"id": "r{0}", "role": "{1}", "parameters": {{"range_m": {0}}},
           "patch": [{{"op": "replace", "path": "/scene/0/pose/position_m/0", "value": {0}}}],
           "epistemic": [{{"path": "/scene/0/pose/position_m/0", "offset_interval": [-0.002, 0.002]}}],
           "frames": {2}, "measurements": "measurements/r{0}.csv"}})",
      range_m, role, kFrames);
}

std::string experimentJson(const std::string& source) {
  return fmt::format(
      R"({{"format": "fidelis-experiment", "version": 1, "id": "wall", "title": "a wide wall", "source": "{}",
           "sensor": {},
           "measurands": [{{"name": "range", "column": "range_m", "unit": "m", "scale": "ratio", "resolution": 0.01}},
                          {{"name": "epw", "column": "epw_m", "unit": "m", "scale": "ratio", "resolution": 0.04}}],
           "environment": {{"visibility_m": null}},
           "materials": {{"grey": {{"reflectivity": 0.5, "brdf": {{"model": "lambertian"}}}}}},
           "scene": [{{"id": "wall", "shape": {{"type": "rectangle", "width_m": 4.0, "height_m": 4.0}},
                       "pose": {{"position_m": [10, 0, 0], "yaw_pitch_roll_deg": [0, 0, 0]}},
                       "velocity_m_s": [0, 0, 0], "material": "grey"}}],
           "gates": [{{"id": "front", "object": "wall", "margin_m": 0.5}}],
           "samples": [{}, {}, {}]}})",
      source, kSensor, sampleJson(8, "validation"), sampleJson(10, "validation"), sampleJson(12, "prediction"));
}

std::string measurements(double range_m) {
  std::string csv = "frame,layer,azimuth_rad,elevation_rad,echo,range_m\n";
  for (int frame = 0; frame < kFrames; ++frame) {
    const double spread_m = 0.04 * (frame + 0.5) / kFrames - 0.02;
    csv += fmt::format("{},0,0,0,1,{:.4f}\n", frame, range_m + spread_m);
  }
  return csv;
}

}  // namespace

SmallProject::SmallProject(const Settings& settings) {
  folder_.write("wall/experiment.json", experimentJson(settings.source));
  for (const double range_m : {8.0, 10.0, 12.0}) {
    folder_.write(fmt::format("wall/measurements/r{}.csv", range_m), measurements(range_m + settings.offset_m));
  }
  folder_.write("model.json", fmt::format(R"({{"format": "fidelis-model", "version": 1, "id": "plain", "sensor": {},
                                               "rays_per_beam": [3, 3], "seed": 7, "effects": {{}}}})",
                                          kSensor));
  specs::ProjectStore store = specs::ProjectStore::create(file());
  specs::Requirement requirement;
  requirement.id = "RangeError_Requirement_1";
  requirement.title = "The range is right";
  requirement.status = specs::Status::Accepted;
  store.add(requirement, kSomebody);
}

specs::AcceptanceTest SmallProject::rangeTest(const std::string& id, const std::string& expression) {
  specs::AcceptanceTest test;
  test.id = id;
  test.title = "range on a wall";
  test.status = specs::Status::Accepted;
  test.experiment = "wall";
  test.model = "model.json";
  test.measurand = "range";
  test.metric = "dvm";
  test.expression = expression;
  return test;
}

void SmallProject::addTest(const std::string& id, const std::string& expression) const {
  specs::ProjectStore store = open();
  store.add(rangeTest(id, expression), kSomebody);
  store.link({.from = "RangeError_Requirement_1", .to = id}, kSomebody);
}

}  // namespace acceptance_test
