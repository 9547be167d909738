#include "gap/which/rivals.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "gap/candidates/separation.h"
#include "model/effects/effect.h"

namespace gap {

namespace {

constexpr double kApart = 1.5;     // standard deviations of the paired difference of two causes
constexpr double kDisputed = 1.0;  // the same, at most, of what the held-out samples prefer
constexpr double kTie = 0.03;      // of what there is to explain: causes this close cannot be told apart
constexpr std::size_t kRivals = 5;
constexpr std::size_t kPairsLookedAt = 5;  // beside the best: the others were not fitted as well

/// In how many forms this cause may be at work.
std::size_t formsOf(const Hypothesis& hypothesis) {
  const model::EffectEntry* effect = model::findEffect(hypothesis.name);
  return effect ? 1 + effect->info.other_forms.size() : 2;
}

/// Free numbers that are not where the cause is absent (an effect may have several mechanisms, of which one is at work,
/// however little: a delay of milliseconds, of those that may be a second). One at least, if it has any, and the ends
/// of its sector, which are places.
double numbersSaid(const Candidate& cause) {
  constexpr double kNothing = 0.01;  // of the range
  double places = 0.0, at_work = 0.0;
  for (std::size_t i = 0; i < cause.values.size(); ++i) {
    const FreeParameter& p = cause.hypothesis.parameters[i];
    const bool absent = std::abs(cause.values[i] - p.absent_at) <= kNothing * (p.high - p.low) && !p.logarithmic;
    places += p.azimuth ? 1.0 : 0.0;
    at_work += p.azimuth || absent ? 0.0 : 1.0;
  }
  const bool only_places = places == static_cast<double>(cause.values.size());
  return places + (only_places ? 0.0 : std::max(1.0, at_work));
}

/// In how many ways so many can be chosen, as a logarithm.
double logChoices(double of, double chosen) {
  return std::lgamma(of + 1.0) - std::lgamma(chosen + 1.0) - std::lgamma(of - chosen + 1.0);
}

/// What a cause takes to say what it says, in nats: its numbers, which of them are at work, the choice of a form other
/// than its usual one among all of them, and how rarely it looks as it does here; of a pair that of each member.
double priceOf(const Candidate& candidate) {
  double price = 0.0;
  for (const Candidate& member : membersOf(candidate)) {
    const double said = numbersSaid(member);
    price += Judge::kNatsPerNumber * said + logChoices(static_cast<double>(member.values.size()), said);
    if (!member.hypothesis.variant.empty()) price += std::log(static_cast<double>(formsOf(member.hypothesis)));
    price += member.hypothesis.improbable_nats;
  }
  return price;
}

/// What it costs one cause to say more than another, in nats.
double costOf(const Candidate& candidate, const Candidate& beside) {
  return std::max(0.0, priceOf(candidate) - priceOf(beside));
}

/// How well a candidate is told from the best one, with what it takes more to say it.
double toldApart(const Judge& quick, const Judge& exact, const Candidate& best, const Candidate& other, double alike) {
  return toldFromOnAll(quick, exact, best, other, alike, costOf(other, best));
}

/// Whether a candidate accounts for as much of the gap as the best one, cell by cell and pooled.
bool asMuch(const Judge& exact, const Candidate& other, const Candidate& best) {
  return exact.accountedFor(other) >= exact.accountedFor(best) - kTie;
}

/// Those of other names, of each name the first one.
std::vector<const Candidate*> othersThan(const Candidate& best, const std::vector<Candidate>& candidates) {
  std::vector<const Candidate*> others;
  for (const Candidate& candidate : candidates) {
    const std::string& name = candidate.hypothesis.name;
    const bool known = std::any_of(others.begin(), others.end(),
                                   [&](const Candidate* other) { return other->hypothesis.name == name; });
    if (name != best.hypothesis.name && !known) others.push_back(&candidate);
  }
  return others;
}

/// How well the best one is told from some others, the likeliest first.
std::vector<Rival> rivalsAmong(const Judge& quick, const Judge& exact, const Candidate& best,
                               std::vector<const Candidate*> others) {
  if (best.hypothesis.seen_in_values) return {};  // nothing else makes a comb of the values
  if (others.size() > kRivals) others.resize(kRivals);
  std::vector<Rival> rivals;
  for (const Candidate* other : others) {
    // Held-out samples prefer this one, all samples together the other: two opinions are no answer.
    const bool disputed = other->merit > best.merit;
    const double apart = toldApart(quick, exact, best, *other, kTie);
    rivals.push_back({other->hypothesis.name, disputed ? std::min(apart, kDisputed) : apart});
  }
  return rivals;
}

/// Whether a cause may stand in another one's place.
using MayStand = bool (*)(const Hypothesis& own, const Hypothesis& another);

bool wouldBeNamed(const Hypothesis& own, const Hypothesis& another) {
  return own.kind == CauseKind::kEffect && another.kind != CauseKind::kParameter;
}

bool isRecalibration(const Hypothesis& own, const Hypothesis& another) {
  return own.kind == CauseKind::kEffect && another.kind == CauseKind::kParameter;
}

/// The cause that one pair has in place of one of another pair, which are otherwise the same, if it may stand there.
std::optional<Rival> exchangedIf(MayStand mayStand, const Candidate& other, const Candidate& best) {
  const auto &ours = best.hypothesis.members, &theirs = other.hypothesis.members;
  for (const std::size_t kept : {0U, 1U}) {
    for (const std::size_t same : {0U, 1U}) {
      const Hypothesis &own = ours[1 - kept], &another = theirs[1 - same];
      if (mayStand(own, another) && ours[kept].name == theirs[same].name && own.name != another.name)
        return Rival{another.name, 0.0, own.name};
    }
  }
  return std::nullopt;
}

/// Of the pairs that come near to the best one those causes that may stand in place of one of its.
std::vector<Rival> rivalsIf(MayStand mayStand, const Judge& quick, const Judge& exact,
                            const std::vector<Candidate>& pairs, double added) {
  const Candidate& best = pairs.front();
  std::vector<Rival> rivals;
  for (std::size_t i = 1; i < pairs.size() && i <= kPairsLookedAt && pairs[i].merit >= best.merit - kMayLead; ++i) {
    std::optional<Rival> rival = exchangedIf(mayStand, pairs[i], best);
    if (!rival) continue;
    const bool known = std::any_of(rivals.begin(), rivals.end(), [&](const Rival& r) { return r.name == rival->name; });
    if (known) continue;
    rival->separation = toldApart(quick, exact, best, pairs[i], kTie * added);
    rivals.push_back(std::move(*rival));
  }
  return rivals;
}

}  // namespace

bool Rival::tied() const noexcept { return separation < kApart; }

std::vector<Rival> rivalsOf(const Judge& quick, const Judge& exact, const std::vector<Candidate>& candidates) {
  const Candidate& best = candidates.front();
  std::vector<const Candidate*> others = othersThan(best, candidates);
  std::erase_if(others, [&](const Candidate* other) { return other->merit < best.merit - kMayLead; });
  return rivalsAmong(quick, exact, best, std::move(others));
}

std::vector<Rival> rivalsOfAll(const Judge& quick, const Judge& exact, const std::vector<Candidate>& candidates) {
  const Candidate& best = candidates.front();
  return rivalsAmong(quick, exact, best, othersThan(best, candidates));
}

std::optional<Rival> exchangedIn(const Candidate& other, const Candidate& best) {
  return exchangedIf(wouldBeNamed, other, best);
}

double addedBySecond(const Candidate& single, const std::vector<Candidate>& pairs) {
  double most = 0.0;
  for (std::size_t i = 0; i < pairs.size() && i <= kRivals; ++i) most = std::max(most, pairs[i].explained);
  return most > 0.0 ? std::max(0.0, 1.0 - single.explained / most) : 0.0;
}

std::vector<Rival> rivalsInPairs(const Judge& quick, const Judge& exact, const std::vector<Candidate>& pairs,
                                 double added) {
  return rivalsIf(wouldBeNamed, quick, exact, pairs, added);
}

std::vector<Rival> recalibrationsInPairs(const Judge& quick, const Judge& exact, const std::vector<Candidate>& pairs,
                                         double added) {
  const auto& members = pairs.front().hypothesis.members;
  const auto isEffect = [](const Hypothesis& member) { return member.kind == CauseKind::kEffect; };
  if (!std::all_of(members.begin(), members.end(), isEffect)) return {};
  std::vector<Rival> tied = rivalsIf(isRecalibration, quick, exact, pairs, added);
  std::erase_if(tied, [](const Rival& rival) { return !rival.tied(); });
  return tied;
}

void leadByAll(const Judge& quick, const Judge& exact, std::vector<Candidate>& candidates, double added) {
  const double least_merit = candidates.front().merit - kMayLead;
  for (std::size_t i = 1; i < candidates.size() && i <= kRivals && candidates[i].merit >= least_merit; ++i) {
    const Candidate &best = candidates.front(), &other = candidates[i];
    if (other.hypothesis.name == best.hypothesis.name || !asMuch(exact, other, best)) continue;
    const double apart = separationOnAll(quick, exact, other, best, kTie * added);
    if (apart < std::sqrt(kApart * kApart + 2.0 * costOf(other, best))) continue;
    const auto place = candidates.begin() + static_cast<std::ptrdiff_t>(i);
    std::rotate(candidates.begin(), place, place + 1);
  }
}

void leadByPlainest(const Judge& quick, const Judge& exact, std::vector<Candidate>& candidates, double added) {
  const auto effectsIn = [](const Candidate& candidate) {
    return std::count_if(candidate.hypothesis.members.begin(), candidate.hypothesis.members.end(),
                         [](const Hypothesis& member) { return member.kind == CauseKind::kEffect; });
  };
  const auto isPlainer = [&](const Candidate& other, const Candidate& best) {
    const auto more = effectsIn(other) - effectsIn(best);
    if (more > 0) return priceOf(other) <= priceOf(best) && separationOnAll(quick, exact, best, other, kTie) < kApart;
    return more == 0 && priceOf(other) < priceOf(best) && asMuch(exact, other, best) &&
           toldFromOnAll(quick, exact, best, other, kTie * added) < kApart;
  };
  for (std::size_t i = 1; i < candidates.size() && i <= kRivals; ++i) {
    const Candidate &best = candidates.front(), &other = candidates[i];
    if (best.hypothesis.seen_in_values || other.merit < best.merit - kMayLead) break;
    if (isPlainer(other, best)) std::swap(candidates.front(), candidates[i]);
  }
}

}  // namespace gap
