#include <CLI/CLI.hpp>
#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <ostream>

#include "app/cli/commands.h"
#include "core/error.h"
#include "core/physics.h"
#include "model/explanation.h"

namespace app {

namespace {

using nlohmann::ordered_json;

struct Options {
  std::string experiment;
  std::string model;
  std::string sample;
  std::optional<std::size_t> beam;
  std::optional<int> layer;
  std::optional<double> azimuth_deg;
  int frame = 0;
  std::string json;
};

ordered_json toJson(const model::BeamExplanation& beam, std::size_t index, int frame) {
  ordered_json json{{"format", "fidelis-explanation"},
                    {"version", 1},
                    {"beam", index},
                    {"frame", frame},
                    {"layer", beam.beam.layer},
                    {"azimuth_rad", beam.beam.azimuth_rad},
                    {"elevation_rad", beam.beam.elevation_rad},
                    {"reason", model::toString(beam.reason)},
                    {"threshold_w", beam.shot.receiver.threshold_w},
                    {"fluctuation", beam.shot.fluctuation.of_all},
                    {"fluctuation_of_surfaces", beam.shot.fluctuation.of_surfaces},
                    {"noise_w", beam.shot.noise_w}};
  for (const char* list : {"rays", "pulses", "echoes", "waveform"}) json[list] = ordered_json::array();
  for (const model::SubRayExplanation& ray : beam.rays) {
    ordered_json item{{"azimuth_rad", ray.azimuth_rad}, {"elevation_rad", ray.elevation_rad}, {"weight", ray.weight}};
    if (!ray.object.empty()) {
      item.update({{"object", ray.object},
                   {"material", ray.material},
                   {"range_m", ray.range_m},
                   {"incidence_rad", ray.incidence_rad},
                   {"power_w", ray.power_w},
                   {"turns", ray.turns}});
    }
    json["rays"].push_back(item);
  }
  for (const model::Pulse& pulse : beam.shot.pulses) {
    json["pulses"].push_back(
        {{"range_m", pulse.range_m}, {"power_w", pulse.power_w}, {"of_surface", pulse.of_surface}});
  }
  for (const model::Echo& echo : beam.shot.echoes) {
    json["echoes"].push_back({{"range_m", echo.range_m},
                              {"epw_m", echo.epw_m},
                              {"peak_w", echo.peak_w},
                              {"fate", model::toString(echo.fate)}});
  }
  for (const model::WaveformSample& sample : beam.waveform) {
    json["waveform"].push_back({{"range_m", sample.range_m}, {"power_w", sample.power_w}});
  }
  return json;
}

void print(std::ostream& out, const model::BeamExplanation& beam, std::size_t index, int frame) {
  out << fmt::format("beam {} (layer {}, azimuth {:.3f} deg, elevation {:.3f} deg), frame {}: {}\n", index,
                     beam.beam.layer, beam.beam.azimuth_rad * core::kDegPerRad,
                     beam.beam.elevation_rad * core::kDegPerRad, frame, model::toString(beam.reason));
  struct Met {
    int rays = 0;
    double share = 0.0, power_w = 0.0, range_m = 0.0;
  };
  std::map<std::string, Met> objects;
  for (const model::SubRayExplanation& ray : beam.rays) {
    const std::string name = ray.object.empty() ? "nothing" : ray.object + " (" + ray.material + ")";
    Met& met = objects[name + (ray.turns > 0 ? ", by way of a pane or mirror" : "")];
    ++met.rays;
    met.share += ray.weight;
    met.power_w += ray.power_w;
    met.range_m += ray.weight * ray.range_m;
  }
  for (const auto& [name, met] : objects) {
    out << fmt::format("  {:4} sub-rays, {:5.1f} % of the power sent, meet {}", met.rays, 100.0 * met.share, name);
    if (met.power_w > 0.0) {
      out << fmt::format(" at {:.3f} m on average: {:.4g} nW received", met.range_m / met.share, 1e9 * met.power_w);
    }
    out << "\n";
  }
  out << fmt::format("  threshold {:.4g} nW, noise", 1e9 * beam.shot.receiver.threshold_w);
  for (const double noise_w : beam.shot.noise_w) out << fmt::format(" {:+.3g} nW", 1e9 * noise_w);
  if (beam.shot.noise_w.empty()) out << " not drawn: no pulse comes near the threshold";
  out << "\n";
  for (const model::Echo& echo : beam.shot.echoes) {
    out << fmt::format("  echo at {:.3f} m, EPW {:.3f} m, peak {:.4g} nW: {}\n", echo.range_m, echo.epw_m,
                       1e9 * echo.peak_w, model::toString(echo.fate));
  }
}

void printAll(Session& session, const model::Explainer& explainer, const Options& options) {
  std::map<std::string, std::size_t> counts;
  for (std::size_t b = 0; b < explainer.beams().size(); ++b) {
    core::stopIfCancelled(session.progress);
    ++counts[model::toString(explainer.reasonOf(b, options.frame))];
  }
  ordered_json json{{"format", "fidelis-explanation"}, {"version", 1}, {"frame", options.frame}, {"beams", counts}};
  if (!options.json.empty()) return session.writeJsonTo(options.json, json);
  for (const auto& [reason, count] : counts) session.out << fmt::format("{:>8} beams  {}\n", count, reason);
}

void run(Session& session, const Options& options) {
  const model::Experiment experiment = model::readExperiment(options.experiment);
  const model::LidarModel lidar = model::readModel(options.model);
  const std::size_t sample = options.sample.empty() ? 0 : experiment.sampleIndex(options.sample);
  const int frames = experiment.samples[sample].frames;
  if (options.frame < 0 || options.frame >= frames) {
    throw core::InputError({.item = fmt::format("--frame {}", options.frame)}, "is not a frame of the sample.",
                           fmt::format("Give a number from 0 to {}.", frames - 1));
  }
  const model::Explainer explainer(experiment, lidar, sample, session.seed);
  const auto& beams = explainer.beams();
  if (options.layer &&
      std::none_of(beams.begin(), beams.end(), [&](const model::Beam& beam) { return beam.layer == *options.layer; })) {
    throw core::InputError({.item = fmt::format("--layer {}", *options.layer)}, "has no beam in this sample.",
                           fmt::format("Its layers end with {}.", beams.back().layer));
  }
  if (!options.beam && !options.azimuth_deg) return printAll(session, explainer, options);
  const std::size_t beam =
      options.beam ? *options.beam : explainer.beamNear(options.layer, *options.azimuth_deg * core::kRadPerDeg);
  if (beam >= beams.size()) {
    throw core::InputError({.item = fmt::format("--beam {}", beam)}, "is not a beam of the sample.",
                           fmt::format("Give a number from 0 to {}, or --azimuth-deg.", beams.size() - 1));
  }
  const model::BeamExplanation explained = explainer.explain(beam, options.frame);
  if (!options.json.empty()) return session.writeJsonTo(options.json, toJson(explained, beam, options.frame));
  print(session.out, explained, beam, options.frame);
}

}  // namespace

void addExplainCommand(CLI::App& program, Session& session) {
  auto options = std::make_shared<Options>();
  CLI::App* command = program.add_subcommand("explain", "Tell why a simulated beam was detected, or was not");
  command->add_option("EXPERIMENT", options->experiment, "Experiment package: a folder or its experiment.json")
      ->required();
  command->add_option("--model", options->model, "Model file (fidelis-model)")->required();
  command->add_option("--sample", options->sample, "Id of the sample; the first one without it");
  CLI::Option* beam = command->add_option("--beam", options->beam, "Number of the beam, layer by layer from 0");
  command->add_option("--azimuth-deg", options->azimuth_deg, "The beam nearest to this azimuth instead")
      ->excludes(beam);
  command->add_option("--layer", options->layer, "Layer of that beam")->excludes(beam);
  command->add_option("--frame", options->frame, "Frame, from 0")->capture_default_str();
  command->add_option("--json", options->json, "Sub-rays, pulses, waveform and echoes as JSON; '-' is standard output");
  command->footer(
      "Without a beam: how many beams of the frame were detected, met nothing, stayed below the threshold, …\n\n"
      "Examples:\n  fidelis explain range-sweep --model model.json --sample r10\n"
      "  fidelis explain range-sweep --model model.json --sample r10 --layer 1 --azimuth-deg -2.5 --json -");
  command->callback([options, &session] { run(session, *options); });
}

}  // namespace app
