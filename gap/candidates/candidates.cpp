#include "gap/candidates/candidates.h"

#include <algorithm>

#include "core/parallel.h"

namespace gap {

namespace {

constexpr double kPricePerNumber = 0.004;  // of the explained share, at least
constexpr double kMostLeft = 2.0;  // of the total gap: a cause that doubles it is as wrong as one that triples it

}  // namespace

Split Judge::splitFor(const Hypothesis& hypothesis) const {
  return hypothesis.per_setup ? splitByBeams(replay, split.fitted.seed) : split;
}

void Judge::hear(Candidate& candidate) const {
  const World world = worldOf(replay, candidate.hypothesis, candidate.values);
  const SimulatedWorld simulated(replay, world, split.held_out, Yardstick::kSimulations);
  const double self = simulated.discrepancyTo(measuredIn(replay, world, split.held_out, split.held_out.seed + 2000));
  candidate.discrepancy = simulated.discrepancy();
  candidate.explained = yardstick.explained(candidate.discrepancy, self);
  candidate.merit = meritOf(candidate);
}

double Judge::leftOn(const Evidence& evidence, const Hypothesis& hypothesis, const std::vector<double>& values) const {
  return discrepancyOf(replay, worldOf(replay, hypothesis, values), evidence);
}

double Judge::leftOfFitted(const Hypothesis& hypothesis, const std::vector<double>& values) const {
  return leftOn(split.fitted, hypothesis, values);
}

double Judge::meritOf(const Candidate& candidate) const {
  const double as_it_is = (yardstick.baseline - candidate.discrepancy) / yardstick.whole();
  const double price = std::max(kPricePerNumber, kNatsPerNumber / yardstick.whole());
  return 0.5 * (candidate.explained + as_it_is) - price * static_cast<double>(candidate.hypothesis.parameters.size()) -
         weight_of_total * std::min(kMostLeft, candidate.total_left);
}

double Judge::accountedFor(const Candidate& candidate) const {
  const double of_total = 1.0 - std::clamp(candidate.total_left, 0.0, 1.0);
  return (1.0 - weight_of_total) * std::min(1.0, candidate.explained) + weight_of_total * of_total;
}

void sortByMerit(std::vector<Candidate>& candidates) { std::stable_sort(candidates.begin(), candidates.end(), better); }

const Candidate& nearestToFitted(const Judge& judge, std::span<const Candidate> candidates) {
  std::vector<double> left(candidates.size());
  core::parallelFor(left.size(), 1, [&](std::size_t i, std::size_t) {
    left[i] = judge.leftOfFitted(candidates[i].hypothesis, candidates[i].values);
  });
  return candidates[static_cast<std::size_t>(std::min_element(left.begin(), left.end()) - left.begin())];
}

std::size_t placeOfForm(const std::vector<Candidate>& candidates, const Candidate& other) {
  const auto same = std::find_if(candidates.begin(), candidates.end(), [&](const Candidate& one) {
    return formOf(one.hypothesis) == formOf(other.hypothesis);
  });
  return static_cast<std::size_t>(same - candidates.begin());
}

void takeBetter(std::vector<Candidate> improved, std::vector<Candidate>& candidates) {
  for (Candidate& candidate : improved) {
    Candidate& known = candidates[placeOfForm(candidates, candidate)];
    if (better(candidate, known)) known = std::move(candidate);
  }
  sortByMerit(candidates);
}

std::vector<Candidate> membersOf(const Candidate& candidate) {
  if (candidate.hypothesis.members.empty()) return {candidate};
  std::vector<Candidate> members;
  auto values = candidate.values.begin();
  for (const Hypothesis& hypothesis : candidate.hypothesis.members) {
    const auto end = values + static_cast<std::ptrdiff_t>(hypothesis.parameters.size());
    members.push_back({hypothesis, {values, end}, candidate.explained, candidate.discrepancy});
    values = end;
  }
  return members;
}

}  // namespace gap
