#include "gap/pairs/leading_pairs.h"

#include <algorithm>
#include <utility>

#include "core/parallel.h"
#include "gap/pairs/partners.h"

namespace gap {

bool samePair(const Candidate& a, const Candidate& b) {
  const auto &x = a.hypothesis.members, &y = b.hypothesis.members;
  const auto same = [](const Hypothesis& p, const Hypothesis& q) { return formOf(p) == formOf(q); };
  return (same(x[0], y[0]) && same(x[1], y[1])) || (same(x[0], y[1]) && same(x[1], y[0]));
}

void takePair(Candidate pair, std::vector<Candidate>& pairs) {
  const auto known = std::find_if(pairs.begin(), pairs.end(), [&](const Candidate& p) { return samePair(p, pair); });
  if (known == pairs.end()) {
    pairs.push_back(std::move(pair));
  } else if (better(pair, *known)) {
    *known = std::move(pair);
  }
}

namespace {

/// Of the same pair with two sets of values the one that all beams prefer, at the place in the list that it has. What
/// few beams said of the known one is of another judge.
void takeByAllBeams(const Judge& by_cells, Candidate joined, Candidate& known) {
  Candidate as_fitted = known;
  by_cells.hear(as_fitted);
  if (!better(joined, as_fitted)) return;
  joined.merit = std::max(joined.merit, known.merit);
  known = std::move(joined);
}

}  // namespace

void joinLeaders(const Judge& exact, const std::vector<Candidate>& singles, std::vector<Candidate>& pairs,
                 const core::Progress& progress) {
  Judge by_cells = exact;
  by_cells.weight_of_total = 0.0;  // of none of these pairs the total gap was looked at yet
  std::vector<Candidate> joined;
  for (std::size_t b = 1; b < std::min(kLeaders, singles.size()); ++b)
    for (std::size_t a = 0; a < b; ++a)
      if (pairable(singles[a].hypothesis, singles[b].hypothesis)) joined.push_back(pairOf(singles[a], singles[b]));
  core::parallelFor(joined.size(), 1, [&](std::size_t j, std::size_t) {
    core::stopIfCancelled(progress);
    by_cells.hear(joined[j]);
  });
  for (Candidate& pair : joined) {
    const auto known = std::find_if(pairs.begin(), pairs.end(), [&](const Candidate& p) { return samePair(p, pair); });
    if (known == pairs.end())
      pairs.push_back(std::move(pair));
    else
      takeByAllBeams(by_cells, std::move(pair), *known);
  }
  sortByMerit(pairs);
}

}  // namespace gap
