#include "gap/which/ruling.h"

#include <algorithm>
#include <utility>

#include "gap/candidates/significance.h"
#include "gap/candidates/whole_gap.h"

namespace gap {

namespace {

constexpr double kMuchClearer = 3.0;      // so much more must one part of the samples show than the other
constexpr double kFarClearer = 10.0;      // the same where nothing was named: to look again costs time alone
constexpr double kPresent_z = 4.1;        // of one of two parts: a gap has p < 0.001 (twice that of Student's t of 20)
constexpr double kHardlyByChance = 0.01;  // of a gap that is not beyond doubt: a second search is worth its time

/// Deviations of the two parts of the samples, in standard deviations.
struct PartDeviations {
  double held_out_z, fitted_z;

  /// Whether one part shows it, if so many standard deviations do, and the other is far from that.
  [[nodiscard]] bool inOnePartOnly(double shown_z = Yardstick::kClear_z) const {
    return most() >= shown_z && least() < std::min(shown_z, most() / kMuchClearer);
  }
  /// Whether it is so much larger in one part that what acts in the other is hardly what makes it.
  [[nodiscard]] bool mostlyInOnePart() const { return most() >= Yardstick::kClear_z && least() < most() / kFarClearer; }
  /// Whether it is much larger in the fitted part than another.
  [[nodiscard]] bool farMoreOfFittedThan(const PartDeviations& other) const {
    return other.fitted_z < fitted_z / kMuchClearer;
  }

 private:
  [[nodiscard]] double least() const { return std::min(held_out_z, fitted_z); }
  [[nodiscard]] double most() const { return std::max(held_out_z, fitted_z); }
};

Judge judgeByBeams(const Replay& replay, std::uint64_t seed, const Ablation& without) {
  const Split by_beams = without.applied(splitByBeams(replay, seed));
  return {replay, by_beams, yardstickOf(replay, by_beams.held_out)};
}

Judge withoutEdges(Judge judge) {
  judge.split.held_out.part.edges = false;
  judge.yardstick = yardstickOf(judge.replay, judge.split.held_out);
  return judge;
}

/// What the baseline deviates.
PartDeviations gapOf(const Judge& judge) {
  return {judge.yardstick.z(), yardstickOf(judge.replay, judge.split.fitted).z()};
}

bool holdsDetections(const Replay& replay, const Evidence& evidence) {
  return std::any_of(evidence.samples.begin(), evidence.samples.end(),
                     [&](std::size_t s) { return replay.samples()[s].measured.size() > 0; });
}

/// Whether beams may know more than samples did; lost files are no second cause.
bool mayAskBeams(const Judge& judge, const Decision& decision) {
  return !judge.split.weak && !decision.singles.empty() && holdsDetections(judge.replay, judge.split.held_out);
}

bool leavesOnePartOnly(const Judge& quick, const Judge& judge, const Decision& decision) {
  if (!mayAskBeams(judge, decision)) return false;
  Judge on_fitted = judge;
  on_fitted.split.held_out = judge.split.refined;
  const auto leftBy = [&](const Candidate& cause) {
    return PartDeviations{deviationsLeft(judge, cause), deviationsLeft(on_fitted, cause)};
  };
  const PartDeviations left = leftBy(decision.winner ? *decision.winner : decision.singles.front());
  if (!decision.pair() && left.inOnePartOnly()) return true;
  // What brings the fitted samples nearest may be a recalibration that hides a cause, wherever the cause acts.
  const auto nearest = [&](const std::vector<Candidate>& candidates) {
    return leftBy(nearestToFitted(quick, candidates));
  };
  if (!decision.winner) return left.mostlyInOnePart() || nearest(decision.singles).inOnePartOnly();
  // What acts where hardly anything is held out shows in the fitted samples alone: another cause is far nearer there.
  if (left.fitted_z < Yardstick::kClear_z) return false;
  return left.farMoreOfFittedThan(nearest(decision.singles)) ||
         (!decision.pairs.empty() && left.farMoreOfFittedThan(nearest(decision.pairs)));
}

/// Whether nothing is named though the gap itself is mostly in one part: what is little of it may be how programs
/// differ.
bool gapIsInOnePart(const Judge& judge, const Decision& decision) {
  return mayAskBeams(judge, decision) && !decision.winner && gapOf(judge).mostlyInOnePart();
}

/// Whether held-out samples differ by more than chance though no cause was found that makes them: what acts there alone
/// could not be fitted.
bool mayHideInHeldOut(const Judge& judge, const Decision& decision) {
  return !judge.split.weak && decision.kind == VerdictKind::kNone && judge.yardstick.p_value() < kHardlyByChance;
}

}  // namespace

FirstLook judgeOf(const Replay& replay, std::uint64_t seed, const Ablation& without) {
  constexpr double kParts = 2.0;
  const Split by_samples = without.applied(splitOf(replay, seed));
  const Judge judge{replay, by_samples, yardstickOf(replay, by_samples.held_out)};
  const Yardstick of_fitted = yardstickOf(replay, by_samples.fitted);
  const double by_chance = judge.yardstick.p_value();
  if (!PartDeviations{judge.yardstick.z(), of_fitted.z()}.inOnePartOnly(kPresent_z)) return {judge, by_chance};
  const Judge by_beams = judgeByBeams(replay, seed, without);
  return {by_beams, std::min(by_beams.yardstick.p_value(), kParts * std::min(by_chance, of_fitted.p_value()))};
}

Ruling ruleOn(const Judge& quick, const Judge& exact, const HeldOutGaps& gaps, bool clear, const WhereResult& where,
              const std::vector<Hypothesis>& hypotheses, const Ablation& without, core::Progress& progress) {
  const auto decided = [&](const Judge& few_beams, const Judge& judge) {
    return clear ? decide(few_beams, judge, gaps, clear, where, hypotheses, progress)
                 : decide(withoutEdges(few_beams), withoutEdges(judge), gaps, clear, where, hypotheses, progress);
  };
  Ruling by_samples{quick, exact, decided(quick, exact)};
  const bool open =
      clear ? leavesOnePartOnly(quick, exact, by_samples.decision) : mayHideInHeldOut(exact, by_samples.decision);
  const bool doubtful = clear && !open && gapIsInOnePart(exact, by_samples.decision);
  if (!open && !doubtful) return by_samples;
  progress.report(0.1, "judging by beams: what is left shows in some of the samples only");
  Judge by_beams = judgeByBeams(exact.replay, exact.split.fitted.seed, without);
  by_beams.weight_of_total = exact.weight_of_total;
  const Judge quick_by_beams{quick.replay, by_beams.split, yardstickOf(quick.replay, by_beams.split.held_out)};
  Decision other = decided(quick_by_beams, by_beams);
  if (!other.winner || (doubtful && other.winner->explained < kNearlyAllCells)) return by_samples;
  return {quick_by_beams, by_beams, std::move(other)};
}

}  // namespace gap
