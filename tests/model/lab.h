#pragma once

#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/detections.h"
#include "model/simulate.h"

/// A bench for the laws of the signal chain: one noise-free beam straight ahead unless a test says otherwise.
namespace model::lab {

using nlohmann::json;

/// 75 W, 5 ns, D = 20 mm, efficiency 0.5, threshold 20 nW; one beam along +x of 3 mrad × 3 mrad; no noise, no rounding,
/// range at the peak, up to 5 echoes, 0.01 m … 1000 m.
inline constexpr double kPeakPower_w = 75.0;
inline constexpr double kFwhm_ns = 5.0;
inline constexpr double kThreshold_w = 20e-9;
[[nodiscard]] json sensor();

[[nodiscard]] json object(const std::string& id, json shape, std::vector<double> position_m,
                          std::vector<double> yaw_pitch_roll_deg = {0, 0, 0}, const std::string& material = "grey");
/// A square board across the x axis.
[[nodiscard]] json board(double range_m, double size_m = 20.0, const std::string& material = "grey",
                         const std::string& id = "board");

/// What one simulated shot series depends on.
struct Case {
  json sensor = lab::sensor();
  json scene = json::array();
  json materials = {{"grey", {{"reflectivity", 0.5}}}};
  json environment = json::object();
  json effects = json::object();
  std::vector<int> rays_per_beam = {1, 1};
  int frames = 1;
  std::uint64_t seed = 7;
  std::filesystem::path file = "experiment.json";
};

[[nodiscard]] json experimentJson(const Case& setup);
[[nodiscard]] json modelJson(const Case& setup);
[[nodiscard]] Experiment experimentOf(const Case& setup);
[[nodiscard]] LidarModel modelOf(const Case& setup);
[[nodiscard]] core::Detections fire(const Case& setup);
/// The pulses of the first beam with their noise-free powers.
[[nodiscard]] std::vector<Pulse> pulses(const Case& setup);
/// Their sum: the received peak power of everything in the beam. [W]
[[nodiscard]] double power_w(const Case& setup);

/// Laser radar equation of a Lambertian, beam-filling surface; written down again, not taken from the model. [W]
[[nodiscard]] double radarEquation(double range_m, double reflectivity = 0.5, double cos_incidence = 1.0);
/// EPW of one Gaussian pulse: c · FWHM · sqrt(log2(P/P_th)). [m]
[[nodiscard]] double epwLaw(double power_w, double threshold_w = kThreshold_w);

[[nodiscard]] double mean(const std::vector<double>& values);
/// With n - 1.
[[nodiscard]] double deviation(const std::vector<double>& values);
/// CDF of the standard normal distribution.
[[nodiscard]] double normalCdf(double z);

/// The message of the InputError that `action` throws; "" if it throws none.
[[nodiscard]] std::string refusal(const std::function<void()>& action);

}  // namespace model::lab
