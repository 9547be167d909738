#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <exception>
#include <fmt/format.h>
#include <numbers>
#include <ostream>

#include "app/cli/commands.h"
#include "core/error.h"
#include "core/file.h"
#include "core/text.h"
#include "model/experiment.h"
#include "model/material/reflection.h"
#include "report/curve_figure.h"

namespace app {

namespace {

using nlohmann::ordered_json;

constexpr double kDegree = std::numbers::pi / 180.0;

struct Options {
  std::string experiment;
  std::vector<std::string> only;
  double wavelength_nm = 0.0;
  double wetness = 0.0;
  std::string svg;
  std::string json;
};

/// Under what the materials are looked at.
struct Light {
  double wavelength_nm;
  double wetness;
};

/// What a surface sends back at each angle, in dB over a white Lambertian one hit square on. NaN where its table ends.
std::vector<double> returns_dB(const model::Material& material, const Light& light,
                               const std::vector<double>& degrees) {
  std::vector<double> returns;
  std::exception_ptr fault;
  for (const double degree : degrees) {
    const double cosine = std::cos(degree * kDegree);
    try {
      const double factor = model::monostaticFactor(material, cosine, light.wavelength_nm) *
                            model::wetFactor(material, cosine, {light.wetness});
      returns.push_back(10.0 * std::log10(material.reflectivity * factor * cosine));
    } catch (const core::InputError&) {
      fault = std::current_exception();
      returns.push_back(std::nan(""));
    }
  }
  const bool nothing = std::all_of(returns.begin(), returns.end(), [](double value) { return std::isnan(value); });
  if (fault && nothing) std::rethrow_exception(fault);  // not only the ends of a table: the wavelength is not there
  return returns;
}

/// The wavelength asked for, else that of the experiment's (first) sensor.
double wavelengthOf(const Options& options, const model::Experiment& experiment) {
  if (options.wavelength_nm > 0.0) return options.wavelength_nm;
  const bool several = !experiment.sensors.empty();
  const std::string pointer = several ? "/sensors/" + experiment.sensors.front() : "/sensor";
  const auto& value = several ? experiment.json["sensors"][experiment.sensors.front()] : experiment.json["sensor"];
  return model::resolveSensorProfile(value, experiment.file, pointer).emitter.wavelength_nm;
}

/// The materials asked for, in order of name; all of them if none was.
std::vector<model::Material> chosen(const model::Scene& scene, const Options& options) {
  if (options.only.empty()) return scene.materials;
  std::vector<model::Material> materials;
  std::vector<std::string> known;
  for (const model::Material& material : scene.materials) known.push_back(material.name);
  for (const std::string& name : options.only) {
    const auto found = std::find(known.begin(), known.end(), name);
    if (found == known.end()) {
      const std::string nearest = core::nearestName(name, known);
      throw core::InputError(
          {.file = options.experiment, .item = "/materials"}, "has no material '" + name + "'.",
          nearest.empty() ? "Known are " + core::join(known) + "." : "Did you mean '" + nearest + "'?");
    }
    materials.push_back(scene.materials[static_cast<std::size_t>(found - known.begin())]);
  }
  return materials;
}

std::string figureOf(const std::vector<model::Material>& materials, const Light& light) {
  report::CurveFigure figure{.title = fmt::format("Return at {:g} nm", light.wavelength_nm),
                             .x_name = "incidence angle in °",
                             .y_name = "dB over white Lambertian, square on"};
  if (light.wetness > 0.0) figure.title += fmt::format(", wetness {:g}", light.wetness);
  for (int i = 0; i <= 356; ++i) figure.x.push_back(0.25 * i);
  double highest = 0.0;
  for (const model::Material& material : materials) {
    figure.curves.push_back({material.name, returns_dB(material, light, figure.x)});
    for (const double value : figure.curves.back().y) {
      if (std::isfinite(value)) highest = std::max(highest, value);
    }
  }
  figure.y_range = report::Range{-40.0, 10.0 * std::ceil(highest / 10.0 + 0.1)};
  return report::curveFigure(figure);
}

ordered_json toJson(const model::Material& material, const Light& light, const std::vector<double>& degrees) {
  ordered_json json{{"name", material.name}, {"reflectivity", material.reflectivity}};
  json["return_dB"] = ordered_json::array();
  for (const double value : returns_dB(material, light, degrees)) {
    json["return_dB"].push_back(std::isfinite(value) ? ordered_json(value) : ordered_json(nullptr));
  }
  json["transmittance"] = model::transmittance(material, 1.0, light.wavelength_nm);
  json["specular_reflectance"] = model::specularReflectance(material, 1.0, light.wavelength_nm);
  return json;
}

std::string tableOf(const std::vector<model::Material>& materials, const Light& light,
                    const std::vector<double>& degrees) {
  std::string table = fmt::format("{:<24}", fmt::format("at {:g} nm", light.wavelength_nm));
  for (const double degree : degrees) table += fmt::format("{:>8}°", degree);
  table += "   dB over a white Lambertian surface, square on\n";
  for (const model::Material& material : materials) {
    table += fmt::format("{:<24}", material.name);
    for (const double value : returns_dB(material, light, degrees)) {
      table += std::isnan(value) ? fmt::format("{:>9}", "–") : fmt::format("{:>9.1f}", value);
    }
    table += '\n';
  }
  return table;
}

void run(const Options& options, Session& session) {
  const model::Experiment experiment = model::readExperiment(options.experiment);
  const auto materials = chosen(model::situationOf(experiment, experiment.samples.front()).scene, options);
  const Light light{wavelengthOf(options, experiment), options.wetness};
  const std::vector<double> degrees{0.0, 30.0, 60.0, 80.0};
  if (!options.svg.empty()) core::writeFile(options.svg, figureOf(materials, light));
  if (options.json.empty()) {
    session.out << tableOf(materials, light, degrees);
    return;
  }
  ordered_json json{{"format", "fidelis-materials"},
                    {"version", 1},
                    {"wavelength_nm", light.wavelength_nm},
                    {"wetness", light.wetness},
                    {"incidence_deg", degrees},
                    {"materials", ordered_json::array()}};
  for (const model::Material& material : materials) json["materials"].push_back(toJson(material, light, degrees));
  session.writeJsonTo(options.json, json);
}

}  // namespace

void addMaterialsCommand(CLI::App& program, Session& session) {
  auto options = std::make_shared<Options>();
  CLI::App* command =
      program.add_subcommand("materials", "Show what an experiment's materials send back over the angle");
  command->add_option("EXPERIMENT", options->experiment, "Experiment package, or its experiment.json")->required();
  command->add_option("--only", options->only, "These materials only, in this order");
  command->add_option("--wetness", options->wetness, "Share of the surface under a water film, 0 to 1")
      ->check(CLI::Range(0.0, 1.0));
  command->add_option("--wavelength", options->wavelength_nm, "In nm; otherwise that of the experiment's sensor")
      ->check(CLI::PositiveNumber);
  command->add_option("--svg", options->svg, "Draw the curves");
  command->add_option("--json", options->json, "Write the numbers as JSON; '-' is standard output");
  command->footer(
      "Each material with its own BRDF, as the effects angular-reflection and retroreflection make it; a dash where "
      "its "
      "table\nends.\n\nExample:\n  fidelis materials docs/materials --svg materials.svg");
  command->callback([options, &session] { run(*options, session); });
}

}  // namespace app
