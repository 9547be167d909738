#include "bench/withheld/generator/profile.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "bench/withheld/generator/bad_input.h"
#include "bench/withheld/generator/vec.h"

namespace withheld {

namespace {

void readEmitter(const Fields& emitter, Profile& profile) {
  profile.wavelength_nm = emitter.number("wavelength_nm");
  profile.peak_power_w = emitter.number("peak_power_w");
  profile.fwhm_ns = emitter.number("pulse_fwhm_ns");
  profile.gaussian_beam = emitter.oneOf("beam_profile", {"uniform", "gaussian"}, "uniform") == "gaussian";
  if (const Json* width = emitter.find("divergence_rad")) {
    const Fields full(*width, emitter.placeOf("divergence_rad"), {"horizontal", "vertical"});
    profile.divergence_h_rad = full.number("horizontal");
    profile.divergence_v_rad = full.number("vertical");
  }
  if (!(profile.fwhm_ns > 0.0)) throw BadInput(emitter.placeOf("pulse_fwhm_ns"), "is not positive.", "Give ns > 0.");
}

void readReceiver(const Fields& receiver, Profile& profile) {
  profile.aperture_m = receiver.number("aperture_diameter_m");
  profile.efficiency = receiver.number("efficiency");
  profile.axis_offset_m = receiver.number("axis_offset_m", 0.0);
  profile.noise_w = receiver.number("noise_w", 0.0);
  profile.threshold_w = receiver.number("threshold_w");
  profile.saturation_w = receiver.maybe("saturation_w");
  if (const Json* view = receiver.find("field_of_view_rad")) {
    const Fields full(*view, receiver.placeOf("field_of_view_rad"), {"horizontal", "vertical"});
    profile.fov_h_rad = full.number("horizontal");
    profile.fov_v_rad = full.number("vertical");
  }
  if (!(profile.threshold_w > 0.0)) throw BadInput(receiver.placeOf("threshold_w"), "is not positive.", "Give W > 0.");
}

void readDetection(const Fields& detection, Profile& profile) {
  profile.max_echoes = static_cast<int>(detection.number("max_echoes", 1));
  profile.separation_m = detection.number("echo_separation_m", 0.0);
  const std::string mode = detection.oneOf("range_mode", {"peak", "leading-edge", "centre"}, "peak");
  profile.mode = mode == "peak" ? RangeMode::peak : mode == "centre" ? RangeMode::centre : RangeMode::leading_edge;
  profile.min_range_m = detection.number("min_range_m", 0.0);
  profile.max_range_m = detection.number("max_range_m");
  profile.range_step_m = detection.number("range_resolution_m", 0.0);
  profile.epw_step_m = detection.number("epw_resolution_m", 0.0);
  profile.intensity_step_nw = detection.number("intensity_resolution", 0.0);
  profile.range_noise_m = detection.number("range_noise_m", 0.0);
  profile.epw_noise_m = detection.number("epw_noise_m", 0.0);
  for (const Json& output : detection.at("output")) {
    profile.has_epw |= output == "epw";
    profile.has_intensity |= output == "intensity";
  }
}

// Straight between the points, held beyond them.
double interpolated(const std::vector<double>& xs, const std::vector<double>& ys, double x) {
  if (x <= xs.front()) return ys.front();
  if (x >= xs.back()) return ys.back();
  const auto after = static_cast<std::size_t>(std::upper_bound(xs.begin(), xs.end(), x) - xs.begin());
  const double share = (x - xs[after - 1]) / (xs[after] - xs[after - 1]);
  return ys[after - 1] + share * (ys[after] - ys[after - 1]);
}

struct ScanLayer {
  std::vector<double> azimuths_deg, elevations_deg, gains;
  double delay_s = 0.0;
};

ScanLayer readLayer(const Fields& layer) {
  ScanLayer result;
  const Fields azimuth(layer.at("azimuth_deg"), layer.placeOf("azimuth_deg"), {"from", "to", "step"});
  const double from = azimuth.number("from"), to = azimuth.number("to"), step = azimuth.number("step");
  if (!(step > 0.0)) throw BadInput(azimuth.placeOf("step"), "is not positive.", "Give degrees > 0.");
  const auto columns = static_cast<int>(std::floor(std::abs(to - from) / step + 1e-6)) + 1;
  const std::vector<double> curve =
      layer.find("elevation_curve_deg") ? layer.numbers("elevation_curve_deg") : std::vector<double>{};
  std::vector<double> gain_at{0.0}, gain{1.0};
  if (const Json* table = layer.find("azimuth_gain")) {
    const Fields points(*table, layer.placeOf("azimuth_gain"), {"azimuth_deg", "gain"});
    gain_at = points.numbers("azimuth_deg");
    gain = points.numbers("gain", gain_at.size());
  }
  for (int i = 0; i < columns; ++i) {
    const double at = from + (to > from ? step : -step) * i;
    double elevation = layer.number("elevation_deg"), power = 1.0;
    for (const double coefficient : curve) {
      elevation += coefficient * power;
      power *= at;
    }
    result.azimuths_deg.push_back(at);
    result.elevations_deg.push_back(elevation);
    result.gains.push_back(interpolated(gain_at, gain, at));
  }
  result.delay_s = layer.number("time_offset_s", 0.0);
  return result;
}

// Column k of n fires at k/n of the scanning part of the period; the direction alone decides the order.
void readScan(const Fields& scan, Profile& profile) {
  if (scan.find("lissajous")) {
    throw BadInput(scan.placeOf("lissajous"), "is not simulated here.", "Use a profile with layers.");
  }
  const bool falling = scan.oneOf("direction", {"left-to-right", "right-to-left"}, "left-to-right") == "left-to-right";
  const bool at_once = scan.oneOf("firing", {"in-turn", "at-once"}, "in-turn") == "at-once";
  std::vector<ScanLayer> layers;
  std::vector<double> azimuths;
  for (std::size_t i = 0; i < scan.at("layers").size(); ++i) {
    const Fields layer(scan.at("layers")[i], scan.placeOf("layers") + "/" + std::to_string(i),
                       {"elevation_deg", "azimuth_deg", "azimuth_gain", "elevation_curve_deg", "time_offset_s"});
    layers.push_back(readLayer(layer));
    azimuths.insert(azimuths.end(), layers.back().azimuths_deg.begin(), layers.back().azimuths_deg.end());
  }
  const auto before = [falling](double a, double b) { return falling ? a > b : a < b; };
  std::sort(azimuths.begin(), azimuths.end(), before);
  azimuths.erase(
      std::unique(azimuths.begin(), azimuths.end(), [](double a, double b) { return std::abs(a - b) < 1e-7; }),
      azimuths.end());
  const double active_s = scan.number("duty", 1.0) / scan.number("frame_rate_hz");
  for (std::size_t l = 0; l < layers.size(); ++l) {
    for (std::size_t i = 0; i < layers[l].azimuths_deg.size(); ++i) {
      const double at = layers[l].azimuths_deg[i];
      const auto place = std::lower_bound(azimuths.begin(), azimuths.end(), at + (falling ? 5e-8 : -5e-8), before);
      const auto column = static_cast<int>(place - azimuths.begin());
      const double swept_s = at_once ? 0.0 : active_s * column / static_cast<double>(azimuths.size());
      profile.scan.push_back({static_cast<int>(l), column, at * kDegree, layers[l].elevations_deg[i] * kDegree,
                              swept_s + layers[l].delay_s, layers[l].gains[i]});
    }
  }
  std::stable_sort(profile.scan.begin(), profile.scan.end(), [](const Beam& a, const Beam& b) {
    return a.layer != b.layer ? a.layer < b.layer : a.column < b.column;
  });
}

}  // namespace

Profile readProfile(const Json& json, const std::string& place) {
  const Fields fields(json, place,
                      {"format", "version", "id", "title", "source", "emitter", "receiver", "scan", "detection"});
  Profile profile;
  readEmitter({fields.at("emitter"),
               fields.placeOf("emitter"),
               {"wavelength_nm", "peak_power_w", "pulse_fwhm_ns", "divergence_rad", "beam_profile"}},
              profile);
  readReceiver({fields.at("receiver"),
                fields.placeOf("receiver"),
                {"aperture_diameter_m", "efficiency", "axis_offset_m", "field_of_view_rad", "noise_w", "threshold_w",
                 "saturation_w"}},
               profile);
  readDetection({fields.at("detection"),
                 fields.placeOf("detection"),
                 {"max_echoes", "echo_separation_m", "range_mode", "min_range_m", "max_range_m", "range_resolution_m",
                  "epw_resolution_m", "intensity_resolution", "range_noise_m", "epw_noise_m", "output"}},
                profile);
  readScan({fields.at("scan"),
            fields.placeOf("scan"),
            {"frame_rate_hz", "duty", "direction", "firing", "layers", "lissajous"}},
           profile);
  return profile;
}

}  // namespace withheld
