#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/progress.h"
#include "gap/hypotheses.h"
#include "gap/total_gap.h"
#include "gap/where.h"

namespace gap {

struct Interval {
  double low = 0.0;
  double high = 0.0;
};

/// A fitted number with its uncertainty over the set-ups.
struct FittedParameter {
  std::string name;
  std::string unit;
  double value = 0.0;
  Interval interval;
};

struct Shrink {
  double fraction = 0.0;  ///< 1 - after/before of the total gap on held-out samples
  Interval interval;
};

/// A hypothesis after its fit.
struct Cause {
  CauseKind kind = CauseKind::kEffect;
  std::string name;
  std::string variant;
  std::vector<std::string> percollect;
  std::string decomposition_block;
  double confidence = 0.0;
  double explained = 0.0;  ///< share of the explainable discrepancy on held-out data
  std::vector<FittedParameter> parameters;
  std::map<std::string, FittedParameter> setups;  ///< reference offsets per set-up
  Shrink shrink;
};

enum class VerdictKind { kNone, kEffect, kParameter, kReference, kUnknown };
[[nodiscard]] std::string toString(VerdictKind kind);

struct Verdict {
  VerdictKind kind = VerdictKind::kUnknown;
  std::vector<std::string> names;
  double confidence = 0.0;
  std::vector<std::string> indistinguishable_from;
  std::string text;
};

struct NextExperiment {
  std::string text;
  std::vector<std::string> separates;
  std::map<std::string, double> parameters;
};

/// The answer to: where does the simulation differ, which cause explains it, how far does the gap shrink?
struct Diagnosis {
  std::string experiment;
  std::string model;
  bool synthetic = false;
  bool present = false;
  double p_value = 1.0;
  TotalGap before;                       ///< mean over the held-out samples
  std::map<std::string, Interval> bias_intervals;  ///< of d_bias per measurand, over set-ups and frames
  std::vector<WhereRow> where;
  Verdict verdict;
  std::vector<Cause> causes;             ///< best first; two for a pair come first, in one verdict
  std::optional<TotalGap> after;         ///< with the verdict's cause added
  Shrink shrink;
  std::vector<std::string> held_out;
  bool weak_hold_out = false;            ///< no sample could be held out whole
  std::optional<NextExperiment> next_experiment;
  nlohmann::json proposed_model;         ///< null if the verdict names nothing that a model file can hold
  double elapsed_s = 0.0;
};

struct DiagnoseOptions {
  std::vector<std::string> library;  ///< effects to consider; empty: all
  std::optional<std::uint64_t> seed;
};

/// Diagnoses the gap between the measurements of an experiment package and their re-simulation (docs/diagnosis.md).
/// Throws InputError for unusable input, Cancelled if the progress says so.
[[nodiscard]] Diagnosis diagnose(const model::Experiment& experiment, const model::LidarModel& model,
                                 const DiagnoseOptions& options, core::Progress& progress);

}  // namespace gap
