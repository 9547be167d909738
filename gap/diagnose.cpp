#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <chrono>
#include <cmath>

#include "gap/background.h"
#include "gap/candidates.h"
#include "gap/decision.h"
#include "gap/diagnosis.h"
#include "gap/evidence_limits.h"
#include "gap/how_far.h"
#include "gap/pictures.h"
#include "gap/wording.h"
#include "model/external/external_runs.h"

namespace gap {

namespace {

/// docs/diagnosis.md gives the reasons for these bounds.
constexpr double kSignificance = 1e-3;    // of the gap being present at all
constexpr double kClear = 5.0;            // standard deviations: a gap beyond doubt
constexpr double kMaterialTotal = 1.5;    // times the total gap of a right model
constexpr std::size_t kQuickBeams = 360;  // of a sample, with which candidates are chosen
constexpr std::size_t kMostBeams = 6000;  // of a sample, with which they are judged: more cost minutes and tell no more
constexpr double kPairBelief = 0.7;       // of a pair that explains everything
constexpr double kNoneBelief = 0.85;      // that nothing is missing, where nothing is seen
constexpr double kMuchClearer = 3.0;      // so much more must one part of the samples show than the other
constexpr double kMaterialSteps = 0.25;   // of the resolution: smaller deviations are not called a gap

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

Cause toCause(const Candidate& candidate) {
  Cause cause;
  cause.kind = candidate.hypothesis.kind;
  cause.name = candidate.hypothesis.name;
  cause.variant = candidate.hypothesis.variant;
  cause.sensors = candidate.hypothesis.sensors;
  cause.percollect = candidate.hypothesis.percollect;
  cause.decomposition_block = candidate.hypothesis.decomposition_block;
  cause.explained = std::min(1.0, candidate.explained);
  for (std::size_t i = 0; i < candidate.values.size(); ++i) {
    const FreeParameter& p = candidate.hypothesis.parameters[i];
    FittedParameter fitted{p.name, p.unit, candidate.values[i], std::nullopt, Interval{p.low, p.high}, std::nullopt};
    if (cause.kind == CauseKind::kParameter) fitted.recorded = p.start;
    if (candidate.hypothesis.per_setup) {
      cause.setups[p.name] = fitted;
    } else {
      cause.parameters.push_back(fitted);
    }
  }
  return cause;
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

/// The causes that are listed, the verdict's first.
void fillCauses(const Replay& replay, const Split& split, const Decision& decision, std::uint64_t seed,
                Diagnosis& diagnosis, const core::Progress& progress) {
  constexpr std::size_t kListed = 6;
  // Pooled data show no map, so what a cause does to single beams is not seen.
  const bool pooled = replay.samples().front().layout->pooled();
  const auto confidences = confidencesOf(decision, split.weak || pooled);
  if (decision.pair()) {
    diagnosis.causes = splitPair(*decision.winner);
    for (Cause& cause : diagnosis.causes)
      cause.confidence = kPairBelief * std::clamp(decision.winner->explained, 0.0, 1.0);
  }
  std::vector<std::string> listed;
  for (const Cause& cause : diagnosis.causes) listed.push_back(cause.name);
  for (std::size_t i = 0; i < decision.singles.size() && diagnosis.causes.size() < kListed; ++i) {
    const Candidate& candidate = decision.singles[i];
    if (std::find(listed.begin(), listed.end(), candidate.hypothesis.name) != listed.end()) continue;
    if (candidate.explained < 0.02) break;
    listed.push_back(candidate.hypothesis.name);
    diagnosis.causes.push_back(toCause(candidate));
    diagnosis.causes.back().confidence = decision.pair() ? 0.05 * confidences[i] : confidences[i];
    const bool is_winner = decision.winner && !decision.pair() && i == 0;  // gets its shrink with the interval
    if (is_winner) continue;
    const World world = worldOf(replay, candidate.hypothesis, candidate.values);
    diagnosis.causes.back().shrink = howFar(replay, world, split.held_out.samples, seed, progress).shrink;
  }
}

/// What the winner brings: shrink, intervals of its parameters, a model file if one can hold it.
void fillWinner(const Replay& quick, const Split& split, const Decision& decision, const World& after,
                const BeforeAfter& far, Diagnosis& diagnosis, core::Progress& progress) {
  diagnosis.after = far.after;
  diagnosis.shrink = far.shrink;
  diagnosis.held_out_totals = far.samples;
  progress.report(0.92, "intervals of the parameters");
  const auto intervals =
      parameterIntervals(quick, decision.winner->hypothesis, decision.winner->values, split.refined, progress);
  std::size_t used = 0;
  for (std::size_t c = 0; c < (decision.pair() ? 2U : 1U); ++c) {
    Cause& cause = diagnosis.causes[c];
    cause.shrink = far.shrink;
    for (FittedParameter& parameter : cause.parameters) {
      if (used >= intervals.size()) break;
      parameter.interval = intervals[used++];
    }
  }
  if (diagnosis.approximation) return;  // the model under test has no effects that a file could name
  // Materials and references stand in the experiment; what belongs to the model is proposed even beside them.
  if (after.model.json != quick.baseline().model.json) {
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
  next.sample = replay.samples()[best].sample->id;
  next.predictions = predictionsOf(replay, {replay.baseline(), a, b}, best, split.fitted.seed);
  next.text = nextExperimentSentence(next, replay.samples()[best].sample->id);
  return next;
}

/// Few data never make a verdict that anybody should rely upon, whatever they seem to say.
void heedLimits(Diagnosis& diagnosis) {
  Verdict& verdict = diagnosis.verdict;
  const double most = mostConfidence(verdict.limits.size());
  verdict.confidence = std::min(verdict.confidence, most);
  for (Cause& cause : diagnosis.causes) cause.confidence = std::min(cause.confidence, most);
}

/// A cause that was found by way of a proxy is as good as the proxy.
void heedApproximation(Diagnosis& diagnosis) {
  if (!diagnosis.approximation || diagnosis.verdict.kind == VerdictKind::kNone)
    return;  // no proxy takes part in `none`
  const double trust = diagnosis.approximation->trust();
  for (Cause& cause : diagnosis.causes) cause.confidence *= trust;
  if (!diagnosis.verdict.names.empty()) diagnosis.verdict.confidence *= trust;
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
  const auto start = std::chrono::steady_clock::now();
  const std::uint64_t seed = options.seed.value_or(given.seed);
  model::LidarModel model = withInlineSensor(given.external ? proxyOf(experiment, given, options.proxy) : given);
  model.seed = seed;  // under it a foreign model is what it reported
  const std::vector<model::ExternalRun> foreign = model::nominalRuns(experiment, given, seed, progress);
  progress.report(0.0, "tracing the samples");
  const Replay replay(experiment, model, kMostBeams, foreign);
  std::optional<Replay> few_beams(std::in_place, experiment, model, kQuickBeams, foreign);
  if (!few_beams->thinned()) few_beams.reset();
  const Replay& quick = few_beams ? *few_beams : replay;
  progress.report(0.05, "comparing with the baseline");
  Split split = splitOf(replay, seed);
  Yardstick yardstick = yardstickOf(replay, split.held_out);
  const double z_held = yardstick.z(), z_fitted = yardstickOf(replay, split.fitted).z();
  if (std::min(z_held, z_fitted) < std::min(kClear, std::max(z_held, z_fitted) / kMuchClearer)) {
    // The gap shows in held-out samples only, or in the others only: then beams of all samples judge.
    split = splitByBeams(replay, seed);
    yardstick = yardstickOf(replay, split.held_out);
  }
  const double z = yardstick.z();
  const WhereResult where = whereIn(replay, replay.baseline(), seed);

  Diagnosis diagnosis;
  diagnosis.experiment = experiment.id;
  diagnosis.model = given.id;
  diagnosis.synthetic = experiment.synthetic();
  diagnosis.where = where.rows;
  diagnosis.weak_hold_out = split.weak;
  for (const std::size_t s : split.held_out.samples) diagnosis.held_out.push_back(replay.samples()[s].sample->id);
  diagnosis.p_value = boost::math::cdf(boost::math::complement(boost::math::normal(), std::clamp(z, -37.0, 37.0)));
  const double total = totalOf(replay, replay.baseline(), split.held_out.samples, seed);
  const double floor = selfTotalOf(replay, replay.baseline(), split.held_out.samples, seed);
  const bool material = where.largest_steps >= kMaterialSteps || total > kMaterialTotal * floor;
  const bool clear = diagnosis.p_value < kSignificance && material;
  Decision decision = decide({quick, split, few_beams ? yardstickOf(quick, split.held_out) : yardstick},
                             {replay, split, yardstick}, clear, where.rows, options.library, progress);
  diagnosis.background = backgroundOf(replay, split, decision);
  progress.report(0.86, "measuring how far the gap shrinks");
  const World after =
      decision.winner ? worldOf(replay, decision.winner->hypothesis, decision.winner->values) : replay.baseline();
  const BeforeAfter far = howFar(replay, after, split.held_out.samples, seed, progress);
  diagnosis.before = far.before;
  diagnosis.bias_intervals = far.bias_intervals;
  if (decision.winner && far.shrink.fraction <= 0.0) {  // it fits single cells, and the gap is none the smaller for it
    decision.winner.reset();
    decision.kind = clear ? VerdictKind::kUnknown : VerdictKind::kNone;
  }
  diagnosis.verdict.kind = decision.kind;
  diagnosis.present = decision.kind != VerdictKind::kNone;
  if (given.external) {
    diagnosis.approximation = approximationOf(replay, split.held_out.samples, seed, diagnosis.present);
  }
  if (!diagnosis.present) decision.singles.clear();  // where nothing is to be explained, nothing has a cause
  if (!clear && diagnosis.present) diagnosis.p_value = decision.p_value;
  fillCauses(replay, split, decision, seed, diagnosis, progress);
  if (decision.winner) fillWinner(quick, split, decision, after, far, diagnosis, progress);
  diagnosis.maps = residualMaps(replay, where.tables);
  diagnosis.curves =
      beforeAfterValues(replay, where.tables, split.held_out.samples, decision.winner ? &after : nullptr, seed);
  diagnosis.confusion = confusionOf(quick, worldsOf(quick, decision, diagnosis.causes), split.held_out);
  Verdict& verdict = diagnosis.verdict;
  if (decision.winner) {
    verdict.names = decision.names();
    // A cause that explains single cells but leaves the pooled gap as it was deserves little trust.
    const double trust = std::clamp(1.2 - decision.left_of_total, 0.3, 1.0);
    for (std::size_t c = 0; c < (decision.pair() ? 2U : 1U); ++c) diagnosis.causes[c].confidence *= trust;
    verdict.confidence = diagnosis.causes.front().confidence;
    if (!decision.pair()) verdict.indistinguishable_from = decision.ties;
    diagnosis.next_experiment = nextExperiment(replay, split, decision);
  } else if (verdict.kind == VerdictKind::kNone) {
    verdict.confidence = diagnosis.p_value >= kSignificance ? kNoneBelief : 0.7;
  } else {
    const double best = decision.singles.empty() ? 0.0 : std::max(0.0, decision.singles.front().explained);
    verdict.confidence = std::clamp(0.8 * (1.0 - best), 0.3, 0.8);
  }
  verdict.limits = limitsOf(replay, split);
  diagnosis.notes = notesOn(replay);
  heedApproximation(diagnosis);
  heedLimits(diagnosis);
  verdict.text = verdictSentence(diagnosis);
  diagnosis.elapsed_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  progress.report(1.0, "done");
  return diagnosis;
}

}  // namespace gap
