#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <chrono>
#include <cmath>

#include "gap/candidates.h"
#include "gap/diagnosis.h"
#include "gap/how_far.h"
#include "gap/pictures.h"
#include "gap/settle.h"
#include "gap/wording.h"
#include "model/external/external_runs.h"

namespace gap {

namespace {

constexpr int kWhereFrames = 24;
/// docs/diagnosis.md gives the reasons for these bounds.
constexpr double kSignificance = 1e-3;   // of the gap being present at all
constexpr double kClear = 5.0;           // standard deviations: a gap beyond doubt
constexpr double kMaterialSteps = 0.25;  // of the resolution: smaller deviations are not called a gap
constexpr double kExplains = 0.70;       // share that a cause must explain on held-out data to be named
constexpr double kLooksFurther = 0.93;   // below it pairs are tried
constexpr double kPairGain = 0.5;        // a pair must halve what its best member leaves
constexpr double kTie = 0.02;            // merits this close cannot be told apart

/// The model file with a sensor profile in place of a profile's name, so that pointers lead into it.
model::LidarModel withInlineSensor(const model::LidarModel& model) {
  nlohmann::json json = model.json;
  if (json.contains("sensor")) json["sensor"] = model::sensorProfileJson(json["sensor"], model.file, "/sensor");
  if (json.contains("sensors")) {
    for (auto& [name, value] : json["sensors"].items())
      value = model::sensorProfileJson(value, model.file, "/sensors/" + name);
  }
  return model::parseModel(json, model.file);
}

struct WhereResult {
  std::vector<WhereRow> rows;
  std::vector<ResidualTable> tables;
  double largest_steps = 0.0;  ///< largest stratum value in resolution steps
};

WhereResult findWhere(const Replay& replay, const World& world, std::uint64_t seed) {
  std::vector<std::vector<CellStatistics>> simulated(replay.samples().size());
  std::vector<int> frames(replay.samples().size());
  std::vector<Comparison> comparisons;
  for (std::size_t s = 0; s < replay.samples().size(); ++s) {
    const ReplaySample& sample = replay.samples()[s];
    frames[s] = std::clamp(sample.frames, 3, kWhereFrames);
    comparisons.push_back({s, sample.statistics, sample.frames, replay.simulate(world, s, frames[s], seed), frames[s]});
  }
  settle(replay, world, comparisons, Half::kAll);
  for (std::size_t s = 0; s < simulated.size(); ++s) simulated[s] = std::move(comparisons[s].simulated);
  WhereResult result;
  result.tables = residualTables(replay, simulated, frames);
  result.rows = whereRows(replay, result.tables, simulated);
  for (const ResidualTable& table : result.tables) {
    result.largest_steps = std::max({result.largest_steps, table.excess(), table.commonShift()});
  }
  for (const WhereRow& row : result.rows) {
    for (const ResidualTable& table : result.tables) {
      if (table.measurand != row.measurand || table.component != row.component || row.p_value > kSignificance) continue;
      result.largest_steps = std::max(result.largest_steps, std::abs(row.value) / table.scale);
    }
  }
  return result;
}

Cause toCause(const Candidate& candidate) {
  Cause cause;
  cause.kind = candidate.hypothesis.kind;
  cause.name = candidate.hypothesis.name;
  cause.variant = candidate.hypothesis.variant;
  cause.percollect = candidate.hypothesis.percollect;
  cause.decomposition_block = candidate.hypothesis.decomposition_block;
  cause.explained = candidate.explained;
  for (std::size_t i = 0; i < candidate.values.size(); ++i) {
    const FreeParameter& p = candidate.hypothesis.parameters[i];
    const FittedParameter fitted{p.name, p.unit, candidate.values[i], std::nullopt};
    if (candidate.hypothesis.per_setup) {
      cause.setups[p.name] = fitted;
    } else {
      cause.parameters.push_back(fitted);
    }
  }
  return cause;
}

/// Share of belief for each candidate: a softmax of merits, with the share that no candidate explains left over.
/// Not yet calibrated on withheld cases.
std::vector<double> confidencesOf(const std::vector<Candidate>& candidates, bool weak) {
  std::vector<double> confidences(candidates.size(), 0.0);
  if (candidates.empty()) return confidences;
  const double best = candidates.front().merit();
  double sum = 0.0;
  std::map<std::string, double> best_of_name;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const std::string& name = candidates[i].hypothesis.name;
    if (best_of_name.count(name)) continue;  // variants of one cause share its belief
    confidences[i] = best_of_name[name] = std::exp((candidates[i].merit() - best) / kTie);
    sum += confidences[i];
  }
  const double trust = std::clamp((best - 0.4) / 0.5, 0.0, 1.0) * (weak ? 0.6 : 1.0);
  for (double& confidence : confidences) confidence *= 0.98 * trust / sum;
  return confidences;
}

std::vector<std::string> tiesOf(const std::vector<Candidate>& candidates) {
  std::vector<std::string> ties;
  for (std::size_t i = 1; i < candidates.size(); ++i) {
    const std::string& name = candidates[i].hypothesis.name;
    if (candidates[i].merit() < candidates.front().merit() - kTie || name == candidates.front().hypothesis.name)
      continue;
    if (std::find(ties.begin(), ties.end(), name) == ties.end()) ties.push_back(name);
  }
  return ties;
}

VerdictKind kindOf(CauseKind kind) {
  switch (kind) {
    case CauseKind::kEffect:
      return VerdictKind::kEffect;
    case CauseKind::kParameter:
      return VerdictKind::kParameter;
    case CauseKind::kReference:
      return VerdictKind::kReference;
  }
  return VerdictKind::kUnknown;
}

/// The two members of a pair as causes of their own.
std::vector<Cause> splitPair(const Candidate& pair) {
  std::vector<Cause> causes;
  auto values = pair.values.begin();
  for (const Hypothesis& hypothesis : pair.hypothesis.members) {
    Candidate member;
    member.hypothesis = hypothesis;
    const auto end = values + static_cast<std::ptrdiff_t>(hypothesis.parameters.size());
    member.values.assign(values, end);
    values = end;
    member.explained = pair.explained;
    causes.push_back(toCause(member));
  }
  return causes;
}

/// What the search ended with.
struct Decision {
  VerdictKind kind = VerdictKind::kUnknown;
  std::optional<Candidate> winner;
  bool pair = false;
  std::vector<Candidate> singles;
};

Decision decide(const Replay& replay, const Split& split, const Yardstick& yardstick,
                const std::vector<WhereRow>& where, const DiagnoseOptions& options, core::Progress& progress) {
  Decision decision;
  core::PartOfProgress first(progress, 0.1, 0.6), second(progress, 0.6, 0.85);
  decision.singles = rank(replay, split, yardstick, hypothesesFor(replay, options.library), where, first);
  polish(replay, split, yardstick, decision.singles, progress);
  const Candidate& best = decision.singles.front();
  std::vector<Candidate> pairs;
  if (best.explained < kLooksFurther && best.explained > 0.2) {
    pairs = rankPairs(replay, split, yardstick, decision.singles, second);
    polish(replay, split, yardstick, pairs, progress);
  }
  const bool pair_wins = !pairs.empty() && pairs.front().explained >= kExplains &&
                         1.0 - pairs.front().explained < kPairGain * (1.0 - best.explained) &&
                         pairs.front().explained > best.explained + 0.05;
  if (pair_wins) {
    decision.pair = true;
    decision.winner = pairs.front();
    decision.kind = VerdictKind::kEffect;
  } else if (best.explained >= kExplains) {
    decision.winner = best;
    decision.kind = kindOf(best.hypothesis.kind);
  }
  return decision;
}

/// The causes that are listed, the verdict's first.
void fillCauses(const Replay& replay, const Split& split, const Decision& decision, std::uint64_t seed,
                Diagnosis& diagnosis) {
  constexpr std::size_t kListed = 6;
  // Pooled data show no map, so what a cause does to single beams is not seen.
  const bool pooled = replay.samples().front().layout->pooled();
  const auto confidences = confidencesOf(decision.singles, split.weak || pooled);
  if (decision.pair) {
    diagnosis.causes = splitPair(*decision.winner);
    for (Cause& cause : diagnosis.causes) cause.confidence = 0.9 * std::clamp(decision.winner->explained, 0.0, 1.0);
  }
  std::vector<std::string> listed;
  for (const Cause& cause : diagnosis.causes) listed.push_back(cause.name);
  for (std::size_t i = 0; i < decision.singles.size() && diagnosis.causes.size() < kListed; ++i) {
    const Candidate& candidate = decision.singles[i];
    if (std::find(listed.begin(), listed.end(), candidate.hypothesis.name) != listed.end()) continue;
    if (candidate.explained < 0.02) break;
    listed.push_back(candidate.hypothesis.name);
    diagnosis.causes.push_back(toCause(candidate));
    diagnosis.causes.back().confidence = decision.pair ? 0.05 * confidences[i] : confidences[i];
    const bool is_winner = decision.winner && !decision.pair && i == 0;  // gets its shrink with the interval
    if (is_winner) continue;
    const double shrink = shrinkOn(replay, worldOf(replay, candidate.hypothesis, candidate.values),
                                   split.held_out.samples, diagnosis.before.total, seed);
    diagnosis.causes.back().shrink = {shrink, {shrink, shrink}};
  }
}

/// What the winner brings: shrink, intervals of its parameters, a model file if one can hold it.
void fillWinner(const Replay& replay, const Split& split, const Decision& decision, const World& after,
                const BeforeAfter& far, Diagnosis& diagnosis, core::Progress& progress) {
  diagnosis.after = far.after;
  diagnosis.shrink = far.shrink;
  progress.report(0.92, "intervals of the parameters");
  const auto intervals =
      parameterIntervals(replay, decision.winner->hypothesis, decision.winner->values, split.refined, progress);
  std::size_t used = 0;
  for (std::size_t c = 0; c < (decision.pair ? 2U : 1U); ++c) {
    Cause& cause = diagnosis.causes[c];
    cause.shrink = far.shrink;
    for (FittedParameter& parameter : cause.parameters) {
      if (used >= intervals.size()) break;
      parameter.interval = intervals[used++];
    }
  }
  const bool in_model_file = after.reflectivity.empty() && after.references.empty();
  if (in_model_file) {
    diagnosis.proposed_model = after.model.json;
    diagnosis.proposed_model["id"] = after.model.id + "-proposed";
  }
}

/// The fitted or held-out sample at which the two best candidates differ most.
std::optional<NextExperiment> nextExperiment(const Replay& replay, const Split& split, const Decision& decision) {
  std::vector<const Candidate*> rivals;
  for (const Candidate& candidate : decision.singles) {
    if (rivals.empty() || candidate.hypothesis.name != rivals.front()->hypothesis.name) rivals.push_back(&candidate);
    if (rivals.size() == 2) break;
  }
  if (rivals.size() < 2) return std::nullopt;
  const World a = worldOf(replay, rivals[0]->hypothesis, rivals[0]->values);
  const World b = worldOf(replay, rivals[1]->hypothesis, rivals[1]->values);
  std::size_t best = 0;
  double largest = -1.0;
  for (std::size_t s = 0; s < replay.samples().size(); ++s) {
    const int frames = std::min(8, std::max(3, replay.samples()[s].frames));
    const auto of_a = replay.simulate(a, s, frames, split.fitted.seed);
    const double difference =
        discrepancy(replay, {s, of_a, frames, replay.simulate(b, s, frames, split.fitted.seed), frames});
    if (difference > largest) {
      largest = difference;
      best = s;
    }
  }
  NextExperiment next;
  next.separates = {rivals[0]->hypothesis.name, rivals[1]->hypothesis.name};
  next.parameters = replay.samples()[best].sample->parameters;
  next.text = nextExperimentSentence(next, replay.samples()[best].sample->id);
  return next;
}

}  // namespace

