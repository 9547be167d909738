#include "gap/which/ruling.h"

#include <algorithm>
#include <utility>

#include "gap/which/significance.h"

namespace gap {

namespace {

constexpr double kMuchClearer = 3.0;  // so much more must one part of the samples show than the other

/// Whether a deviation, in standard deviations, is beyond doubt in one part of the samples, and far from it in the
/// other.
bool inOnePartOnly(double held_out_z, double fitted_z) {
  const double least = std::min(held_out_z, fitted_z), most = std::max(held_out_z, fitted_z);
  return most >= Yardstick::kClear_z && least < std::min(Yardstick::kClear_z, most / kMuchClearer);
}

Judge judgeByBeams(const Replay& replay, std::uint64_t seed, const Ablation& without) {
  const Split by_beams = without.applied(splitByBeams(replay, seed));
  return {replay, by_beams, yardstickOf(replay, by_beams.held_out)};
}

Judge withoutEdges(Judge judge) {
  judge.split.held_out.part.edges = false;
  judge.yardstick = yardstickOf(judge.replay, judge.split.held_out);
  return judge;
}

bool holdsDetections(const Replay& replay, const Evidence& evidence) {
  return std::any_of(evidence.samples.begin(), evidence.samples.end(),
                     [&](std::size_t s) { return replay.samples()[s].measured.size() > 0; });
}

/// What brings the fitted samples nearest: a recalibration that hides a cause does, wherever the cause acts.
const Candidate& nearestToFitted(const Judge& quick, const std::vector<Candidate>& singles) {
  std::vector<double> left;
  for (const Candidate& single : singles) left.push_back(quick.leftOfFitted(single.hypothesis, single.values));
  return singles[static_cast<std::size_t>(std::min_element(left.begin(), left.end()) - left.begin())];
}

bool leavesOnePartOnly(const Judge& quick, const Judge& judge, const Decision& decision) {
  if (judge.split.weak || decision.singles.empty() || decision.pair()) return false;
  if (!holdsDetections(judge.replay, judge.split.held_out)) return false;  // lost files are no second cause
  Judge on_fitted = judge;
  on_fitted.split.held_out = judge.split.refined;
  const auto leavesOnePart = [&](const Candidate& cause) {
    return inOnePartOnly(restOf(judge, cause), restOf(on_fitted, cause));
  };
  return leavesOnePart(decision.singles.front()) ||
         (!decision.winner && leavesOnePart(nearestToFitted(quick, decision.singles)));
}

}  // namespace

Judge judgeOf(const Replay& replay, std::uint64_t seed, const Ablation& without) {
  const Split by_samples = without.applied(splitOf(replay, seed));
  const Yardstick yardstick = yardstickOf(replay, by_samples.held_out);
  if (inOnePartOnly(yardstick.z(), yardstickOf(replay, by_samples.fitted).z()))
    return judgeByBeams(replay, seed, without);
  return {replay, by_samples, yardstick};
}

Ruling ruleOn(const Judge& quick, const Judge& exact, const HeldOutGaps& gaps, bool clear, const WhereResult& where,
              const std::vector<Hypothesis>& hypotheses, const Ablation& without, core::Progress& progress) {
  if (!clear) {
    return {quick, exact, decide(withoutEdges(quick), withoutEdges(exact), gaps, clear, where, hypotheses, progress)};
  }
  Decision decision = decide(quick, exact, gaps, clear, where, hypotheses, progress);
  if (!leavesOnePartOnly(quick, exact, decision)) return {quick, exact, std::move(decision)};
  progress.report(0.1, "judging by beams: what is left shows in some of the samples only");
  Judge by_beams = judgeByBeams(exact.replay, exact.split.fitted.seed, without);
  by_beams.weight_of_total = exact.weight_of_total;
  const Judge quick_by_beams{quick.replay, by_beams.split, yardstickOf(quick.replay, by_beams.split.held_out)};
  Decision other = decide(quick_by_beams, by_beams, gaps, clear, where, hypotheses, progress);
  if (!other.winner) return {quick, exact, std::move(decision)};
  return {quick_by_beams, by_beams, std::move(other)};
}

}  // namespace gap
