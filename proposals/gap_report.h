#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "gap/proxy.h"

namespace proposals {

using Range = std::pair<double, double>;  ///< low, high

/// One measurand (or existence, as "missing" and "extra") before and after the cause was added to the model.
struct ReportedGap {
  std::string name;
  std::string unit;
  double resolution = 0.0;  ///< 0: the report does not say
  double bias = 0.0;        ///< d_bias; a share for "missing" and "extra"
  double scatter = 0.0;     ///< d_cavm; 0 for "missing" and "extra"
  std::optional<Range> bias_interval;
  std::optional<double> bias_after;
  std::optional<double> scatter_after;

  /// What it adds to the total gap. [1] As formats.md section 6 weighs it; 0 if the resolution is not known.
  [[nodiscard]] double weight() const;
};

struct ReportedPlace {
  std::string measurand;
  std::string component;
  std::string covariate;
  std::string stratum;  ///< "33 to 62", or names
  double value = 0.0;
  std::string unit;
  double share = 0.0;
  std::string block;
  std::string text;
};

struct ReportedParameter {
  std::string name;
  std::string unit;
  double value = 0.0;
  std::optional<Range> interval;
};

struct ReportedCause {
  std::string kind;
  std::string name;
  std::vector<std::string> percollect;
  std::vector<std::string> chain;
  std::vector<std::string> chain_titles;
  double confidence = 0.0;
  double explained = 0.0;
  double shrink = 0.0;
  std::optional<Range> shrink_interval;
  std::vector<ReportedParameter> parameters;  ///< of set-ups too, by their names
};

/// Total gap of one held-out sample.
struct ReportedSample {
  std::string id;
  std::string setup;
  double before = 0.0;
  double after = 0.0;
};

struct ReportedFlip {
  std::string test;
  std::string title;
  std::string before;
  std::string after;
  std::string text_after;
};

/// A gap report (formats.md section 6) as it was written, on whatever day and machine.
struct GapReport {
  std::filesystem::path file;
  std::string sha256;    ///< of the file
  std::string evidence;  ///< SHA-256 of its content without `elapsed_s`: two runs of one diagnosis agree
  std::string experiment;
  std::string model;
  bool synthetic = false;
  bool present = false;
  std::vector<ReportedGap> gaps;
  std::vector<ReportedPlace> where;
  std::string verdict;  ///< "none", "effect", "parameter", "reference", "unknown"
  std::vector<std::string> names;
  std::vector<std::string> indistinguishable_from;
  double confidence = 0.0;
  std::string text;
  std::optional<gap::Approximation> approximation;  ///< if the model under test is not the built-in lidar
  std::vector<std::string> notes;                   ///< what a person should know of the data, sentences
  std::vector<ReportedCause> causes;
  std::optional<double> shrink;
  std::optional<Range> shrink_interval;
  std::optional<Range> totals;  ///< before, after
  std::vector<std::string> held_out;
  std::vector<ReportedSample> samples;  ///< the held-out ones; empty if the report does not list them
  std::vector<ReportedFlip> flips;
  std::string next_experiment;
  nlohmann::json proposed_model;  ///< null if there is none

  /// The causes that the verdict names and that are effects: what CEPRA rows can stand for.
  [[nodiscard]] std::vector<const ReportedCause*> namedEffects() const;
};

/// Keys that this program does not know are passed over: a later version says more. Throws InputError for a file that
/// is no gap report, with the JSON Pointer of what is wrong.
[[nodiscard]] GapReport readGapReport(const std::filesystem::path& file);
[[nodiscard]] GapReport parseGapReport(const nlohmann::json& json, const std::filesystem::path& file);

}  // namespace proposals
