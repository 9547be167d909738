#include "gap/next_experiment.h"

#include <algorithm>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "gap/distance/discrepancy.h"
#include "gap/pairs/partners.h"
#include "gap/report/wording.h"
#include "gap/which/confusion.h"
#include "gap/which/rivals.h"

namespace gap {

namespace {

/// A cause, alone or with the one that is named beside it.
struct Asked {
  std::string cause;
  Candidate candidate;
};

/// The best of the single causes whose name suits; null if none does.
template <class Suits>
const Candidate* firstOf(const std::vector<Candidate>& singles, Suits suits) {
  const auto found = std::find_if(singles.begin(), singles.end(),
                                  [&](const Candidate& candidate) { return suits(candidate.hypothesis.name); });
  return found == singles.end() ? nullptr : &*found;
}

/// Those that come near to what is named, the nearest first.
std::vector<Rival> nearestFirst(std::vector<Rival> rivals) {
  std::stable_sort(rivals.begin(), rivals.end(),
                   [](const Rival& a, const Rival& b) { return a.separation < b.separation; });
  return rivals;
}

/// Two that should be told apart.
using Rivals = std::pair<Asked, Asked>;

std::optional<Rivals> rivalsOfPair(const Decision& decision) {
  const Candidate& winner = *decision.winner;
  for (const Rival& nearest : nearestFirst(decision.rivals)) {
    const Candidate* const pair = pairWith(decision, nearest);
    if (pair) return Rivals{{nearest.instead_of, winner}, {nearest.name, *pair}};
  }
  for (const Candidate& pair : decision.pairs) {
    const std::optional<Rival> other = exchangedIn(pair, winner);
    if (other) return Rivals{{other->instead_of, winner}, {other->name, pair}};
  }
  const std::vector<Candidate> members = membersOf(winner);
  const std::string &asked = members[0].hypothesis.name, &kept = members[1].hypothesis.name;
  const Candidate* const other =
      firstOf(decision.singles, [&](const std::string& name) { return name != asked && name != kept; });
  if (!other) return std::nullopt;
  return Rivals{{asked, winner}, {other->hypothesis.name, pairOf(*other, members[1])}};
}

std::optional<Rivals> rivalsOfSingle(const Decision& decision) {
  const Candidate& winner = *decision.winner;
  const std::string& asked = winner.hypothesis.name;
  const Candidate* other = nullptr;
  for (const Rival& nearest : nearestFirst(decision.rivals))
    if (!other) other = firstOf(decision.singles, [&](const std::string& name) { return name == nearest.name; });
  if (!other) other = firstOf(decision.singles, [&](const std::string& name) { return name != asked; });
  if (!other) return std::nullopt;
  return Rivals{{asked, winner}, {other->hypothesis.name, *other}};
}

std::size_t sampleOfLargestDifference(const Replay& replay, const World& a, const World& b, std::uint64_t seed) {
  constexpr int kFewest = 3, kMost = 8;  // frames
  std::size_t best = 0;
  double largest = -1.0;
  for (std::size_t s = 0; s < replay.samples().size(); ++s) {
    const int frames = std::clamp(replay.samples()[s].frames, kFewest, kMost);
    const auto of_a = replay.simulate(a, s, frames, seed);
    const Comparison comparison{s, of_a, frames, replay.simulate(b, s, frames, seed), frames};
    const double difference = discrepancy(replay, std::span(&comparison, 1));
    if (difference > largest) {
      largest = difference;
      best = s;
    }
  }
  return best;
}

}  // namespace

std::optional<NextExperiment> nextExperiment(const Judge& judge, const Decision& decision) {
  const Replay& replay = judge.replay;
  const std::uint64_t seed = judge.split.fitted.seed;
  if (!decision.winner) return std::nullopt;
  const std::optional<Rivals> rivals = decision.pair() ? rivalsOfPair(decision) : rivalsOfSingle(decision);
  if (!rivals) return std::nullopt;
  const auto worldOfAsked = [&](const Asked& asked) {
    return worldOf(replay, asked.candidate.hypothesis, asked.candidate.values);
  };
  const World a = worldOfAsked(rivals->first), b = worldOfAsked(rivals->second);
  const std::size_t best = sampleOfLargestDifference(replay, a, b, seed);
  NextExperiment next;
  next.separates = {rivals->first.cause, rivals->second.cause};
  next.parameters = replay.samples()[best].sample->parameters;
  next.sample = replay.samples()[best].sample->id;
  next.predictions = predictionsOf(replay, {replay.baseline(), a, b}, best, seed);
  next.text = nextExperimentSentence(next);
  return next;
}

}  // namespace gap
