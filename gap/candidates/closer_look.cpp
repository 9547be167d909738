#include "gap/candidates/closer_look.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/parallel.h"
#include "gap/candidates/polish.h"
#include "gap/candidates/ranking.h"
#include "gap/candidates/significance.h"
#include "gap/far/how_far.h"

namespace gap {

namespace {

constexpr double kLittle = 0.5;          // of the gap
constexpr double kDeviates = 3.0;        // standard errors, of a beam
constexpr std::size_t kJudgedByAll = 8;  // of the causes that come nearest on these beams
constexpr double kFarLess = 3.0;         // times less than so few beams show of what is in all of them

/// Of every sample, by how many standard errors each beam deviates most.
std::vector<std::vector<double>> deviations(const Replay& replay, const WhereResult& where) {
  std::vector<std::vector<double>> deviations;
  for (const ReplaySample& sample : replay.samples()) deviations.emplace_back(sample.beams.size(), 0.0);
  for (const ResidualTable& table : where.tables) {
    for (const ResidualTable::Row& row : table.rows) {
      const ReplaySample& sample = replay.samples()[row.sample];
      if (sample.layout->pooled() || row.error <= 0.0) continue;
      double& most = deviations[row.sample][sample.layout->cells()[row.cell].beam];
      most = std::max(most, std::abs(row.value) / row.error);
    }
  }
  return deviations;
}

/// The beams that deviate most, and others all over the scan (what is right there must stay right), half of them each.
/// Ascending.
std::vector<std::uint32_t> chosenBy(const std::vector<double>& deviations, std::size_t most) {
  std::vector<std::uint32_t> order(deviations.size());
  for (std::uint32_t b = 0; b < order.size(); ++b) order[b] = b;
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return deviations[a] > deviations[b]; });
  const auto calm = std::find_if(order.begin(), order.end(), [&](auto b) { return deviations[b] < kDeviates; });
  const std::size_t half = std::max<std::size_t>(1, most / 2);
  const auto deviating = std::min<std::size_t>(half, static_cast<std::size_t>(calm - order.begin()));
  std::vector<std::uint32_t> others(order.begin() + static_cast<std::ptrdiff_t>(deviating), order.end());
  std::sort(others.begin(), others.end());
  order.resize(deviating);
  const std::size_t stride = std::max<std::size_t>(1, others.size() / half);
  for (std::size_t i = 0; i < others.size(); i += stride) order.push_back(others[i]);
  std::sort(order.begin(), order.end());
  return order;
}

std::vector<std::vector<std::uint32_t>> beamsThatDeviate(const Replay& replay, const WhereResult& where,
                                                         std::size_t most) {
  std::vector<std::vector<std::uint32_t>> beams;
  for (const std::vector<double>& of_sample : deviations(replay, where)) beams.push_back(chosenBy(of_sample, most));
  return beams;
}

double beamsOf(const Replay& replay) {
  std::size_t beams = 0;
  for (const ReplaySample& sample : replay.samples()) beams += sample.beams.size();
  return static_cast<double>(beams);
}

/// What explains most on these beams, if all of them say that it is nearer to what is fitted than its values before.
std::vector<Candidate> nearerThanBefore(const Judge& exact, const std::vector<Candidate>& singles,
                                        std::vector<Candidate> closer, const core::Progress& progress) {
  if (closer.size() > kJudgedByAll) closer.resize(kJudgedByAll);
  std::vector<char> nearer(closer.size(), 0);
  core::parallelFor(closer.size(), 1, [&](std::size_t c, std::size_t) {
    core::stopIfCancelled(progress);
    const Hypothesis& hypothesis = closer[c].hypothesis;
    const double known = exact.leftOfFitted(hypothesis, singles[placeOfForm(singles, closer[c])].values);
    nearer[c] = exact.leftOfFitted(hypothesis, closer[c].values) < known - Judge::kNatsPerNumber ? 1 : 0;
  });
  std::vector<Candidate> kept;
  for (std::size_t c = 0; c < closer.size(); ++c)
    if (nearer[c] != 0) kept.push_back(std::move(closer[c]));
  return kept;
}

}  // namespace

CloseJudge::CloseJudge(const Judge& quick, const Judge& exact, const WhereResult& deviating)
    : replay(exact.replay.only(beamsThatDeviate(exact.replay, deviating, quick.replay.detail().most_beams),
                               quick.replay.detail())),
      judge{replay, quick.split, yardstickOf(replay, quick.split.held_out)} {}

std::unique_ptr<const CloseJudge> closeJudgeBeside(const Judge& quick, const Judge& exact, const Candidate& best,
                                                   double left_by_best) {
  if (&quick.replay == &exact.replay || left_by_best < Yardstick::kClear_z) return nullptr;
  // What is in all beams alike is as many standard deviations as the root of their number.
  const double spread_over_all = left_by_best * std::sqrt(beamsOf(quick.replay) / beamsOf(exact.replay));
  if (deviationsLeft(quick, best) > spread_over_all / kFarLess) return nullptr;
  const World world = worldOf(exact.replay, best.hypothesis, best.values);
  return std::make_unique<const CloseJudge>(quick, exact, whereIn(exact.replay, world, exact.split.fitted.seed));
}

void lookCloser(const Judge& quick, const Judge& exact, const HeldOutGaps& gaps, const WhereResult& where,
                std::vector<Candidate>& singles, core::Progress& progress) {
  const bool all_took_part = &quick.replay == &exact.replay;
  if (all_took_part || singles.empty() || singles.front().explained >= kLittle) return;
  const CloseJudge closely(quick, exact, where);
  std::vector<Hypothesis> hypotheses;
  for (const Candidate& single : singles) hypotheses.push_back(single.hypothesis);
  std::vector<Candidate> nearer =
      nearerThanBefore(exact, singles, rank(closely.judge, hypotheses, where, progress), progress);
  polish(exact, gaps, nearer, where, progress);
  takeBetter(std::move(nearer), singles);
}

}  // namespace gap
