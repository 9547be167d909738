#include "app/cli/sensors/describe.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fmt/format.h>
#include <ostream>

#include "core/physics.h"
#include "core/text.h"
#include "model/sensor/beams.h"

namespace app::sensors {

using nlohmann::ordered_json;

namespace {

constexpr std::array kReflectivities = {0.1, 0.5, 0.8};
constexpr std::array<std::optional<double>, 3> kVisibilities_m = {std::nullopt, 2000.0, 500.0};

/// Least and greatest of a property of all beams.
struct Span {
  double low = 0.0;
  double high = 0.0;
};

template <typename Property>
Span spanOf(const std::vector<model::Beam>& beams, Property property) {
  const auto [low, high] = std::minmax_element(beams.begin(), beams.end(),
                                               [&](const auto& a, const auto& b) { return property(a) < property(b); });
  return {property(*low), property(*high)};
}

struct Frame {
  std::size_t count;
  Span azimuth_deg, elevation_deg, time_s, gain;
};

Frame frameOf(const model::Scan& scan) {
  const auto beams = model::beamsOf(scan);
  return {beams.size(), spanOf(beams, [](const auto& b) { return b.azimuth_rad * core::kDegPerRad; }),
          spanOf(beams, [](const auto& b) { return b.elevation_rad * core::kDegPerRad; }),
          spanOf(beams, [](const auto& b) { return b.time_s; }), spanOf(beams, [](const auto& b) { return b.gain; })};
}

std::string plain(double value) { return core::significant(value, 4); }

void printLine(std::ostream& out, const char* name, const std::string& text) {
  out << fmt::format("  {:<10} {}\n", name, text);
}

void printNumbers(std::ostream& out, const model::SensorProfile& sensor) {
  const Frame frame = frameOf(sensor.scan);
  const auto& [emitter, receiver, stage] = std::tie(sensor.emitter, sensor.receiver, sensor.detection);
  printLine(out, "beams",
            fmt::format("{} a frame in {} at {} Hz; azimuth {}° to {}°, elevation {}° to {}°", frame.count,
                        counted(model::layerCount(sensor.scan), "layer"), plain(sensor.scan.frame_rate_hz),
                        plain(frame.azimuth_deg.low), plain(frame.azimuth_deg.high), plain(frame.elevation_deg.low),
                        plain(frame.elevation_deg.high)));
  printLine(out, "fired",
            frame.time_s.high > 0.0 ? fmt::format("during {} ms", plain(1e3 * frame.time_s.high)) : "all at once");
  if (emitter.divergence.horizontal_rad > 0.0) {
    printLine(out, "beam",
              fmt::format("{:.3g}° x {:.3g}°, {}", emitter.divergence.horizontal_rad * core::kDegPerRad,
                          emitter.divergence.vertical_rad * core::kDegPerRad,
                          emitter.beam_profile == model::BeamProfile::kUniform ? "uniform" : "Gaussian"));
  }
  printLine(out, "pulse",
            fmt::format("{} W, {} ns, {} nm", plain(emitter.peak_power_w), plain(emitter.pulse_fwhm_ns),
                        plain(emitter.wavelength_nm)));
  if (frame.gain.low < 1.0)
    printLine(out, "gain", fmt::format("{} to {} of it over azimuth", plain(frame.gain.low), plain(frame.gain.high)));
  printLine(out, "receiver",
            fmt::format("aperture {} mm, efficiency {}, threshold {} nW, noise {} nW",
                        plain(1e3 * receiver.aperture_diameter_m), plain(receiver.efficiency),
                        plain(1e9 * receiver.threshold_w), plain(1e9 * receiver.noise_w)));
  printLine(out, "window",
            fmt::format("{} m to {} m, up to {}; {}", plain(stage.min_range_m), plain(stage.max_range_m),
                        stage.max_echoes == 1 ? "1 echo" : fmt::format("{} echoes", stage.max_echoes),
                        core::join(stage.output)));
  if (!sensor.source.empty()) printLine(out, "source", sensor.source);
}

std::string visibilityName(const std::optional<double>& visibility_m) {
  return visibility_m ? fmt::format("visibility {:g} m", *visibility_m) : "clear air";
}

void printBudget(std::ostream& out, const Description& description) {
  out << "\nRange in m up to which a flat, diffuse target that fills the beam is detected in every second frame, and "
         "in\n"
         "99 of 100 frames (at gain 1; the window may end before)\n\n"
      << fmt::format("  {:<14}", "reflectivity");
  for (const auto& visibility_m : kVisibilities_m) out << fmt::format("{:>20}", visibilityName(visibility_m));
  for (std::size_t i = 0; i < description.budget.size(); ++i) {
    const model::LinkBudgetRow& row = description.budget[i];
    if (i % kVisibilities_m.size() == 0)
      out << fmt::format("\n  {:<14}", fmt::format("{:g} %", 100.0 * row.reflectivity));
    out << fmt::format("{:>20}", fmt::format("{:.1f}   {:.1f}", row.half_m, row.sure_m));
  }
  out << fmt::format("\n\nNoise crossings to expect: {} a beam\n",
                     core::significant(model::falseAlarmsPerBeam(description.profile), 2));
}

void printFindings(std::ostream& out, const std::vector<model::Finding>& findings) {
  if (findings.empty()) out << "\nNothing is remarkable.\n";
  for (const model::Finding& finding : findings) {
    out << fmt::format("\n{}: {}: {}\n  {}\n  {}\n", model::toString(finding.severity), finding.pointer,
                       finding.problem, finding.reason, finding.remedy);
  }
}

ordered_json toJson(const Span& span) { return ordered_json::array({span.low, span.high}); }

}  // namespace

model::SensorProfile profileOf(const std::string& name) {
  const std::filesystem::path file(name);
  const bool is_file = std::filesystem::is_regular_file(file) || file.has_parent_path() || file.extension() == ".json";
  if (!is_file) return model::resolveSensorProfile(name, "", "sensors");
  return model::resolveSensorProfile(core::readJson(file), file, "");
}

std::string counted(std::size_t count, const std::string& noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

Description describe(model::SensorProfile profile) {
  Description description{.profile = std::move(profile)};
  description.findings = model::plausibilityOf(description.profile);
  description.budget = model::linkBudget(description.profile, kReflectivities, kVisibilities_m);
  return description;
}

bool hasError(const Description& description) {
  return std::any_of(description.findings.begin(), description.findings.end(),
                     [](const model::Finding& finding) { return finding.severity == model::Severity::kError; });
}

void print(std::ostream& out, const Description& description) {
  out << fmt::format("{}: {}\n", description.profile.id, description.profile.title);
  printNumbers(out, description.profile);
  printBudget(out, description);
  printFindings(out, description.findings);
}

ordered_json summary(const model::SensorProfile& profile) {
  return {{"id", profile.id},
          {"title", profile.title},
          {"wavelength_nm", profile.emitter.wavelength_nm},
          {"frame_rate_hz", profile.scan.frame_rate_hz},
          {"layers", model::layerCount(profile.scan)},
          {"beams_per_frame", static_cast<std::size_t>(model::beamCount(profile.scan))},
          {"max_echoes", profile.detection.max_echoes},
          {"max_range_m", profile.detection.max_range_m},
          {"output", profile.detection.output},
          {"source", profile.source}};
}

ordered_json toJson(const Description& description) {
  const Frame frame = frameOf(description.profile.scan);
  ordered_json json{{"format", "fidelis-sensor-check"}, {"version", 1}, {"sensor", summary(description.profile)}};
  json["frame"] = {{"azimuth_deg", toJson(frame.azimuth_deg)},
                   {"elevation_deg", toJson(frame.elevation_deg)},
                   {"time_s", toJson(frame.time_s)},
                   {"gain", toJson(frame.gain)}};
  json["link_budget"] = ordered_json::array();
  for (const model::LinkBudgetRow& row : description.budget) {
    json["link_budget"].push_back(
        {{"reflectivity", row.reflectivity},
         {"visibility_m", row.visibility_m ? ordered_json(*row.visibility_m) : ordered_json(nullptr)},
         {"range_half_m", row.half_m},
         {"range_99_m", row.sure_m}});
  }
  json["false_alarms_per_beam"] = model::falseAlarmsPerBeam(description.profile);
  json["findings"] = ordered_json::array();
  for (const model::Finding& finding : description.findings) {
    json["findings"].push_back({{"severity", model::toString(finding.severity)},
                                {"pointer", finding.pointer},
                                {"problem", finding.problem},
                                {"reason", finding.reason},
                                {"remedy", finding.remedy}});
  }
  return json;
}

}  // namespace app::sensors
