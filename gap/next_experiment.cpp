#include "gap/next_experiment.h"

#include <algorithm>
#include <utility>

#include "gap/distance/discrepancy.h"
#include "gap/report/wording.h"
#include "gap/which/rivals.h"

namespace gap {

namespace {

/// A candidate, and the cause in it that is asked for.
struct Asked {
  std::string cause;
  const Candidate* candidate;
};

/// The first of the single causes that is none of these.
std::optional<Asked> firstBut(const std::vector<Candidate>& singles, const std::vector<std::string>& names) {
  const auto other = std::find_if(singles.begin(), singles.end(), [&](const Candidate& candidate) {
    return std::find(names.begin(), names.end(), candidate.hypothesis.name) == names.end();
  });
  return other == singles.end() ? std::nullopt : std::optional(Asked{other->hypothesis.name, &*other});
}

/// Two that should be told apart.
using Rivals = std::pair<Asked, Asked>;

std::optional<Rivals> rivalsOfPair(const Decision& decision) {
  for (const Candidate& pair : decision.pairs) {
    const std::optional<Rival> other = exchangedIn(pair, *decision.winner);
    if (other) return Rivals{{other->instead_of, &*decision.winner}, {other->name, &pair}};
  }
  std::vector<std::string> members;
  for (const Hypothesis& member : decision.winner->hypothesis.members) members.push_back(member.name);
  const std::optional<Asked> other = firstBut(decision.singles, members);
  return other ? std::optional(Rivals{{decision.names().front(), &*decision.winner}, *other}) : std::nullopt;
}

std::optional<Rivals> rivalsIn(const Decision& decision) {
  if (decision.pair()) return rivalsOfPair(decision);
  const std::optional<Asked> first =
      decision.winner ? Asked{decision.winner->hypothesis.name, &*decision.winner} : firstBut(decision.singles, {});
  const std::optional<Asked> second = first ? firstBut(decision.singles, {first->cause}) : std::nullopt;
  return second ? std::optional(Rivals{*first, *second}) : std::nullopt;
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
  const std::optional<Rivals> rivals = rivalsIn(decision);
  if (!rivals) return std::nullopt;
  const auto worldOfAsked = [&](const Asked& asked) {
    return worldOf(replay, asked.candidate->hypothesis, asked.candidate->values);
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
