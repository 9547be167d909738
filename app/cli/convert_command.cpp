#include <CLI/CLI.hpp>
#include <ostream>

#include "app/cli/commands.h"
#include "core/detection_files/detection_file.h"
#include "core/detection_files/detection_format.h"
#include "core/detection_files/lidar_view.h"
#include "core/json_object.h"
#include "core/text.h"
#include "model/sensor/layers.h"

namespace app {

namespace {

struct Options {
  std::string in;
  std::string out;
  std::string sensor;
  std::string encoding;
  bool reflections = false;
};

/// "pcd (.pcd; binary, binary_compressed, ascii)", a line a format.
std::string formatsKnown() {
  std::string text;
  for (const core::DetectionFormat& format : core::detectionFormats()) {
    text += "  " + core::join(format.endings) + "  " + format.title;
    if (!format.encodings.empty()) text += " (" + core::join(format.encodings) + ")";
    text += "\n";
  }
  return text;
}

/// A profile's file, or the name of a built-in one.
model::SensorProfile profileNamed(const std::string& name) {
  return std::filesystem::is_regular_file(name) ? model::resolveSensorProfile(core::readJson(name), name, "")
                                                : model::resolveSensorProfile(name, "", "--sensor");
}

core::Detections read(const Options& options) {
  core::Detections detections =
      options.reflections ? core::pointsOf(core::readLidarSensorViews(options.in)) : core::readDetections(options.in);
  if (!options.sensor.empty()) model::addLayers(detections, model::beamsOf(profileNamed(options.sensor).scan));
  return detections;
}

}  // namespace

void addConvertCommand(CLI::App& program, Session& session) {
  auto options = std::make_shared<Options>();
  CLI::App* command = program.add_subcommand("convert", "Convert a measurement between CSV, PCD, PLY and ASAM OSI 3");
  command->add_option("IN", options->in, "Measurement; the content tells its format")->required();
  command->add_option("OUT", options->out, "File to write; its ending names the format")->required();
  command->add_option("--sensor", options->sensor,
                      "Profile (name or file) whose layers points without layers get; a CSV needs them");
  command->add_option("--encoding", options->encoding, "One of the format's encodings, see below");
  command->add_flag("--reflections", options->reflections,
                    "IN is a trace of SensorView: write its reflections as points");
  command->footer("Formats (the first encoding is the default); .gz may follow the ending:\n" + formatsKnown() +
                  "Example:\n  fidelis convert scan.pcd scan.csv --sensor ibeo-lux-2010");
  command->callback([options, &session] {
    const core::Detections detections = read(*options);
    core::writeDetections(options->out, detections, options->encoding);
    if (!session.quiet) session.messages << "wrote " << detections.size() << " detections to " << options->out << "\n";
  });
}

}  // namespace app
