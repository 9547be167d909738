#include "gap/report/titles.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <fmt/format.h>
#include <map>

#include "model/effects/effect.h"

namespace gap {

namespace {

std::vector<std::string> partsOf(const std::string& pointer) {
  std::vector<std::string> parts;
  for (std::size_t at = 1; at <= pointer.size();) {
    const std::size_t slash = std::min(pointer.find('/', at), pointer.size());
    parts.push_back(pointer.substr(at, slash - at));
    at = slash + 1;
  }
  return parts;
}

std::string effectTitle(const std::string& name) {
  const model::EffectEntry* entry = model::findEffect(name);
  return entry ? lowerFirst(entry->info.title) : name;
}

std::string meaningOf(const std::string& effect, const std::string& parameter) {
  if (parameter == "centre_x_m") return "its centre, forward";
  if (parameter == "centre_y_m") return "its centre, to the left";
  const model::EffectEntry* entry = model::findEffect(effect);
  if (!entry) return parameter;
  for (const model::ParameterInfo& info : entry->info.parameters) {
    if (info.name == parameter) return lowerFirst(info.meaning.substr(0, info.meaning.find_first_of(";:")));
  }
  return parameter;
}

std::string sceneTitle(const Diagnosis& diagnosis, const std::vector<std::string>& parts) {
  static const std::array<const char*, 3> kAxes = {"x (forward)", "y (to the left)", "z (up)"};
  static const std::array<const char*, 3> kAngles = {"yaw", "pitch", "roll"};
  std::size_t index = 0, axis = 0;
  for (const char c : parts[1]) index = 10 * index + static_cast<std::size_t>(c - '0');
  if (!parts[4].empty()) axis = std::min<std::size_t>(2, static_cast<std::size_t>(parts[4][0] - '0'));
  const auto& ids = diagnosis.background.objects;
  const std::string object = index < ids.size() && !ids[index].empty() ? ids[index] : "object " + parts[1];
  if (parts[3] == "position_m") return fmt::format("recorded position of “{}”, {}", object, kAxes[axis]);
  return fmt::format("recorded {} angle of “{}”", kAngles[axis], object);
}

std::string pointerTitle(const Diagnosis& diagnosis, const std::string& pointer) {
  static const std::map<std::string, std::string> kKnown = {
      {"peak_power_w", "peak power of the emitter"},  {"pulse_fwhm_ns", "pulse length of the emitter"},
      {"noise_w", "noise of the receiver"},           {"threshold_w", "detection threshold of the receiver"},
      {"range_noise_m", "noise of the range"},        {"epw_noise_m", "noise of the echo pulse width"},
      {"horizontal", "horizontal width of the beam"}, {"vertical", "vertical width of the beam"},
      {"saturation_w", "saturation of the receiver"}};
  const std::vector<std::string> parts = partsOf(pointer);
  if (parts.size() == 3 && parts[0] == "materials") return fmt::format("{} of the material “{}”", parts[2], parts[1]);
  if (parts.size() == 3 && parts[0] == "effects")
    return fmt::format("{} of the effect “{}”", meaningOf(parts[1], parts[2]), effectTitle(parts[1]));
  if (parts.size() == 5 && parts[0] == "scene" && parts[2] == "pose") return sceneTitle(diagnosis, parts);
  const auto known = kKnown.find(parts.empty() ? "" : parts.back());
  if (known == kKnown.end()) return pointer;
  return parts[0] == "sensors" ? fmt::format("{} (sensor {})", known->second, parts[1]) : known->second;
}

/// "range-walk (sensor a only)"; the cause's name, or what it is called.
std::string ofItsSensors(const Diagnosis& diagnosis, const std::string& name, const std::string& text) {
  const auto cause =
      std::find_if(diagnosis.causes.begin(), diagnosis.causes.end(), [&](const Cause& c) { return c.name == name; });
  const bool partial = cause != diagnosis.causes.end() && !cause->sensors.empty();
  return partial ? fmt::format("{} (sensor {} only)", text, listOf(cause->sensors)) : text;
}

}  // namespace

std::string lowerFirst(std::string text) {
  // "GPS offset" stays as it is, and so do names of people; "Offset" does not.
  for (const char* name : {"Oren", "Gauss", "Lambert", "Fresnel", "Phong"}) {
    if (text.rfind(name, 0) == 0) return text;
  }
  if (text.size() > 1 && std::islower(static_cast<unsigned char>(text[1])))
    text[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(text[0])));
  return text;
}

std::string listOf(const std::vector<std::string>& names) {
  if (names.size() < 2) return fmt::format("{}", fmt::join(names, ""));
  return fmt::format("{} and {}", fmt::join(names.begin(), names.end() - 1, ", "), names.back());
}

std::string namesOf(const Diagnosis& diagnosis) {
  std::vector<std::string> names;
  for (const std::string& name : diagnosis.verdict.names) names.push_back(ofItsSensors(diagnosis, name, name));
  return listOf(names);
}

std::string measurandTitle(const std::string& measurand) {
  if (measurand == "epw") return "echo pulse width";
  if (measurand == "existence") return "existence of echoes";
  return measurand;
}

std::string componentTitle(const std::string& measurand, const std::string& component) {
  if (component == "missing") return "missing echoes";
  if (component == "extra") return "extra echoes";
  return fmt::format("{} of the {}", component == "bias" ? "mean" : component, measurandTitle(measurand));
}

std::string causeTitle(const Diagnosis& diagnosis, const std::string& name) {
  return name.rfind('/', 0) == 0 ? pointerTitle(diagnosis, name) : effectTitle(name);
}

std::string titlesOf(const Diagnosis& diagnosis, const std::vector<std::string>& names) {
  std::vector<std::string> titles;
  for (const std::string& name : names) titles.push_back(ofItsSensors(diagnosis, name, causeTitle(diagnosis, name)));
  return listOf(titles);
}

std::string causeSummary(const std::string& name) {
  const model::EffectEntry* entry = model::findEffect(name);
  return entry ? entry->info.summary : "";
}

std::string parameterTitle(const Cause& cause, const FittedParameter& parameter) {
  if (cause.kind == CauseKind::kEffect) return meaningOf(cause.name, parameter.name);
  return cause.kind == CauseKind::kReference ? "true minus recorded" : "value";
}

std::string unitOf(const FittedParameter& parameter) { return parameter.unit == "deg" ? "°" : parameter.unit; }

}  // namespace gap