std::string toString(VerdictKind kind) {
  switch (kind) {
    case VerdictKind::kNone:
      return "none";
    case VerdictKind::kEffect:
      return "effect";
    case VerdictKind::kParameter:
      return "parameter";
    case VerdictKind::kReference:
      return "reference";
    case VerdictKind::kUnknown:
      return "unknown";
  }
  return "";
}

Diagnosis diagnose(const model::Experiment& experiment, const model::LidarModel& given, const DiagnoseOptions& options,
                   core::Progress& progress) {
  model::requireBuiltIn(given, "the diagnosis");
  const auto start = std::chrono::steady_clock::now();
  const model::LidarModel model = withInlineSensor(given);
  const std::uint64_t seed = options.seed.value_or(model.seed);
  progress.report(0.0, "tracing the samples");
  const Replay replay(experiment, model);
  progress.report(0.05, "comparing with the baseline");
  Split split = splitOf(replay, seed);
  Yardstick yardstick = yardstickOf(replay, split);
  double z = yardstick.z();
  if (z < kClear) {
    // The gap may lie in samples that were not held out only: then beams of all samples judge.
    const Split by_beams = splitByBeams(replay, seed);
    const Yardstick of_all = yardstickOf(replay, by_beams);
    if (of_all.z() > kClear) {
      split = by_beams;
      yardstick = of_all;
      z = of_all.z();
    }
  }
  const WhereResult where = findWhere(replay, replay.baseline(), seed);

  Diagnosis diagnosis;
  diagnosis.experiment = experiment.id;
  diagnosis.model = model.id;
  diagnosis.synthetic = experiment.synthetic();
  diagnosis.where = where.rows;
  diagnosis.weak_hold_out = split.weak;
  for (const std::size_t s : split.held_out.samples) diagnosis.held_out.push_back(replay.samples()[s].sample->id);
  diagnosis.p_value = boost::math::cdf(boost::math::complement(boost::math::normal(), std::clamp(z, -37.0, 37.0)));
  diagnosis.present = diagnosis.p_value < kSignificance && where.largest_steps >= kMaterialSteps;

  Decision decision;
  if (diagnosis.present) {
    decision = decide(replay, split, yardstick, where.rows, options, progress);
    diagnosis.verdict.kind = decision.kind;
  } else {
    diagnosis.verdict.kind = VerdictKind::kNone;
  }
  progress.report(0.86, "measuring how far the gap shrinks");
  const World after =
      decision.winner ? worldOf(replay, decision.winner->hypothesis, decision.winner->values) : replay.baseline();
  const BeforeAfter far = howFar(replay, after, split.held_out.samples, seed, progress);
  diagnosis.before = far.before;
  diagnosis.bias_intervals = far.bias_intervals;
  fillCauses(replay, split, decision, seed, diagnosis);
  if (decision.winner) fillWinner(replay, split, decision, after, far, diagnosis, progress);
  diagnosis.maps = residualMaps(replay, where.tables);
  diagnosis.curves =
      beforeAfterValues(replay, where.tables, split.held_out.samples, decision.winner ? &after : nullptr, seed);
  Verdict& verdict = diagnosis.verdict;
  if (decision.winner) {
    for (std::size_t c = 0; c < (decision.pair ? 2U : 1U); ++c) verdict.names.push_back(diagnosis.causes[c].name);
    verdict.confidence = diagnosis.causes.front().confidence;
    if (!decision.pair) verdict.indistinguishable_from = tiesOf(decision.singles);
    diagnosis.next_experiment = nextExperiment(replay, split, decision);
  } else if (verdict.kind == VerdictKind::kNone) {
    verdict.confidence = diagnosis.p_value >= kSignificance ? 0.97 : 0.85;
  } else {
    verdict.confidence = std::clamp(
        1.0 - (decision.singles.empty() ? 0.0 : std::max(0.0, decision.singles.front().explained)), 0.3, 0.95);
  }
  verdict.text = verdictSentence(diagnosis);
  diagnosis.elapsed_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  progress.report(1.0, "done");
  return diagnosis;
}

}  // namespace gap
