#include <algorithm>
#include <chrono>
#include <utility>

#include "core/forward_progress.h"
#include "gap/background.h"
#include "gap/candidates/candidates.h"
#include "gap/candidates/whole_gap.h"
#include "gap/diagnosis.h"
#include "gap/distance/models_grid.h"
#include "gap/far/how_far.h"
#include "gap/far/parameter_intervals.h"
#include "gap/next_experiment.h"
#include "gap/report/wording.h"
#include "gap/unexplained/direction_laws.h"
#include "gap/unexplained/frame_mode.h"
#include "gap/unexplained/uneven_loss.h"
#include "gap/verdict.h"
#include "gap/where/pictures.h"
#include "gap/which/evidence_limits.h"
#include "gap/which/ruling.h"
#include "model/external/external_runs.h"

namespace gap {

namespace {

/// docs/diagnosis.md gives the reasons for these bounds.
constexpr double kConvincing = 0.85;     // of the gap: a cause that accounts for so much stands beside them
constexpr double kMostOfTheGap = 0.5;    // gone without what moves whole frames: nothing else explains the gap
constexpr double kWeightOfTotal = 0.3;   // of what is left of the total gap beside what is left cell by cell
constexpr double kBeyondDoubt = 1e-9;    // of a stratum, all others that were looked at allowed for: six sigma
constexpr double kMaterialSteps = 0.25;  // of the resolution: smaller deviations are not called a gap

/// With which candidates are judged; more cost minutes and tell no more.
constexpr Detail kExact{.most_beams = 6000, .edge_rays = 33};
/// As the model traces when anybody runs it.
constexpr Detail kAsRun{.most_beams = kExact.most_beams, .edge_rays = 0, .joined = false};

/// With which candidates are chosen, in half the time: so many beams of a sample that, where there are many samples,
/// all of them together tell as much.
Detail quickDetail(std::size_t samples) {
  constexpr std::size_t kMost = 360, kLeast = 180, kOfAll = 6 * kMost;
  return {.most_beams = std::clamp(kOfAll / std::max<std::size_t>(1, samples), kLeast, kMost), .edge_rays = 17};
}

/// The same where `fidelis simulate` made the measurement: then the model's own grid is the truth.
Detail onModelsGrid(Detail detail) {
  detail.edge_rays = 0;
  return detail;
}

/// The model file with a sensor profile in place of a profile's name, so that pointers lead into it, and one for each
/// of several sensors, though one may stand for all, so that each may have causes of its own.
model::LidarModel withInlineSensors(const model::Experiment& experiment, const model::LidarModel& model) {
  nlohmann::json json = model.json;
  model::writeOutSensors(json, model.file);
  if (json.contains("sensor") && !experiment.sensors.empty()) {
    for (const std::string& sensor : experiment.sensors) json["sensors"][sensor] = json["sensor"];
    json.erase("sensor");
  }
  return model::parseModel(json, model.file);
}

/// What is known of the gap before any cause is tried.
Diagnosis withoutCauses(const Judge& judge, const HeldOutGaps& gaps, const WhereResult& where) {
  Diagnosis diagnosis;
  diagnosis.where = where.rows;
  for (const std::size_t s : judge.split.held_out.samples)
    diagnosis.held_out.push_back(judge.replay.samples()[s].sample->id);
  diagnosis.before = gaps.before();
  diagnosis.bias_intervals = gaps.biasIntervals();
  return diagnosis;
}

/// The baseline, if nothing was found.
World winnersWorld(const Replay& replay, const Decision& decision) {
  return decision.winner ? worldOf(replay, decision.winner->hypothesis, decision.winner->values) : replay.baseline();
}

/// The total gap with the winner added, if there is one; where the gap is clear, it must hold on it (decision.h).
After provenOnTotal(const HeldOutGaps& gaps, const Replay& replay, bool clear, Decision& decision,
                    core::Progress& progress) {
  progress.report(0.86, "measuring how far the gap shrinks");
  if (!decision.winner) return {};
  After after = gaps.with(winnersWorld(replay, decision), progress);
  if (clear && !holdsOnTotal(*decision.winner, after.shrink.fraction)) {
    decision.winner.reset();
    decision.kind = VerdictKind::kUnknown;
  }
  return after;
}

/// The same of the model as anybody runs it.
AsRun asRun(const model::Experiment& experiment, const model::LidarModel& model, const Evidence& held_out,
            const Decision& decision, const core::Progress& progress) {
  const Replay replay(experiment, model, kAsRun);
  const HeldOutGaps gaps(replay, held_out.samples, model.seed);
  AsRun as_run{gaps.before().total, std::nullopt, model.rays_horizontal, model.rays_vertical};
  if (!decision.winner) return as_run;
  const After after = gaps.with(winnersWorld(replay, decision), progress);
  as_run.corrected = AsRun::Corrected{after.gap.total, after.shrink};
  return as_run;
}

/// What moves whole frames is no cause's doing: where it is most of the gap, none is named, whatever scatters as much;
/// nor is one that accounts for so little that it was named only because nothing else seemed to be left, or for the
/// mean of what the frames do.
void heedFrames(const Judge& judge, const std::optional<FrameMode>& frames, Decision& decision) {
  if (!decision.winner || !frames) return;
  const bool convincing = judge.accountedFor(*decision.winner) >= kConvincing;
  if (convincing && frames->share_of_gap < kMostOfTheGap &&
      !explainsTheirMean(judge, *frames, winnersWorld(judge.replay, decision)))
    return;
  decision.nameNothing(Contradiction::kFramesMove);
}

/// What is lost in some beams and not in others is lost by no cause that takes from every shot alike.
std::optional<UnevenLoss> heedLosses(const Judge& judge, Decision& decision) {
  if (!decision.winner) return std::nullopt;
  std::optional<UnevenLoss> loss = unevenLossIn(judge, *decision.winner);
  if (loss) decision.nameNothing(Contradiction::kLossesUneven);
  return loss;
}

/// What one stratum shows beyond doubt is a gap, though the noise of all cells hides it and no cause proved itself: it
/// is unknown what makes it. Edges say nothing here: how much of a beam they cut off two programs judge alike for all
/// beams of an edge, each a little wrong.
void heedStrata(const Replay& replay, const WhereResult& where, Decision& decision, Diagnosis& diagnosis) {
  if (decision.kind != VerdictKind::kNone || where.largest_steps < kMaterialSteps) return;
  std::vector<WhereRow> rows = whereRows(replay, offEdges(replay, where.by_beam), where.expected);
  const auto surest = std::min_element(rows.begin(), rows.end(),
                                       [](const WhereRow& a, const WhereRow& b) { return a.p_value < b.p_value; });
  if (surest == rows.end() || surest->p_value > kBeyondDoubt) return;
  decision.nameNothing(Contradiction::kOneStratum);
  diagnosis.p_value = surest->p_value;
  diagnosis.where = std::move(rows);
}

/// What the decision leaves, and where the gap lies in its light; no cause is named that stays clearly below what
/// anything could explain, unless next to nothing of the gap is left by another measure, nor one that plain functions
/// of the beams' azimuth make needless.
void heedLaws(const Judge& judge, const WhereResult& where, std::uint64_t seed, Decision& decision,
              Diagnosis& diagnosis) {
  const Replay& replay = judge.replay;
  if (decision.kind == VerdictKind::kNone) return;
  std::vector<Law> of_direction;
  if (decision.winner) {
    const WhereResult after = whereIn(replay, winnersWorld(replay, decision), seed);
    of_direction = directionLawsIn(judge, *decision.winner, where, after);
    diagnosis.rest = restOf(replay, judge.split, where, after);
    const bool below = diagnosis.rest && staysBelowCeiling(decision, *diagnosis.rest);
    if (of_direction.empty() && !below) {
      diagnosis.where = rowsOfCause(replay, where, after);
      return;
    }
    decision.nameNothing(of_direction.empty() ? Contradiction::kNone : Contradiction::kFollowsDirection);
  }
  diagnosis.rest = restOf(replay, judge.split, where, where);  // without a cause what is left is what was there
  if (diagnosis.rest) diagnosis.rest->putFirst(std::move(of_direction));
}

/// What the winner brings: shrink, intervals of its parameters, a model file if one can hold it.
void fillWinner(const Judge& quick, const Judge& exact, const Decision& decision, const After& after,
                Diagnosis& diagnosis, core::Progress& progress) {
  diagnosis.after = after.gap;
  diagnosis.shrink = after.shrink;
  diagnosis.held_out_totals = after.samples;
  diagnosis.next_experiment = nextExperiment(exact, decision);
  progress.report(0.92, "intervals of the parameters");
  const auto intervals = parameterIntervals(quick.replay, decision.winner->hypothesis, decision.winner->values,
                                            quick.split.refined, progress);
  std::size_t used = 0;
  for (std::size_t c = 0; c < (decision.pair() ? 2U : 1U); ++c) {
    Cause& cause = diagnosis.causes[c];
    cause.shrink = after.shrink;
    for (FittedParameter& parameter : cause.parameters) {
      if (used >= intervals.size()) break;
      parameter.interval = intervals[used++];
    }
  }
  if (diagnosis.approximation) return;  // the model under test has no effects that a file could name
  // Materials and references stand in the experiment; what belongs to the model is proposed even beside them.
  const World world = winnersWorld(quick.replay, decision);
  if (world.model.json != quick.replay.baseline().model.json) {
    diagnosis.proposed_model = world.model.json;
    diagnosis.proposed_model["id"] = world.model.id + "-proposed";
  }
}

/// Maps, curves, and what each cause would be taken for.
void fillPictures(const Judge& quick, const Judge& exact, const WhereResult& where, const Evidence& held_out,
                  const Decision& decision, Diagnosis& diagnosis) {
  const World world = winnersWorld(exact.replay, decision);
  diagnosis.maps = residualMaps(exact.replay, where.tables);
  diagnosis.curves = beforeAfterValues(exact.replay, where.tables, held_out.samples, decision.winner ? &world : nullptr,
                                       held_out.seed);
  diagnosis.confusion =
      confusionOf(quick.replay, worldsOf(quick.replay, decision, diagnosis.causes), exact.split.held_out);
}

}  // namespace

Diagnosis diagnose(const model::Experiment& recorded, const model::LidarModel& given, const DiagnoseOptions& options,
                   core::Progress& watched) {
  const auto start = std::chrono::steady_clock::now();
  core::ForwardProgress progress(watched);
  const std::uint64_t seed = options.seed.value_or(given.seed);
  const model::Experiment experiment = options.without.applied(recorded);
  model::LidarModel model =
      withInlineSensors(experiment, given.external ? proxyOf(experiment, given, options.proxy) : given);
  model.seed = seed;  // under it a foreign model is what it reported
  const std::vector<model::ExternalRun> foreign = model::nominalRuns(experiment, given, seed, progress);
  progress.report(0.0, "tracing the samples");
  std::optional<Replay> finely(std::in_place, experiment, model, kExact, foreign), on_its_grid;
  if (experiment.synthetic() && !given.external) on_its_grid.emplace(experiment, model, onModelsGrid(kExact));
  if (on_its_grid && !madeOnTheModelsGrid(*finely, *on_its_grid)) on_its_grid.reset();
  if (on_its_grid) finely.reset();  // each holds all detections and hundreds of megabytes of hits
  const Replay& replay = on_its_grid ? *on_its_grid : *finely;
  const Detail few = quickDetail(experiment.samples.size());
  std::optional<Replay> few_beams(std::in_place, experiment, model, on_its_grid ? onModelsGrid(few) : few, foreign);
  if (!few_beams->thinned()) few_beams.reset();
  progress.report(0.05, "comparing with the baseline");
  // Whoever decides, the samples that this one holds out say how far the gap shrinks.
  auto [first, p_value] = judgeOf(replay, seed, options.without);
  const WhereResult where = whereIn(replay, replay.baseline(), seed);
  const HeldOutGaps gaps(replay, first.split.held_out.samples, seed);
  first.weight_of_total = kWeightOfTotal * gaps.aboveNoise();

  Diagnosis diagnosis = withoutCauses(first, gaps, where);
  diagnosis.p_value = p_value;
  diagnosis.experiment = experiment.id;
  diagnosis.model = given.id;
  diagnosis.synthetic = experiment.synthetic();
  const bool material = where.largest_steps >= kMaterialSteps || gaps.material();
  const bool clear = diagnosis.p_value < kSignificance && material;
  const Replay& quickly = few_beams ? *few_beams : replay;
  const auto hypotheses = options.without.applied(hypothesesFor(quickly, options.library));
  auto [quick, exact, decision] = ruleOn({quickly, first.split, yardstickOf(quickly, first.split.held_out)}, first,
                                         gaps, clear, where, hypotheses, options.without, progress);
  diagnosis.weak_hold_out = exact.split.weak;
  const auto frames =
      frameModeOf(exact, decision.winner ? std::optional(winnersWorld(exact.replay, decision)) : std::nullopt);
  heedFrames(exact, frames, decision);
  const std::optional<UnevenLoss> uneven_loss = heedLosses(exact, decision);
  diagnosis.background = backgroundOf(replay, exact.split, decision);
  if (options.list_tried) diagnosis.tried = triedOf(quick, decision.singles, decision.pairs, progress);
  const After after = provenOnTotal(gaps, replay, clear, decision, progress);
  const bool proven = decision.kind != VerdictKind::kNone;
  heedStrata(replay, where, decision, diagnosis);
  heedLaws(exact, where, seed, decision, diagnosis);
  if (decision.kind == VerdictKind::kNone)
    decision.singles.clear();  // where nothing is to be explained, nothing has a cause
  if (!clear && proven) diagnosis.p_value = decision.p_value;
  if (given.external)
    diagnosis.approximation =
        approximationOf(replay, exact.split.held_out.samples, seed, decision.kind != VerdictKind::kNone);
  fillCauses(exact, gaps, decision, frames.has_value(), diagnosis, progress);
  if (decision.winner) fillWinner(quick, exact, decision, after, diagnosis, progress);
  if (!given.external) diagnosis.as_run = asRun(experiment, model, first.split.held_out, decision, progress);
  fillVerdict(exact, decision, diagnosis);
  fillPictures(quick, exact, where, first.split.held_out, decision, diagnosis);
  diagnosis.notes = notesOn(replay, strayIn(decision));
  if (const std::string note = asRunSentence(diagnosis); !note.empty()) diagnosis.notes.push_back(note);
  if (const std::string note = atEndSentence(diagnosis); !note.empty()) diagnosis.notes.push_back(note);
  for (const std::string& note : recalibrationSentences(diagnosis, decision.recalibrations))
    diagnosis.notes.push_back(note);
  if (frames) diagnosis.notes.insert(diagnosis.notes.begin(), frameModeSentence(*frames));
  if (uneven_loss) diagnosis.notes.insert(diagnosis.notes.begin(), unevenLossSentence(*uneven_loss));
  if (const std::string note = options.without.note(); !note.empty()) diagnosis.notes.push_back(note);
  diagnosis.verdict.text = verdictSentence(diagnosis);
  diagnosis.elapsed_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  progress.report(1.0, "done");
  return diagnosis;
}

}  // namespace gap
