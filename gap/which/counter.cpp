#include "gap/which/counter.h"

#include <algorithm>
#include <iterator>

#include "gap/candidates/polish.h"
#include "gap/candidates/whole_gap.h"
#include "gap/pairs/partners.h"
#include "gap/pairs/second_cause.h"
#include "gap/pairs/second_search.h"
#include "gap/which/rivals.h"

namespace gap {

namespace {

constexpr std::size_t kPartners = 3;   // of the counter
constexpr double kHarmedCells = 0.08;  // of the discrepancy: a counter that costs more is not there

template <typename Candidates>
auto counterIn(Candidates& candidates) {
  return std::find_if(candidates.begin(), candidates.end(),
                      [](const Candidate& candidate) { return candidate.hypothesis.seen_in_values; });
}

bool leads(const Candidate& counter, const std::vector<Candidate>& singles) {
  return counter.hypothesis.name == singles.front().hypothesis.name;
}

/// With the best causes as they were fitted alone.
std::vector<Candidate> withTheBest(const Judge& exact, const Candidate& counter,
                                   const std::vector<Candidate>& singles) {
  std::vector<Candidate> pairs;
  for (const Candidate& single : singles) {
    if (pairs.size() == kPartners) break;
    if (!pairs.empty() && !pairable(single.hypothesis, counter.hypothesis)) continue;
    pairs.push_back(pairOf(single, counter));
    exact.hear(pairs.back());
  }
  return pairs;
}

}  // namespace

bool showACounter(const std::vector<Candidate>& singles) { return counterIn(singles) != singles.end(); }

std::vector<Candidate> besideTheCounter(const Judge& quick, const Judge& exact, const HeldOutGaps& gaps,
                                        const WhereResult& where, const std::vector<Candidate>& singles,
                                        core::Progress& progress) {
  const Candidate &best = singles.front(), &counter = *counterIn(singles);
  std::vector<Candidate> pairs = pairsBeside(quick, exact, counter, singles, progress);
  if (!leads(counter, singles)) std::ranges::move(withTheBest(exact, counter, singles), std::back_inserter(pairs));
  if (pairs.empty()) return {};
  sortByMerit(pairs);
  polish(exact, gaps, pairs, where, progress);
  leadByPlainest(quick, exact, pairs, addedBySecond(counter, pairs));
  const double alone = std::min(1.0, best.explained), both = std::min(1.0, pairs.front().explained);
  const bool leaves_more = restOfWholeGap(gaps, pairs.front()) > std::max(kMostRestOfPair, restOfWholeGap(gaps, best));
  return both < alone - std::max(kHarmedCells, exact.yardstick.noiseOfShare()) || leaves_more ? std::vector<Candidate>{}
                                                                                              : pairs;
}

bool earnsBesideTheCounter(const Judge& exact, const std::vector<Candidate>& singles, const Candidate& pair) {
  std::vector<Candidate> members = membersOf(pair);
  Candidate& counter = *counterIn(members);
  exact.hear(counter);
  if (leads(counter, singles)) return SecondProofs(exact, singles.front(), singles.size()).of(pair);
  const auto more = static_cast<double>(pair.values.size() - counter.values.size());
  return counter.discrepancy - pair.discrepancy >= Judge::kNatsPerNumber * more;
}

void leadByTheCounter(std::vector<Candidate>& singles) {
  const auto counter = counterIn(singles);
  std::rotate(singles.begin(), counter, counter + 1);
}

}  // namespace gap
