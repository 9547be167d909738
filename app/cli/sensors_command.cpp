#include <CLI/CLI.hpp>
#include <algorithm>
#include <fmt/format.h>
#include <ostream>

#include "app/cli/commands.h"
#include "app/cli/sensors/describe.h"
#include "core/error.h"
#include "core/file.h"

namespace app {

namespace {

struct Options {
  std::string name;
  std::string json;
  std::string svg;
};

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

void listAll(const Options& options, Session& session) {
  if (!options.svg.empty())
    throw core::InputError({.item = "--svg"}, "needs the name of a profile.", "Write: fidelis sensors NAME --svg FILE");
  nlohmann::ordered_json json{
      {"format", "fidelis-sensors"}, {"version", 1}, {"sensors", nlohmann::ordered_json::array()}};
  for (const model::SensorProfile& profile : shippedProfiles()) {
    const nlohmann::ordered_json row = sensors::summary(profile);
    json["sensors"].push_back(row);
    if (!options.json.empty()) continue;
    session.out << fmt::format("{:<18} {}, {} beams a frame at {:.3g} Hz, up to {:g} m: {}\n", profile.id,
                               sensors::counted(row["layers"].get<std::size_t>(), "layer"),
                               row["beams_per_frame"].get<std::size_t>(), profile.scan.frame_rate_hz,
                               profile.detection.max_range_m, profile.title);
  }
  if (!options.json.empty()) session.writeJsonTo(options.json, json);
}

void describeOne(const Options& options, Session& session) {
  const sensors::Description description = sensors::describe(sensors::profileOf(options.name));
  if (options.svg == "-") {
    session.out << sensors::picture(description.profile);
  } else if (!options.svg.empty()) {
    core::writeFile(options.svg, sensors::picture(description.profile));
  }
  if (!options.json.empty()) session.writeJsonTo(options.json, sensors::toJson(description));
  if (options.json.empty() && options.svg.empty()) sensors::print(session.out, description);
  if (sensors::hasError(description)) session.status = kNotAccepted;
}

}  // namespace

void addSensorsCommand(CLI::App& program, Session& session) {
  auto options = std::make_shared<Options>();
  CLI::App* command = program.add_subcommand(
      "sensors", "List the sensor profiles that come with the program, or describe and check one");
  command->add_option("NAME", options->name,
                      "Id of a profile or a profile file: its numbers, how far it sees, and what is remarkable");
  command->add_option("--json", options->json, "Write the list or the description as JSON; '-' is standard output");
  command->add_option("--svg", options->svg, "Draw where the beams of the profile point; '-' is standard output");
  command->footer(
      "A model or an experiment names a profile by its id, or holds one itself. The exit status is 1 if the check of a "
      "profile finds an error.\n\nExamples:\n  fidelis sensors\n  fidelis sensors valeo-scala-1\n  fidelis sensors "
      "my-sensor.json --json check.json --svg beams.svg");
  command->callback([options, &session] {
    if (options->name.empty()) {
      listAll(*options, session);
    } else {
      describeOne(*options, session);
    }
  });
}

}  // namespace app
