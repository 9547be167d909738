#include "gap/pairs/exchanges.h"

#include <algorithm>
#include <limits>
#include <map>
#include <string>
#include <utility>

#include "core/parallel.h"
#include "gap/candidates/whole_gap.h"
#include "gap/candidates/world_to_make.h"
#include "gap/causes/starts.h"
#include "gap/pairs/leading_pairs.h"
#include "gap/pairs/partners.h"
#include "gap/pairs/same_sector.h"

namespace gap {

namespace {

constexpr std::size_t kOfEachMember = 5;
constexpr std::size_t kBestAlone = 4;    // as fitted alone, each may be far off beside another: all are fitted there
constexpr double kSameWay = 0.5;         // of how far a member leads: what comes nearer to it does much the same
constexpr double kTooFarBehind = 0.3;    // of what the exchanged member brings to the fitted samples
constexpr std::size_t kFittedWell = 12;  // of all that were fitted roughly

/// The single causes, and those that act in a sector where the best pair says that it is.
std::vector<Candidate> alsoInTheirSectors(const std::vector<Candidate>& members,
                                          const std::vector<Candidate>& singles) {
  std::vector<Candidate> known = singles;
  for (const Candidate& member : members) {
    for (Candidate& moved : inSectorOf(member, singles)) known.push_back(std::move(moved));
  }
  return known;
}

/// What the residuals beside a cause suggest one place of (the rate of rare echoes is counted), there.
std::vector<Candidate> asCountedBeside(const Judge& exact, const Candidate& kept,
                                       const std::vector<Candidate>& singles) {
  const World world = worldOf(exact.replay, kept.hypothesis, kept.values);
  const WhereResult where = whereIn(exact.replay, world, exact.split.fitted.seed);
  std::vector<Candidate> counted;
  for (const Candidate& single : singles) {
    if (!pairable(kept.hypothesis, single.hypothesis)) continue;
    auto starts = startsFrom(exact.replay, single.hypothesis, where);
    if (starts.size() != 1) continue;
    counted.push_back(single);
    counted.back().values = std::move(starts.front());
  }
  return counted;
}

/// A pair with a member exchanged, and what it may leave of the fitted samples to be fitted to the end.
struct Exchanged {
  Candidate pair;
  double most_left;
  bool best_alone = false;  ///< the cause that came in is one of the best alone
};

/// Causes of other names that, as they were fitted alone, come nearest beside the one that is kept, and those that are
/// best alone. Of each name the nearest form, and the usual one: fitted alone, a form with more numbers may come nearer
/// and have nothing to say here.
std::vector<Exchanged> nearestBeside(const Judge& quick, const Candidate& kept, const Candidate& member,
                                     const std::vector<Candidate>& singles, double most_left,
                                     const core::Progress& progress) {
  std::vector<Exchanged> nearest;
  std::map<std::string, bool> has_usual;  // by name
  for (const Partner& partner : partnersOf(quick, kept, singles, progress)) {
    const Candidate& single = singles[partner.single];
    const std::string& name = single.hypothesis.name;
    const bool usual = single.hypothesis.variant.empty();
    const auto known = has_usual.find(name);
    const bool best_alone = usual && partner.single < kBestAlone;
    const bool new_name = known == has_usual.end();
    const bool wanted = new_name ? best_alone || has_usual.size() < kOfEachMember : usual && !known->second;
    if (!wanted || name == member.hypothesis.name) continue;
    nearest.push_back({pairOf(kept, single), most_left, best_alone});
    has_usual[name] = usual;
  }
  return nearest;
}

/// The parameters that do beside an effect what the exchanged member does, at the values that do it: one that a
/// calibration gave a value that hides the effect is, fitted alone, what it was calibrated to.
std::vector<Exchanged> parametersInPlaceOf(const Judge& quick, const Candidate& member, const Candidate& kept,
                                           const std::vector<Candidate>& singles, double most_left,
                                           const core::Progress& progress) {
  if (kept.hypothesis.kind != CauseKind::kEffect) return {};
  const Candidate pair = pairOf(kept, member);
  const WorldToMake world(quick, worldOf(quick.replay, pair.hypothesis, pair.values));
  const double alone = world.distanceOf(worldOf(quick.replay, kept.hypothesis, kept.values));
  std::vector<Candidate> parameters;
  for (const Candidate& single : singles) {
    const bool other = single.hypothesis.name != member.hypothesis.name;
    if (other && single.hypothesis.kind == CauseKind::kParameter && pairable(kept.hypothesis, single.hypothesis))
      parameters.push_back(pairOf(kept, single));
  }
  std::vector<char> alike(parameters.size());
  core::parallelFor(parameters.size(), 1, [&](std::size_t p, std::size_t) {
    core::stopIfCancelled(progress);
    Candidate& both = parameters[p];
    const auto worldAt = [&](double value) {
      std::vector<double> values = both.values;
      values.back() = value;
      return worldOf(quick.replay, both.hypothesis, values);
    };
    if (quick.replay.movesRays(worldAt(both.values.back()))) return;  // every value is traced anew
    const auto nearest = world.nearestOf(both.hypothesis.parameters.back(), both.values.back(), worldAt);
    both.values.back() = nearest.value;
    alike[p] = nearest.distance < kSameWay * alone;
  });
  std::vector<Exchanged> exchanged;
  for (std::size_t p = 0; p < parameters.size(); ++p)
    if (alike[p]) exchanged.push_back({std::move(parameters[p]), most_left});
  return exchanged;
}

/// Those that come nearest once they were fitted roughly, unless they are so far behind the known pair that no fit to
/// the end helps, which takes as long as that of the known pair.
std::vector<Candidate> nearestRoughly(const Judge& quick, std::vector<Exchanged> others,
                                      const core::Progress& progress) {
  std::vector<std::pair<double, std::size_t>> order(others.size());
  core::parallelFor(others.size(), 1, [&](std::size_t i, std::size_t) {
    Candidate& other = others[i].pair;
    double least = quick.leftOfFitted(other.hypothesis, other.values);
    const auto fitBy = [&](const auto& fit) {
      auto values = fit(quick.replay, other.hypothesis, quick.split.fitted, other.values, progress);
      const double left = quick.leftOfFitted(other.hypothesis, values);
      if (left >= least) return;  // few shots of few samples hardly know a rare echo
      other.values = std::move(values);
      least = left;
    };
    fitBy(roughFitFrom);
    if (others[i].best_alone && least > others[i].most_left) fitBy(fitFrom);
    order[i] = {least, i};
  });
  std::erase_if(order, [&](const auto& one) { return one.first > others[one.second].most_left; });
  std::sort(order.begin(), order.end());
  std::vector<Candidate> nearest;
  for (std::size_t i = 0; i < std::min(kFittedWell, order.size()); ++i)
    nearest.push_back(std::move(others[order[i].second].pair));
  return nearest;
}

}  // namespace

void exchangeMembersOf(const Candidate& pair, const Judge& quick, const Judge& exact, const HeldOutGaps& gaps,
                       const std::vector<Candidate>& singles, std::vector<Candidate>& pairs,
                       const core::Progress& progress) {
  const std::vector<Candidate> members = membersOf(pair);
  const std::vector<Candidate> known = alsoInTheirSectors(members, singles);
  const double of_pair = quick.leftOfFitted(pair.hypothesis, pair.values);
  std::vector<Exchanged> exchanged;
  for (const std::size_t kept : {0U, 1U}) {
    const double alone = quick.leftOfFitted(members[kept].hypothesis, members[kept].values);
    const double most_left = of_pair + kTooFarBehind * std::max(0.0, alone - of_pair);
    for (Exchanged& other : nearestBeside(quick, members[kept], members[1 - kept], known, most_left, progress))
      exchanged.push_back(std::move(other));
    for (Exchanged& other : parametersInPlaceOf(quick, members[1 - kept], members[kept], singles, most_left, progress))
      exchanged.push_back(std::move(other));
    for (const Candidate& counted : asCountedBeside(exact, members[kept], singles))
      exchanged.push_back({pairOf(members[kept], counted), std::numeric_limits<double>::infinity()});
  }
  std::vector<Candidate> others = nearestRoughly(quick, std::move(exchanged), progress);
  const auto refineBy = [&](const auto& search, double least_merit) {
    core::parallelFor(others.size(), 1, [&](std::size_t i, std::size_t) {
      Candidate& other = others[i];
      if (other.merit < least_merit) return;
      other.values = search(exact.replay, other.hypothesis, exact.split.refined, other.values, progress);
      hearOnTotal(exact, gaps, other);
    });
  };
  refineBy(refineBriefly, -std::numeric_limits<double>::infinity());
  double best = pairs.front().merit;
  for (const Candidate& other : others) best = std::max(best, other.merit);
  refineBy(refineAlongValley, best - kMayLead);
  for (Candidate& other : others) takePair(std::move(other), pairs);
  sortByMerit(pairs);
}

}  // namespace gap
