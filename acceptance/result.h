#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "acceptance/expression.h"
#include "specs/items.h"
#include "specs/results.h"

namespace acceptance {

/// One sample of a test: measurement against the p-box of its re-simulations.
struct SampleResult {
  std::string id;
  specs::Verdict verdict = specs::Verdict::Skipped;
  std::string text;                          ///< one sentence: why
  std::map<std::string, double> parameters;  ///< the sample's coordinates
  std::map<std::string, double> values;      ///< metrics and counts by name; NaN where undefined
  std::vector<Relation> relations;           ///< empty if the expression could not be decided
  std::optional<Relation> decisive;          ///< the one with the least margin
  std::size_t n_real = 0;
  std::vector<std::size_t> n_sim;    ///< centre first, then the corners of the epistemic box
  std::vector<std::string> remarks;  ///< what a reader must know of this verdict
  std::string figure;                ///< SVG; empty if there is nothing to draw
};

/// One acceptance test: all that its report shows.
struct TestResult {
  specs::AcceptanceTest test;
  std::vector<specs::Requirement> requirements;  ///< that it verifies
  specs::Verdict verdict = specs::Verdict::Skipped;
  std::string text;  ///< one sentence: why
  std::string experiment_id;
  std::string experiment_title;
  std::string experiment_source;
  bool synthetic = false;  ///< no sensor measured this: the experiment says so
  std::string model_id;
  std::string model_file;  ///< relative to the project file, as far as that is possible
  std::uint64_t seed = 0;
  std::string unit;    ///< of the measurand
  std::string column;  ///< of the measurement
  std::vector<SampleResult> samples;
  std::vector<specs::UsedFile> used;

  /// The sample that decides: the worst; nullptr without samples.
  [[nodiscard]] const SampleResult* decisiveSample() const;
};

/// One call of `accept`.
struct RunResult {
  std::string project;          ///< name of the project
  std::string program_version;  ///< "0.1.0"
  std::vector<TestResult> tests;

  [[nodiscard]] std::size_t count(specs::Verdict verdict) const;
};

}  // namespace acceptance
