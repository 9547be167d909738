#pragma once

#include <span>
#include <string>
#include <vector>

#include "model/experiment.h"
#include "model/lidar_model.h"

namespace app {

/// A model and the experiment that it re-simulates, with numbers in both that are to be varied. Each is named by its
/// JSON Pointer: below /effects, /sensor, /sensors and /rays_per_beam in the model file, below /environment,
/// /materials and /scene in the experiment. A sample's own patch is applied before, so what is varied has the last
/// word.
class VariedModel {
 public:
  /// Throws InputError that names the pointer if there is no such number. A parameter of an effect need not be written
  /// in the model file, but the effect must be switched on there.
  VariedModel(model::Experiment experiment, model::LidarModel model, std::vector<std::string> pointers);

  struct Variant {
    model::Experiment experiment;
    model::LidarModel model;
  };
  /// Values in the order of the pointers. Throws InputError if the model refuses one.
  [[nodiscard]] Variant at(std::span<const double> values) const;

  [[nodiscard]] const model::Experiment& experiment() const noexcept { return experiment_; }

 private:
  model::Experiment experiment_;
  model::LidarModel model_;
  std::vector<std::string> pointers_;
};

}  // namespace app
