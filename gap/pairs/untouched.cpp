#include "gap/pairs/untouched.h"

#include <algorithm>
#include <utility>

#include "gap/candidates/enough.h"
#include "gap/candidates/significance.h"
#include "gap/pairs/second_search.h"

namespace gap {

namespace {

constexpr double kMoved = 0.1;  // of how far the model is from the measurement in an aspect, its noise and all
constexpr std::size_t kNoiseRuns = 20;

constexpr Aspects kNothing{.existence = false, .means = {}, .spreads = {}};

/// The baseline on some evidence, beside what was measured and beside another world under the same random numbers.
class Beside {
 public:
  Beside(const Replay& replay, const World& world, const Evidence& evidence)
      : replay_(replay),
        part_(evidence.part),
        to_measured_(comparisonsOf(replay, replay.baseline(), evidence)),
        to_world_(comparisonsTo(to_measured_, replay, world, evidence)) {}

  /// Whether the world hardly differs from the baseline in these aspects.
  [[nodiscard]] bool alikeIn(const Aspects& aspects) const {
    Part part = part_;
    part.aspects = aspects;
    return discrepancy(replay_, to_world_, part) <= kMoved * discrepancy(replay_, to_measured_, part);
  }

 private:
  const Replay& replay_;
  Part part_;
  std::vector<Comparison> to_measured_;
  std::vector<Comparison> to_world_;  ///< the baseline in place of what was measured
};

bool anyOf(const Aspects& aspects) {
  const auto set = [](bool aspect) { return aspect; };
  return aspects.existence || std::any_of(aspects.means.begin(), aspects.means.end(), set) ||
         std::any_of(aspects.spreads.begin(), aspects.spreads.end(), set);
}

/// The same split, of which only these aspects count.
Split restrictedTo(Split split, const Aspects& aspects) {
  for (Evidence* const evidence : {&split.fitted, &split.held_out, &split.refined}) evidence->part.aspects = aspects;
  return split;
}

Judge judgeBeside(const Judge& exact, const Candidate& known) {
  const Aspects aspects = untouchedBy(exact, known);
  Judge there{exact.replay, restrictedTo(exact.split, aspects), {}};
  if (!anyOf(aspects)) return there;
  const World world = worldOf(exact.replay, known.hypothesis, known.values);
  const Distribution perfect = ownNoiseOf(there, world, kNoiseRuns);
  there.yardstick = {discrepancyOf(exact.replay, world, there.split.held_out), perfect.mean, perfect.stddev};
  return there;
}

}  // namespace

Aspects untouchedBy(const Judge& judge, const Candidate& cause) {
  const World world = worldOf(judge.replay, cause.hypothesis, cause.values);
  const Beside beside(judge.replay, world, judge.split.held_out);
  Aspects untouched = kNothing, only = kNothing;
  only.existence = true;
  untouched.existence = beside.alikeIn(only);
  for (const Channel channel : judge.replay.channels()) {
    only = kNothing;
    only.means[channel] = true;
    untouched.means[channel] = beside.alikeIn(only);
    only = kNothing;
    only.spreads[channel] = true;
    untouched.spreads[channel] = beside.alikeIn(only);
  }
  return untouched;
}

WhereUntouched::WhereUntouched(const Judge& exact, Candidate known)
    : exact_(exact), known_(std::move(known)), there_(judgeBeside(exact, known_)) {}

bool WhereUntouched::missesSomething() const {
  return anyOf(there_.split.held_out.part.aspects) && there_.yardstick.z() > Yardstick::kClear_z;
}

std::vector<Candidate> WhereUntouched::pairs(const Judge& quick, const std::vector<Candidate>& singles,
                                             core::Progress& progress) const {
  const Judge chooser{quick.replay, restrictedTo(quick.split, there_.split.held_out.part.aspects), there_.yardstick};
  std::vector<Candidate> pairs = pairsBeside(chooser, there_, known_, singles, progress);
  std::erase_if(pairs, [&](const Candidate& pair) { return pair.explained < enoughToName(there_.yardstick); });
  for (Candidate& pair : pairs) exact_.hear(pair);
  return pairs;
}

bool WhereUntouched::nothingLeftBy(const Candidate& pair) const { return deviationsLeft(there_, pair) < kNoRest; }

}  // namespace gap
