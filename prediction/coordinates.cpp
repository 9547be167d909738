#include "prediction/coordinates.h"

#include <algorithm>
#include <array>
#include <set>

#include "core/error.h"
#include "core/text.h"
#include "prediction/detection_quantities.h"

namespace prediction {

namespace {

using Names = std::vector<std::string>;

struct EnvironmentKey {
  const char* name;
  std::optional<double> model::Environment::*value;
};
constexpr std::array<EnvironmentKey, 4> kEnvironment{
    {{"temperature_degC", &model::Environment::temperature_degC},
     {"visibility_m", &model::Environment::visibility_m},
     {"rain_rate_mm_h", &model::Environment::rain_rate_mm_h},
     {"background_irradiance_w_m2_nm", &model::Environment::background_irradiance_w_m2_nm}}};

/// The names that each source knows.
class Available {
 public:
  explicit Available(const model::Experiment& experiment) {
    std::set<std::string> names;
    for (const model::Sample& sample : experiment.samples) {
      for (const auto& [name, value] : sample.parameters) names.insert(name);
    }
    sample_.assign(names.begin(), names.end());
    for (const EnvironmentKey& key : kEnvironment) environment_.emplace_back(key.name);
  }

  [[nodiscard]] const Names& of(CoordinateSource source) const {
    if (source == CoordinateSource::Sample) return sample_;
    return source == CoordinateSource::Detection ? detectionQuantities() : environment_;
  }
  [[nodiscard]] bool knows(CoordinateSource source, const std::string& name) const {
    const Names& names = of(source);
    return std::find(names.begin(), names.end(), name) != names.end();
  }
  [[nodiscard]] Names all() const {
    Names names;
    for (const CoordinateSource source : kSources) names.insert(names.end(), of(source).begin(), of(source).end());
    return names;
  }
  [[nodiscard]] std::string shown() const {
    return "samples name " + (sample_.empty() ? "no parameters" : core::join(sample_)) + "; detections have " +
           core::join(detectionQuantities()) + "; the environment has " + core::join(environment_) + ".";
  }

  static constexpr std::array kSources{CoordinateSource::Sample, CoordinateSource::Detection,
                                       CoordinateSource::Environment};

 private:
  Names sample_;
  Names environment_;
};

Coordinate byRule(const std::string& parameter, const model::Experiment& experiment, const Available& available) {
  for (const CoordinateSource source : Available::kSources) {
    if (available.knows(source, parameter)) return {parameter, source, parameter};
  }
  const std::string nearest = core::nearestName(parameter, available.all());
  throw core::InputError(
      {.file = experiment.file},
      "nothing tells the coordinate '" + parameter + "' of the prediction: " + available.shown(),
      nearest.empty()
          ? "Give the samples this parameter, or say what it is: --coordinate " + parameter + "=detection:…."
          : "If it is '" + nearest + "' under another name, say so: --coordinate " + parameter + "=" +
                (available.knows(CoordinateSource::Sample, nearest)      ? "sample"
                 : available.knows(CoordinateSource::Detection, nearest) ? "detection"
                                                                         : "environment") +
                ":" + nearest + ".");
}

struct Choice {
  std::string parameter;
  std::string source;
  std::string key;
};

/// "NAME=SOURCE" or "NAME=SOURCE:KEY".
Choice parsed(const std::string& words) {
  const std::size_t equals = words.find('=');
  if (equals == std::string::npos || equals == 0) {
    throw core::InputError({.item = "--coordinate " + words}, "does not name a parameter and its source.",
                           "Write range_m=detection or distance_m=detection:range_m.");
  }
  Choice choice{.parameter = words.substr(0, equals), .source = words.substr(equals + 1), .key = {}};
  const std::size_t colon = choice.source.find(':');
  choice.key = colon == std::string::npos ? choice.parameter : choice.source.substr(colon + 1);
  choice.source = choice.source.substr(0, colon);
  return choice;
}

CoordinateSource sourceNamed(const std::string& name, const core::Place& place) {
  Names names;
  for (const CoordinateSource source : Available::kSources) {
    names.push_back(toString(source));
    if (names.back() == name) return source;
  }
  const std::string nearest = core::nearestName(name, names);
  throw core::InputError(
      place, "'" + name + "' is no source of a coordinate.",
      nearest.empty() ? "It is one of " + core::join(names) + "." : "Did you mean '" + nearest + "'?");
}

Coordinate byChoice(const std::string& words, std::span<const std::string> parameters, const Available& available) {
  const core::Place place{.item = "--coordinate " + words};
  const Choice choice = parsed(words);
  if (std::find(parameters.begin(), parameters.end(), choice.parameter) == parameters.end()) {
    const std::string nearest = core::nearestName(choice.parameter, parameters);
    throw core::InputError(
        place, "'" + choice.parameter + "' is no parameter of the prediction.",
        nearest.empty() ? "It is over " + core::join(parameters) + "." : "Did you mean '" + nearest + "'?");
  }
  const CoordinateSource source = sourceNamed(choice.source, place);
  if (!available.knows(source, choice.key)) {
    const std::string nearest = core::nearestName(choice.key, available.of(source));
    throw core::InputError(place, "no " + toString(source) + " has '" + choice.key + "': " + available.shown(),
                           nearest.empty() ? "Choose one of these." : "Did you mean '" + nearest + "'?");
  }
  return {choice.parameter, source, choice.key};
}

}  // namespace

std::string toString(CoordinateSource source) {
  if (source == CoordinateSource::Sample) return "sample";
  return source == CoordinateSource::Detection ? "detection" : "environment";
}

std::vector<Coordinate> coordinatesFor(std::span<const std::string> parameters, const model::Experiment& experiment,
                                       std::span<const std::string> chosen) {
  const Available available(experiment);
  std::vector<Coordinate> choices;
  for (const std::string& words : chosen) choices.push_back(byChoice(words, parameters, available));
  std::vector<Coordinate> coordinates;
  for (const std::string& parameter : parameters) {
    const auto choice =
        std::find_if(choices.begin(), choices.end(), [&](const Coordinate& c) { return c.parameter == parameter; });
    coordinates.push_back(choice != choices.end() ? *choice : byRule(parameter, experiment, available));
  }
  return coordinates;
}

SamplePoints::SamplePoints(std::span<const Coordinate> coordinates, const model::Experiment& experiment,
                           const model::Sample& sample, const core::Detections& detections) {
  std::optional<model::Environment> environment;
  for (const Coordinate& coordinate : coordinates) {
    Column column;
    if (coordinate.source == CoordinateSource::Sample) {
      const auto found = sample.parameters.find(coordinate.key);
      if (found != sample.parameters.end()) column.constant = found->second;
    } else if (coordinate.source == CoordinateSource::Environment) {
      if (!environment) environment = model::situationOf(experiment, sample).environment;
      for (const EnvironmentKey& key : kEnvironment) {
        if (coordinate.key == key.name) column.constant = *environment.*key.value;
      }
    } else {
      column.values = valuesOf(detections, coordinate.key).value_or(std::vector<double>{});
    }
    columns_.push_back(std::move(column));
  }
}

bool SamplePoints::at(std::size_t detection, std::span<double> point) const {
  for (std::size_t k = 0; k < columns_.size(); ++k) {
    const Column& column = columns_[k];
    if (!column.constant && column.values.empty()) return false;
    point[k] = column.constant ? *column.constant : column.values[detection];
  }
  return true;
}

}  // namespace prediction
