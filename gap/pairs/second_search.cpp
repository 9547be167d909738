#include "gap/pairs/second_search.h"

#include <algorithm>
#include <map>
#include <set>
#include <string>

#include "core/parallel.h"
#include "gap/candidates/ranking.h"
#include "gap/pairs/partners.h"

namespace gap {

namespace {

constexpr std::size_t kMost = 4;  // are fitted jointly after that

/// The causes that may stand beside `known`, each where that one is at work; and which of `singles` they are.
std::pair<std::vector<Hypothesis>, std::map<Form, std::size_t>> besideThat(const Candidate& known,
                                                                           const std::vector<Candidate>& singles) {
  std::vector<Hypothesis> hypotheses;
  std::map<Form, std::size_t> places;
  for (std::size_t i = 0; i < singles.size(); ++i) {
    const Hypothesis& hypothesis = singles[i].hypothesis;
    if (!worthPairing(singles, i) || !pairable(known.hypothesis, hypothesis)) continue;
    hypotheses.push_back(beside(known.hypothesis, known.values, hypothesis));
    places[formOf(hypothesis)] = i;
  }
  return {std::move(hypotheses), std::move(places)};
}

}  // namespace

std::vector<Found> searchedBeside(const Judge& judge, const Candidate& known, const std::vector<Candidate>& singles,
                                  core::Progress& progress) {
  const auto [hypotheses, places] = besideThat(known, singles);
  if (hypotheses.empty()) return {};
  const World world = worldOf(judge.replay, known.hypothesis, known.values);
  const WhereResult where = whereIn(judge.replay, world, judge.split.fitted.seed);
  const std::vector<Candidate> candidates = fitted(judge, hypotheses, where, progress, &world);

  std::vector<std::pair<double, std::size_t>> order(candidates.size());
  core::parallelFor(candidates.size(), 1, [&](std::size_t i, std::size_t) {
    core::stopIfCancelled(progress);
    const Candidate& candidate = candidates[i];
    const double price = Judge::kNatsPerNumber * static_cast<double>(candidate.values.size());
    order[i] = {judge.leftOfFitted(candidate.hypothesis, candidate.values) + price, i};
  });
  std::sort(order.begin(), order.end());
  const double nothing = judge.leftOfFitted(known.hypothesis, known.values);
  std::vector<Found> found;
  std::set<std::string> names;
  for (const auto& [left, i] : order) {
    if (left >= nothing || found.size() == kMost) break;
    if (names.insert(candidates[i].hypothesis.name).second)
      found.push_back({places.at(formOf(candidates[i].hypothesis)), candidates[i].values});
  }
  return found;
}

std::vector<Candidate> pairsBeside(const Judge& quick, const Judge& exact, const Candidate& known,
                                   const std::vector<Candidate>& singles, core::Progress& progress) {
  Candidate alone = known;
  exact.hear(alone);
  std::vector<Candidate> pairs;
  for (const Found& found : searchedBeside(quick, known, singles, progress)) {
    Candidate second = singles[found.single];
    second.values = found.values;
    Candidate pair = pairOf(known, second);
    exact.hear(pair);
    const double price = Judge::kNatsPerNumber * static_cast<double>(second.values.size());
    if (pair.discrepancy + price < alone.discrepancy) pairs.push_back(std::move(pair));
  }
  sortByMerit(pairs);
  return pairs;
}

}  // namespace gap
