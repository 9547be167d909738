#include "gap/next_experiment.h"

#include <algorithm>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "gap/distance/discrepancy.h"
#include "gap/report/wording.h"
#include "gap/which/confusion.h"
#include "gap/which/partners.h"
#include "gap/which/rivals.h"

namespace gap {

namespace {

/// A cause, alone or with the one that is named beside it.
struct Asked {
  std::string cause;
  Candidate candidate;
};

const Candidate* named(const std::vector<Candidate>& singles, const std::string& name) {
  const auto found = std::find_if(singles.begin(), singles.end(),
                                  [&](const Candidate& candidate) { return candidate.hypothesis.name == name; });
  return found == singles.end() ? nullptr : &*found;
}

/// The best of the single causes that is none of these.
const Candidate* bestBut(const std::vector<Candidate>& singles, const std::vector<std::string>& names) {
  const auto other = std::find_if(singles.begin(), singles.end(), [&](const Candidate& candidate) {
    return std::find(names.begin(), names.end(), candidate.hypothesis.name) == names.end();
  });
  return other == singles.end() ? nullptr : &*other;
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
  std::optional<Rivals> first;
  for (const Candidate& pair : decision.pairs) {
    const std::optional<Rival> other = exchangedIn(pair, winner);
    if (!other) continue;
    const Rivals rivals{{other->instead_of, winner}, {other->name, pair}};
    if (!first) first = rivals;
    for (const Rival& nearest : nearestFirst(decision.rivals))
      if (nearest.name == other->name && nearest.instead_of == other->instead_of) return rivals;
  }
  if (first) return first;
  const std::vector<Candidate> members = membersOf(winner);
  const Candidate* const other = bestBut(decision.singles, {members[0].hypothesis.name, members[1].hypothesis.name});
  if (!other) return std::nullopt;
  return Rivals{{members[0].hypothesis.name, winner}, {other->hypothesis.name, pairOf(*other, members[1])}};
}

std::optional<Rivals> rivalsOfSingle(const Decision& decision) {
  const Candidate& winner = *decision.winner;
  const Candidate* other = nullptr;
  for (const Rival& nearest : nearestFirst(decision.rivals))
    if (!other) other = named(decision.singles, nearest.name);
  if (!other) other = bestBut(decision.singles, {winner.hypothesis.name});
  if (!other) return std::nullopt;
  return Rivals{{winner.hypothesis.name, winner}, {other->hypothesis.name, *other}};
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
