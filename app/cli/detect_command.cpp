#include <CLI/CLI.hpp>
#include <ostream>

#include "app/cli/commands.h"
#include "app/cli/effects_in_reflections.h"
#include "core/detection_files/detection_file.h"
#include "model/simulate.h"

namespace app {

namespace {

struct Options {
  std::string trace;
  std::string model;
  std::string sensor;
  std::string out;
};

void runDetect(const Options& options, const Session& session) {
  const model::LidarModel lidar = model::readModel(options.model);
  const model::ReflectionTrace trace = model::readReflections(options.trace);
  const core::Detections detections = model::receive(trace, lidar, options.sensor, session.seed);
  core::writeDetections(options.out, detections);
  if (session.quiet) return;
  session.messages << "received " << detections.size() << " detections in " << trace.views.size()
                   << " frames, written to " << options.out << "\n";
  writeEffectsInReflections(lidar, session.messages);
}

}  // namespace

void addDetectCommand(CLI::App& program, Session& session) {
  auto options = std::make_shared<Options>();
  CLI::App* command =
      program.add_subcommand("detect", "Receive the reflections of a lidar model elsewhere: detections");
  command->add_option("REFLECTIONS", options->trace, "ASAM OSI 3 trace of SensorView; every message is a frame")
      ->required();
  command->add_option("--model", options->model, "Model file (fidelis-model): the sensor that receives, its effects")
      ->required();
  command->add_option("--sensor", options->sensor, "Which one, if the model has several");
  command->add_option("--out", options->out, "File to write: .csv, .pcd, .ply or .osi (SensorData)")->required();
  command->footer(
      "A reflection's signal_strength is 10 log10 of received over emitted power; the rays of a beam add up. Rays that "
      "lie\n"
      "in no beam of the sensor count for nothing. Effects that change the power of a reflection are left out: they "
      "are\n"
      "in the signal strengths. With an experiment package: fidelis simulate --from-reflections.\n\n"
      "Example:\n  fidelis detect reflections.osi --model model.json --out detections.osi");
  command->callback([options, &session] { runDetect(*options, session); });
}

}  // namespace app
