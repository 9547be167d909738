#include <CLI/CLI.hpp>
#include <algorithm>
#include <fmt/format.h>
#include <ostream>

#include "app/cli/commands.h"
#include "core/error.h"
#include "core/file.h"
#include "core/new_folder.h"
#include "core/text.h"
#include "model/experiment.h"

namespace app {

namespace {

namespace fs = std::filesystem;

std::vector<std::string> names() {
  std::vector<std::string> found;
  for (const auto& entry : fs::directory_iterator(core::resourceFolder() / "scenes")) {
    if (fs::is_regular_file(entry.path() / "experiment.json")) found.push_back(entry.path().filename().string());
  }
  std::sort(found.begin(), found.end());
  return found;
}

void list(Session& session, const std::string& json_file) {
  nlohmann::ordered_json json{
      {"format", "fidelis-scenes"}, {"version", 1}, {"scenes", nlohmann::ordered_json::array()}};
  for (const std::string& name : names()) {
    const auto experiment = model::readExperiment(core::resourceFolder() / "scenes" / name);
    const std::size_t objects = experiment.json.value("scene", nlohmann::json::array()).size();
    json["scenes"].push_back({{"name", name},
                              {"title", experiment.title},
                              {"objects", objects},
                              {"samples", experiment.samples.size()},
                              {"source", experiment.source}});
    if (json_file.empty()) {
      session.out << fmt::format("{:<16} {:>4} objects, {:>2} samples: {}\n", name, objects, experiment.samples.size(),
                                 experiment.title);
    }
  }
  if (!json_file.empty()) session.writeJsonTo(json_file, json);
}

void copy(const std::string& name, const std::string& out) {
  const auto known = names();
  if (std::find(known.begin(), known.end(), name) == known.end()) {
    const std::string nearest = core::nearestName(name, known);
    throw core::InputError(
        {.item = "scene '" + name + "'"}, "does not come with the program.",
        nearest.empty() ? "Known are " + core::join(known) + "." : "Did you mean '" + nearest + "'?");
  }
  core::NewFolder folder(out);
  fs::copy(core::resourceFolder() / "scenes" / name, folder.path(), fs::copy_options::recursive);
  folder.appear();
}

}  // namespace

void addScenesCommand(CLI::App& program, Session& session) {
  struct Options {
    std::string name, out, json;
  };
  auto options = std::make_shared<Options>();
  CLI::App* command =
      program.add_subcommand("scenes", "List the ready scenes, or copy one as the start of an own experiment");
  auto* name = command->add_option("NAME", options->name, "Scene to copy (default: list them)");
  auto* out = command->add_option("--out", options->out, "New folder for the copy")->needs(name);
  name->needs(out);
  command->add_option("--json", options->json, "Write the list as JSON; '-' is standard output")->excludes(name);
  command->footer(
      "Example:\n  fidelis scenes wall --out wall\n  fidelis simulate wall --model wall/model.json --out "
      "simulated");
  command->callback([options, &session] {
    if (options->name.empty()) {
      list(session, options->json);
      return;
    }
    copy(options->name, options->out);
    if (!session.quiet) session.messages << "copied '" << options->name << "' into " << options->out << "\n";
  });
}

}  // namespace app
