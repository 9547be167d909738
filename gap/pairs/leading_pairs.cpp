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

namespace {

using Pairs = std::vector<Candidate>;

Pairs::iterator knownAmong(Pairs& pairs, const Candidate& pair) {
  return std::find_if(pairs.begin(), pairs.end(), [&](const Candidate& known) { return samePair(known, pair); });
}

}  // namespace

void takePair(Candidate pair, Pairs& pairs) {
  const auto known = knownAmong(pairs, pair);
  if (known == pairs.end()) {
    pairs.push_back(std::move(pair));
  } else if (better(pair, *known)) {
    *known = std::move(pair);
  }
}

namespace {

/// Of the same pair with two sets of values the one that a judge prefers; with the better merit of both, for that of
/// the known one may be of another judge. The joined one was heard.
Candidate preferred(const Judge& judge, Candidate joined, const Candidate& known) {
  Candidate heard = known;
  judge.hear(heard);
  if (!better(joined, heard)) return known;
  joined.merit = std::max(joined.merit, known.merit);
  return joined;
}

}  // namespace

void joinLeaders(const Judge& exact, const std::vector<Candidate>& singles, Pairs& pairs,
                 const core::Progress& progress) {
  Judge by_cells = exact;
  by_cells.weight_of_total = 0.0;  // of none of these pairs the total gap was looked at yet
  Pairs joined;
  for (std::size_t b = 1; b < std::min(kLeaders, singles.size()); ++b)
    for (std::size_t a = 0; a < b; ++a)
      if (pairable(singles[a].hypothesis, singles[b].hypothesis)) joined.push_back(pairOf(singles[a], singles[b]));
  core::parallelFor(joined.size(), 1, [&](std::size_t j, std::size_t) {
    core::stopIfCancelled(progress);
    by_cells.hear(joined[j]);
    const auto known = knownAmong(pairs, joined[j]);
    if (known != pairs.end()) joined[j] = preferred(by_cells, std::move(joined[j]), *known);
  });
  for (Candidate& pair : joined) {
    const auto known = knownAmong(pairs, pair);
    if (known == pairs.end())
      pairs.push_back(std::move(pair));
    else
      *known = std::move(pair);
  }
  sortByMerit(pairs);
}

}  // namespace gap
