#include "gap/pairs/partners.h"

#include <algorithm>

#include "core/parallel.h"

namespace gap {

bool pairable(const Hypothesis& known, const Hypothesis& added) {
  constexpr std::size_t kMostNumbers = 4;
  return !known.per_setup && !added.per_setup && known.name != added.name && added.parameters.size() <= kMostNumbers;
}

bool worthPairing(const std::vector<Candidate>& singles, std::size_t single) {
  constexpr std::size_t kBestAlone = 16;
  return singles[single].hypothesis.sensors.empty() || single < kBestAlone;
}

Candidate pairOf(const Candidate& a, const Candidate& b) {
  return {.hypothesis = together(a.hypothesis, b.hypothesis), .values = joined(a.values, b.values)};
}

std::vector<Partner> partnersOf(const Judge& judge, const Candidate& kept, const std::vector<Candidate>& singles,
                                const core::Progress& progress) {
  std::vector<Partner> partners;
  for (std::size_t i = 0; i < singles.size(); ++i)
    if (pairable(kept.hypothesis, singles[i].hypothesis)) partners.push_back({.single = i});
  core::parallelFor(partners.size(), 1, [&](std::size_t p, std::size_t) {
    core::stopIfCancelled(progress);
    const Candidate pair = pairOf(kept, singles[partners[p].single]);
    partners[p].left = judge.leftOfFitted(pair.hypothesis, pair.values);
  });
  std::stable_sort(partners.begin(), partners.end(),
                   [](const Partner& a, const Partner& b) { return a.left < b.left; });
  return partners;
}

}  // namespace gap
