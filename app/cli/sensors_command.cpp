#include <CLI/CLI.hpp>
#include <algorithm>
#include <fmt/format.h>
#include <ostream>

#include "app/cli/commands.h"
#include "core/file.h"
#include "model/sensor/beams.h"

namespace app {

namespace {

/// The shipped profiles, in order of their names.
std::vector<model::SensorProfile> shippedProfiles() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(core::resourceFolder() / "sensors")) {
    if (entry.path().extension() == ".json") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  std::vector<model::SensorProfile> profiles;
  for (const auto& file : files) profiles.push_back(model::resolveSensorProfile(file.stem().string(), file, ""));
  return profiles;
}

nlohmann::ordered_json toJson(const model::SensorProfile& profile) {
  return {{"id", profile.id},
          {"title", profile.title},
          {"wavelength_nm", profile.emitter.wavelength_nm},
          {"frame_rate_hz", profile.scan.frame_rate_hz},
          {"layers", profile.scan.layers.size()},
          {"beams_per_frame", model::beamsOf(profile.scan).size()},
          {"max_echoes", profile.detection.max_echoes},
          {"max_range_m", profile.detection.max_range_m},
          {"output", profile.detection.output},
          {"source", profile.source}};
}

}  // namespace

void addSensorsCommand(CLI::App& program, Session& session) {
  auto file = std::make_shared<std::string>();
  CLI::App* command = program.add_subcommand("sensors", "List the sensor profiles that come with the program");
  command->add_option("--json", *file, "Write the list as JSON; '-' is standard output");
  command->footer(
      "A model or an experiment names a profile by its id, or holds one itself.\n\nExample:\n  fidelis sensors --json "
      "-");
  command->callback([file, &session] {
    nlohmann::ordered_json json{
        {"format", "fidelis-sensors"}, {"version", 1}, {"sensors", nlohmann::ordered_json::array()}};
    for (const model::SensorProfile& profile : shippedProfiles()) {
      json["sensors"].push_back(toJson(profile));
      if (!file->empty()) continue;
      session.out << fmt::format("{:<18} {} layers, {} beams a frame at {:g} Hz, up to {:g} m: {}\n", profile.id,
                                 profile.scan.layers.size(), model::beamsOf(profile.scan).size(),
                                 profile.scan.frame_rate_hz, profile.detection.max_range_m, profile.title);
    }
    if (!file->empty()) session.writeJsonTo(*file, json);
  });
}

}  // namespace app
