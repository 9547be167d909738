#include "gap/which/partners.h"

#include <algorithm>

#include "core/parallel.h"

namespace gap {

bool pairable(const Hypothesis& a, const Hypothesis& b) { return !a.per_setup && !b.per_setup && a.name != b.name; }

std::vector<Partner> partnersOf(const Judge& judge, const Candidate& kept, const std::vector<Candidate>& singles,
                                const core::Progress& progress) {
  std::vector<Partner> partners;
  for (std::size_t i = 0; i < singles.size(); ++i)
    if (pairable(kept.hypothesis, singles[i].hypothesis)) partners.push_back({.single = i});
  core::parallelFor(partners.size(), 1, [&](std::size_t p, std::size_t) {
    core::stopIfCancelled(progress);
    const Candidate& single = singles[partners[p].single];
    partners[p].left =
        judge.leftOfFitted(together(kept.hypothesis, single.hypothesis), joined(kept.values, single.values));
  });
  std::stable_sort(partners.begin(), partners.end(),
                   [](const Partner& a, const Partner& b) { return a.left < b.left; });
  return partners;
}

}  // namespace gap
