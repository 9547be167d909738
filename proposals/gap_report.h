#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "gap/diagnosis.h"

namespace proposals {

/// One measurand (or existence, as "missing" and "extra") before and after the cause was added to the model.
struct ReportedGap {
  std::string name;
  std::string unit;
  double resolution = 0.0;  ///< 0: the report does not say
  double bias = 0.0;        ///< d_bias; a share for "missing" and "extra"
  double scatter = 0.0;     ///< d_cavm; 0 for "missing" and "extra"
  std::optional<gap::Interval> bias_interval;
  std::optional<double> bias_after;
  std::optional<double> scatter_after;

  /// What it adds to the total gap. [1] As formats.md section 6 weighs it; 0 if the resolution is not known.
  [[nodiscard]] double weight() const;
};

/// A gap report (formats.md section 6) as it was written, on whatever day and machine: of a gap::Diagnosis what was
/// told. What a report does not tell is empty in its parts (ranges that were searched, recorded values, p-values).
struct GapReport {
  std::filesystem::path file;
  std::string sha256;    ///< of the file
  std::string evidence;  ///< SHA-256 of its content without `elapsed_s`: two runs of one diagnosis agree
  std::string experiment;
  std::string model;
  bool synthetic = false;
  bool present = false;
  std::vector<ReportedGap> gaps;
  std::vector<gap::WhereRow> where;
  gap::Verdict verdict;
  std::optional<gap::Approximation> approximation;  ///< if the model under test is not the built-in lidar
  std::vector<std::string> notes;                   ///< what a person should know of the data, sentences
  std::vector<gap::Cause> causes;
  std::optional<gap::Shrink> shrink;
  std::optional<std::pair<double, double>> totals;  ///< before, after
  std::vector<std::string> held_out;
  bool half_of_the_beams_fitted = false;   ///< of the held-out samples, too: the other half judged
  std::vector<gap::SampleTotals> samples;  ///< the held-out ones; empty if the report does not list them
  std::optional<gap::Rest> rest;           ///< what the verdict leaves unexplained
  std::vector<gap::TwiceJudgedTest> flips;
  std::string next_experiment;
  nlohmann::json proposed_model;  ///< null if there is none

  /// The causes that the verdict names and that are effects: what CEPRA rows can stand for.
  [[nodiscard]] std::vector<const gap::Cause*> namedEffects() const;
};

/// Keys that this program does not know are passed over: a later version says more. Throws InputError for a file that
/// is no gap report, with the JSON Pointer of what is wrong.
[[nodiscard]] GapReport readGapReport(const std::filesystem::path& file);
[[nodiscard]] GapReport parseGapReport(const nlohmann::json& json, const std::filesystem::path& file);

}  // namespace proposals
