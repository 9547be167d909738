#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <ostream>

#include "app/cli/commands.h"
#include "core/json_object.h"
#include "core/new_folder.h"
#include "model/experiment.h"
#include "model/scene/traffic_experiment.h"

namespace app {

namespace {

struct Options {
  std::string trace;
  std::string out;
  std::string id;
  std::string sensor = "demo-scanner";
  std::string host;
  std::vector<double> mounting;
  std::size_t first = 0;
  std::size_t last = 0;
  std::size_t step = 1;
  int frames = 1;
  bool boxes = false;
  bool no_ground = false;
};

model::TrafficExperimentOptions chosen(const Options& options) {
  model::TrafficExperimentOptions choice;
  choice.id = options.id.empty() ? std::filesystem::path(options.trace).stem().string() : options.id;
  choice.sensor = options.sensor;
  choice.refined = !options.boxes;
  choice.ground = !options.no_ground;
  choice.frames = options.frames;
  choice.messages.clear();
  for (std::size_t message = options.first; message <= std::max(options.first, options.last); message += options.step) {
    choice.messages.push_back(message);
  }
  if (!options.host.empty()) choice.host = options.host;
  const auto& m = options.mounting;
  if (!m.empty()) choice.mounting = model::Pose{{m[0], m[1], m[2]}, m.size() > 3 ? m[3] : 0.0};
  return choice;
}

nlohmann::json modelJson(const Options& options) {
  return {{"format", "fidelis-model"},
          {"version", 1},
          {"id", "baseline"},
          {"sensor", options.sensor},
          {"rays_per_beam", {3, 3}},
          {"seed", 1},
          {"effects", {{"beam-divergence", nlohmann::json::object()}}}};
}

}  // namespace

void addSceneCommand(CLI::App& program, Session& session) {
  auto options = std::make_shared<Options>();
  CLI::App* command =
      program.add_subcommand("scene", "Make an experiment package from the ground truth of an ASAM OSI 3 trace");
  command->add_option("TRACE", options->trace, "Trace of SensorView or GroundTruth messages (.osi)")->required();
  command->add_option("--out", options->out, "New folder for experiment.json and model.json")->required();
  command->add_option("--id", options->id, "Id of the experiment (default: the trace's name)");
  command->add_option("--sensor", options->sensor, "Sensor profile that looks at the scene")->capture_default_str();
  command->add_option("--from", options->first, "First message, counted from 0")->capture_default_str();
  command->add_option("--to", options->last, "Last message; each one chosen becomes a sample (default: the first)");
  command->add_option("--step", options->step, "Take every n-th message")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command->add_option("--frames", options->frames, "Frames of each sample")->check(CLI::PositiveNumber);
  command->add_option("--host", options->host, "Object that carries the sensor, e.g. moving-3 (default: the trace's)");
  command
      ->add_option("--mounting", options->mounting,
                   "Sensor in the host's frame (origin: middle of the rear axle): x y z [yaw], m and degrees")
      ->expected(3, 4);
  command->add_flag("--boxes", options->boxes, "Keep bounding boxes; do not refine cars, pedestrians, poles and trees");
  command->add_flag("--no-ground", options->no_ground, "Leave out the level ground below the host");
  command->footer(
      "Example:\n  fidelis scene drive_sv.osi --to 100 --step 10 --out drive\n"
      "  fidelis simulate drive --model drive/model.json --out simulated");
  command->callback([options, &session] {
    const auto made = model::trafficExperiment(model::readTraffic(options->trace), options->trace, chosen(*options));
    const auto experiment = model::parseExperiment(made.json, options->out + "/experiment.json");  // checks it
    core::NewFolder folder(options->out);
    core::writeJson(folder.path() / "experiment.json", made.json);
    core::writeJson(folder.path() / "model.json", modelJson(*options));
    folder.appear();
    if (session.quiet) return;
    for (const std::string& note : made.notes) session.messages << "note: " << note << "\n";
    session.messages << fmt::format("{}: {} objects, {} samples\n", options->out, made.json["scene"].size(),
                                    experiment.samples.size());
  });
}

}  // namespace app
