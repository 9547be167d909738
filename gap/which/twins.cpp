#include "gap/which/twins.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "core/parallel.h"
#include "gap/candidates/world_to_make.h"

namespace gap {

namespace {

constexpr std::size_t kLeading = 3;  // causes whose twins are looked for
constexpr double kSameWorld = 0.01;  // of how far the leading cause goes from the baseline
constexpr double kSameWay = 0.5;     // the same, where a cause's own fit ended: beyond, it goes elsewhere

bool ofOneNumber(const Candidate& candidate) {
  const Hypothesis& hypothesis = candidate.hypothesis;
  return hypothesis.parameters.size() == 1 && !hypothesis.per_setup && !hypothesis.seen_in_values;
}

/// The value at which a cause of one number makes this world, if there is one; not of causes that move rays, of which
/// every value is traced anew. `from_baseline`: how far the baseline is from it.
std::optional<double> valueIn(const Replay& replay, const WorldToMake& world, double from_baseline,
                              const Candidate& other) {
  const auto worldAt = [&](double value) { return worldOf(replay, other.hypothesis, {value}); };
  const double fitted = other.values.front();
  if (replay.movesRays(worldAt(fitted)) || world.distanceOf(worldAt(fitted)) > kSameWay * from_baseline)
    return std::nullopt;
  const WorldToMake::Nearest nearest = world.nearestOf(other.hypothesis.parameters.front(), fitted, worldAt);
  return nearest.distance > kSameWorld * from_baseline ? std::nullopt : std::optional(nearest.value);
}

}  // namespace

void takeValuesOfTwins(const Judge& quick, const Judge& exact, std::vector<Candidate>& singles,
                       const core::Progress& progress) {
  for (std::size_t l = 0; l < std::min(kLeading, singles.size()); ++l) {
    const Candidate leading = singles[l];
    if (!ofOneNumber(leading)) continue;
    const WorldToMake world(quick, worldOf(quick.replay, leading.hypothesis, leading.values));
    const double from_baseline = world.distanceOf(quick.replay.baseline());
    std::vector<Candidate> twins = singles;
    core::parallelFor(twins.size(), 1, [&](std::size_t i, std::size_t) {
      core::stopIfCancelled(progress);
      Candidate& twin = twins[i];
      if (!ofOneNumber(twin) || twin.hypothesis.name == leading.hypothesis.name) return;
      const std::optional<double> value = valueIn(quick.replay, world, from_baseline, twin);
      if (!value) return;
      twin.values = {*value};
      twin.total_left = leading.total_left;
      exact.hear(twin);
    });
    std::erase_if(twins,
                  [&](const Candidate& twin) { return twin.values == singles[placeOfForm(singles, twin)].values; });
    takeBetter(std::move(twins), singles);
  }
}

}  // namespace gap
