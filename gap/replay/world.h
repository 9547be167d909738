#pragma once

#include <map>
#include <string>
#include <vector>

#include "model/experiment.h"
#include "model/lidar_model.h"

namespace gap {

/// A reference quantity that may be off, by JSON Pointer into the experiment: true minus recorded value.
struct ReferenceOffset {
  std::string pointer;
  double everywhere = 0.0;
  std::map<std::string, double> by_setup;  ///< added for these set-ups

  [[nodiscard]] double of(const std::string& setup) const;
};

/// One complete account of how the measurement came about: which model, which materials, which reference. The
/// baseline world is the model file and the experiment as they were brought.
struct World {
  model::LidarModel model;
  std::map<std::string, double> reflectivity;  ///< of materials that differ from the experiment's
  std::vector<ReferenceOffset> references;
};

/// Geometry depends on these only; two worlds with the same text share their hits.
[[nodiscard]] std::string geometryKey(const World& world, const model::Sample& sample);

/// The situation of a sample in this world, but for its materials: they are no geometry, so whoever shares the traced
/// hits brings its own.
[[nodiscard]] model::Situation situationIn(const World& world, const model::Experiment& experiment,
                                           const model::Sample& sample);

}  // namespace gap
