#include "gap/candidates/suggested.h"

#include <utility>

#include "core/parallel.h"
#include "gap/causes/starts.h"

namespace gap {

std::vector<double> nearestStart(const Replay& replay, const Hypothesis& hypothesis, const Evidence& few, double least,
                                 const WhereResult& where, const core::Progress& progress) {
  std::vector<double> nearest;
  for (auto& start : startsFrom(replay, hypothesis, where)) {
    core::stopIfCancelled(progress);
    const double distance = discrepancyOf(replay, worldOf(replay, hypothesis, start), few);
    if (distance >= least) continue;
    least = distance;
    nearest = std::move(start);
  }
  return nearest;
}

std::vector<double> orAsCounted(const Judge& exact, const Hypothesis& hypothesis, std::vector<double> values,
                                const WhereResult& where) {
  auto starts = startsFrom(exact.replay, hypothesis, where);
  if (starts.size() != 1 || starts.front() == values) return values;
  const double known = exact.leftOfFitted(hypothesis, values);
  const bool nearer = exact.leftOfFitted(hypothesis, starts.front()) < known - Judge::kNatsPerNumber;
  return nearer ? std::move(starts.front()) : values;
}

void takeWhatIsCounted(const Judge& exact, const WhereResult& where, std::vector<Candidate>& candidates,
                       const core::Progress& progress) {
  core::parallelFor(candidates.size(), 1, [&](std::size_t c, std::size_t) {
    Candidate& candidate = candidates[c];
    core::stopIfCancelled(progress);
    std::vector<double> counted = orAsCounted(exact, candidate.hypothesis, candidate.values, where);
    if (counted == candidate.values) return;
    candidate.values = std::move(counted);
    exact.hear(candidate);
  });
  sortByMerit(candidates);
}

}  // namespace gap
