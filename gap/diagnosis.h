#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/progress.h"
#include "gap/candidates/tried.h"
#include "gap/causes/hypotheses.h"
#include "gap/distance/total_gap.h"
#include "gap/far/how_far.h"
#include "gap/far/proxy.h"
#include "gap/twice_judged_test.h"
#include "gap/unexplained/rest.h"
#include "gap/where/pictures.h"
#include "gap/where/where.h"
#include "gap/which/ablation.h"
#include "gap/which/confusion.h"
#include "gap/which/decision.h"

namespace gap {

/// A fitted number with its uncertainty over the set-ups.
struct FittedParameter {
  std::string name;
  std::string unit;
  double value = 0.0;
  std::optional<Interval> interval;   ///< 95 %, over set-ups; absent where it was not computed
  std::optional<Interval> plausible;  ///< the range that was searched
  std::optional<double> recorded;     ///< what the model file or the experiment says, of a wrong parameter
  bool at_end = false;                ///< of that range, the upper one: the data may ask for more
};

/// A hypothesis after its fit.
struct Cause {
  CauseKind kind = CauseKind::kEffect;
  std::string name;
  std::string variant;
  std::vector<std::string> sensors;  ///< on which alone it holds; empty: on all
  std::vector<std::string> percollect;
  std::string decomposition_block;
  double confidence = 0.0;
  double explained = 0.0;  ///< share of the explainable discrepancy on held-out data
  std::vector<FittedParameter> parameters;
  std::map<std::string, FittedParameter> setups;  ///< reference offsets per set-up
  Shrink shrink;
  std::vector<std::string> chain;  ///< node ids from the cause up to the phenomenon, if a graph was given
  std::vector<std::string> chain_titles;
};

/// What speaks for the best cause (or pair), on held-out data.
struct VerdictEvidence {
  double explained = 0.0;   ///< share of the explainable discrepancy
  double total_left = 1.0;  ///< of the total gap, beyond what a right model leaves (HeldOutGaps::leftIn)
  double lead = 0.0;        ///< of its merit (Judge::meritOf) over that of the next cause of another name
  double gap_z = 0.0;       ///< of the gap before any cause was added, in standard deviations of noise
};

/// Two causes that together come nearer than any alone, though not near enough to be named.
struct NearestPair {
  std::vector<std::string> names;
  double explained = 0.0;  ///< share of the explainable discrepancy, held-out
};

struct Verdict {
  VerdictKind kind = VerdictKind::kUnknown;
  std::vector<std::string> names;
  double confidence = 0.0;
  std::vector<std::string> indistinguishable_from;
  VerdictEvidence evidence;
  /// Numbers and references that were fitted together with the effects named: part of the shrink is theirs.
  std::vector<std::string> beside;
  Contradiction contradiction = Contradiction::kNone;  ///< why it is `unknown`, whatever the nearest cause explains
  std::optional<NearestPair> nearest_pair;             ///< of `unknown`
  std::vector<std::string> limits;  ///< why the data are too few to be sure, clauses; the confidence is low then
  std::string text;

  [[nodiscard]] bool isNamed(const std::string& cause) const;
  [[nodiscard]] bool isBeside(const std::string& cause) const;
  /// Whether it is one of those that the answer is made of.
  [[nodiscard]] bool holds(const std::string& cause) const { return isNamed(cause) || isBeside(cause); }
  /// Whether it is made of two.
  [[nodiscard]] bool holdsSeveral() const { return names.size() + beside.size() > 1; }
};

struct NextExperiment {
  std::string text;
  std::vector<std::string> separates;
  std::map<std::string, double> parameters;
  std::string sample;                   ///< that has these parameters
  std::vector<Prediction> predictions;  ///< of the model as it is and of the two that it separates
};

/// What a reader must know of the data to weigh the answer.
struct Background {
  std::vector<std::string> objects;  ///< ids, in the order of the scene
  std::vector<std::string> fitted;   ///< samples that were fitted
  std::size_t frames = 0;
  std::size_t detections = 0;
  std::size_t hypotheses = 0;        ///< how many were tried
  std::vector<std::string> effects;  ///< that the model already has
};

/// A p-value below which a gap is no chance (docs/diagnosis.md). Where one is so sure and none is named all the same,
/// it is too small against the sensor's resolution to matter.
inline constexpr double kSignificance = 1e-3;

/// The answer to: where does the simulation differ, which cause explains it, how far does the gap shrink?
struct Diagnosis {
  std::string experiment;
  std::string model;
  bool synthetic = false;
  bool present = false;
  double p_value = 1.0;
  TotalGap before;                                 ///< mean over the held-out samples
  std::map<std::string, Interval> bias_intervals;  ///< of d_bias per measurand, over set-ups and frames
  std::vector<WhereRow> where;
  Verdict verdict;
  std::vector<Cause> causes;      ///< best first; two for a pair come first, in one verdict
  std::optional<TotalGap> after;  ///< with the verdict's cause added
  Shrink shrink;
  std::optional<AsRun> as_run;  ///< of the built-in lidar
  std::vector<std::string> held_out;
  std::vector<SampleTotals> held_out_totals;   ///< of each of them, if a cause was added
  bool weak_hold_out = false;                  ///< beams of all samples judged: too few samples show the gap
  std::vector<std::string> notes;              ///< what a person should know of the data, sentences
  std::optional<Approximation> approximation;  ///< if the model under test is not the built-in lidar
  std::optional<NextExperiment> next_experiment;
  std::vector<ResidualMap> maps;          ///< of the samples that deviate most, both components of a measurand
  std::vector<BeforeAfterValues> curves;  ///< of the measurand that deviates most, up to three held-out samples
  nlohmann::json proposed_model;          ///< null if the verdict names nothing that a model file can hold
  std::optional<Rest> rest;               ///< what the verdict leaves unexplained, if there is a gap
  Confusion confusion;                    ///< of the causes, in their order
  Background background;
  std::vector<Tried> tried;                                      ///< every hypothesis, if DiagnoseOptions::list_tried
  std::optional<std::vector<TwiceJudgedTest>> acceptance_tests;  ///< of a project, if one was given
  double elapsed_s = 0.0;
};

struct DiagnoseOptions {
  std::vector<std::string> library;  ///< effects to consider; empty: all
  std::optional<std::uint64_t> seed;
  std::optional<model::LidarModel> proxy;  ///< stands for a model that is not the built-in lidar (proxy.h)
  bool list_tried = false;                 ///< fill Diagnosis::tried, which costs some time
  Ablation without;                        ///< to see what parts of the diagnosis bring
};

/// Diagnoses the gap between the measurements of an experiment package and their re-simulation (docs/diagnosis.md).
/// Throws InputError for unusable input, Cancelled if the progress says so.
[[nodiscard]] Diagnosis diagnose(const model::Experiment& experiment, const model::LidarModel& model,
                                 const DiagnoseOptions& options, core::Progress& progress);

}  // namespace gap
