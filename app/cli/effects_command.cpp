#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <ostream>

#include "app/cli/commands.h"
#include "app/cli/effects/picture.h"
#include "core/error.h"
#include "core/file.h"
#include "core/text.h"
#include "model/effects/effect.h"

namespace app {

namespace {

using nlohmann::ordered_json;

/// Whether a diagnosis searches for a parameter, in any form of the effect.
bool isFitted(const model::EffectInfo& info, const std::string& parameter) {
  const auto among = [&](const std::vector<std::string>& names) {
    return std::find(names.begin(), names.end(), parameter) != names.end();
  };
  return among(info.fitted) || std::any_of(info.other_forms.begin(), info.other_forms.end(),
                                           [&](const model::FittedForm& form) { return among(form.parameters); });
}

ordered_json toJson(const model::ParameterInfo& parameter, bool fitted) {
  ordered_json json{{"name", parameter.name}, {"unit", parameter.unit}, {"min", parameter.min}, {"max", parameter.max}};
  json["default"] = parameter.default_value ? ordered_json(*parameter.default_value) : ordered_json(nullptr);
  json["fitted"] = fitted;
  json["meaning"] = parameter.meaning;
  return json;
}

/// Its bounds hold for every number of the list; `count` null: any number of them.
ordered_json toJson(const model::ListInfo& list) {
  ordered_json json{{"name", list.name}, {"unit", list.unit}, {"min", list.min}, {"max", list.max}};
  json["list"] = true;
  json["count"] = list.count > 0 ? ordered_json(list.count) : ordered_json(nullptr);
  json["meaning"] = list.meaning;
  return json;
}

ordered_json toJson(const model::EffectEntry& entry) {
  const model::EffectInfo& info = entry.info;
  ordered_json json{
      {"name", info.name}, {"title", info.title}, {"summary", info.summary}, {"stage", model::toString(info.stage)}};
  json["percollect"] = info.percollect;
  json["parameters"] = ordered_json::array();
  for (const model::ParameterInfo& parameter : info.parameters)
    json["parameters"].push_back(toJson(parameter, isFitted(info, parameter.name)));
  for (const auto& [name, choices] : entry.texts) json["parameters"].push_back({{"name", name}, {"choices", choices}});
  for (const model::ListInfo& list : entry.lists) json["parameters"].push_back(toJson(list));
  json["source"] = info.source;
  return json;
}

const model::EffectEntry& entryOf(const std::string& name) {
  if (const model::EffectEntry* entry = model::findEffect(name)) return *entry;
  std::vector<std::string> known;
  for (const model::EffectEntry& entry : model::allEffects()) known.push_back(entry.info.name);
  const std::string nearest = core::nearestName(name, known);
  throw core::InputError({.item = "effect '" + name + "'"}, "is not in the library.",
                         nearest.empty() ? "'fidelis effects' lists them all." : "Did you mean '" + nearest + "'?");
}

void printOne(std::ostream& out, const model::EffectEntry& entry) {
  const model::EffectInfo& info = entry.info;
  out << fmt::format("{}: {}\n  {}\n  stage       {}\n", info.name, info.title, info.summary,
                     model::toString(info.stage));
  if (!info.percollect.empty()) out << fmt::format("  graph nodes {}\n", core::join(info.percollect));
  for (const model::ParameterInfo& p : info.parameters) {
    out << fmt::format("  {:<24} {:g} … {:g}{}{}{}\n{:27}{}\n", p.name, p.min, p.max,
                       p.unit.empty() ? "" : " " + p.unit,
                       p.default_value ? fmt::format(", default {:g}", *p.default_value) : "",
                       isFitted(info, p.name) ? ", fitted by a diagnosis" : "", "", p.meaning);
  }
  for (const auto& [name, choices] : entry.texts) out << fmt::format("  {:<24} one of {}\n", name, core::join(choices));
  for (const model::ListInfo& list : entry.lists) {
    out << fmt::format("  {:<24} list of {}, each {:g} … {:g}{}\n{:27}{}\n", list.name,
                       list.count > 0 ? std::to_string(list.count) : "numbers", list.min, list.max,
                       list.unit.empty() ? "" : " " + list.unit, "", list.meaning);
  }
  out << fmt::format("  source      {}\n", info.source);
}

void printAll(std::ostream& out) {
  for (const model::EffectEntry& entry : model::allEffects()) {
    std::vector<std::string> names;
    for (const model::ParameterInfo& parameter : entry.info.parameters) names.push_back(parameter.name);
    for (const auto& [name, choices] : entry.texts) names.push_back(name);
    for (const model::ListInfo& list : entry.lists) names.push_back(list.name);
    out << fmt::format("{:<28} {:<22} {}\n", entry.info.name, model::toString(entry.info.stage), core::join(names));
  }
}

struct Options {
  std::string name;
  std::string json;
  std::string svg;
};

void draw(const Options& options, Session& session) {
  if (options.name.empty())
    throw core::InputError({.item = "--svg"}, "needs the name of an effect.", "Write: fidelis effects NAME --svg FILE");
  const auto file = core::resourceFolder() / "effects" / (entryOf(options.name).info.name + ".json");
  const std::string svg = effects::picture(model::demonstrate(model::readDemonstration(file)));
  if (options.svg == "-") {
    session.out << svg;
  } else {
    core::writeFile(options.svg, svg);
  }
}

}  // namespace

void addEffectsCommand(CLI::App& program, Session& session) {
  auto options = std::make_shared<Options>();
  CLI::App* command = program.add_subcommand("effects", "List the effects of the library, or describe one");
  command->add_option("NAME", options->name, "Describe this effect: parameters with unit, range and default, source");
  command->add_option("--json", options->json, "Write the declarations as JSON; '-' is standard output");
  command->add_option("--svg", options->svg,
                      "Draw what the effect does to the detections, simulated anew; '-' is standard output");
  command->footer(
      "Examples:\n  fidelis effects\n  fidelis effects atmospheric-attenuation\n  fidelis effects --json -\n  "
      "fidelis effects blooming --svg blooming.svg");
  command->callback([options, &session] {
    const model::EffectEntry* one = options->name.empty() ? nullptr : &entryOf(options->name);
    if (!options->svg.empty()) draw(*options, session);
    if (!options->json.empty()) {
      ordered_json json{{"format", "fidelis-effects"}, {"version", 1}, {"effects", ordered_json::array()}};
      for (const model::EffectEntry& entry : model::allEffects()) {
        if (!one || one == &entry) json["effects"].push_back(toJson(entry));
      }
      session.writeJsonTo(options->json, json);
    } else if (!options->svg.empty()) {
      return;
    } else if (one) {
      printOne(session.out, *one);
    } else {
      printAll(session.out);
    }
  });
}

}  // namespace app
