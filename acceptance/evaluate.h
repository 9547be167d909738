#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "acceptance/result.h"
#include "core/progress.h"

namespace model {
class ExternalRuns;
struct LidarModel;
}  // namespace model

namespace acceptance {

/// What is evaluated, and against what.
struct TestTask {
  specs::AcceptanceTest test;
  std::vector<specs::Requirement> requirements;
  std::filesystem::path folder;                    ///< where the test's relative paths begin
  std::optional<std::filesystem::path> model;      ///< in place of the test's model
  std::shared_ptr<const model::LidarModel> lidar;  ///< read already, in place of every file
  std::optional<std::uint64_t> seed;               ///< in place of the model's
  /// Answers of models that are not ours, shared by the tests of one session; nullptr: this test has its own.
  std::shared_ptr<model::ExternalRuns> external;
};

/// Reads the experiment package and the model, re-simulates every selected sample at its nominal values and at each
/// corner of its epistemic box (E-outer: same random numbers for all), selects the detections of the gate on both
/// sides, compares the measurement with the p-box of the runs and decides sample by sample.
///
/// The test passes if all selected samples hold. A sample fails too if the measurement has detections and a simulation
/// has none. What a user must repair (file, expression, gate, no measurement) gives the verdict Error with that text;
/// a test without experiment is Skipped. Throws only Cancelled.
[[nodiscard]] TestResult evaluate(const TestTask& task, core::Progress& progress);

/// Names that an expression may use beside the sample's parameters, each with its meaning: all metrics (several numbers
/// as name_part: `ks_p_value`), and
///
///   n_real, n_sim              detections, measured and simulated at nominal values
///   frames_real, frames_sim    frames
///   detection_rate_real, _sim  share of fired beams with an echo (inside the gate)
///   missing_fraction           echoes that only the simulation has, share of all simulated ones
///   extra_fraction             echoes that only the measurement has, share of all simulated ones
struct Variable {
  std::string name;
  std::string meaning;
};
[[nodiscard]] std::vector<Variable> expressionVariables();

}  // namespace acceptance
