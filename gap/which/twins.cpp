#include "gap/which/twins.h"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <optional>
#include <utility>

#include "core/parallel.h"
#include "gap/causes/scale.h"
#include "gap/causes/search.h"

namespace gap {

namespace {

constexpr std::size_t kLeading = 3;  // causes whose twins are looked for
constexpr std::size_t kSamples = 3;  // that are simulated for it,
constexpr int kFrames = 4;           // and how often: under the same random numbers one world is one world
constexpr double kSameWorld = 0.01;  // of how far the leading cause goes from the baseline
constexpr double kSameWay = 0.5;     // the same, where a cause's own fit ended: beyond, it goes elsewhere
constexpr int kEven = 24;            // values all over the range
constexpr std::uintmax_t kMostTrials = 24;

bool ofOneNumber(const Candidate& candidate) {
  const Hypothesis& hypothesis = candidate.hypothesis;
  return hypothesis.parameters.size() == 1 && !hypothesis.per_setup && !hypothesis.seen_in_values;
}

/// The world that a cause makes, and how far other worlds are from it.
class WorldToMake {
 public:
  WorldToMake(const Judge& judge, const Candidate& cause)
      : replay_(judge.replay),
        evidence_(spreadOver(judge.split.fitted, kSamples, kFrames)),
        made_(comparisonsOf(replay_, worldOf(replay_, cause.hypothesis, cause.values), evidence_)),
        from_baseline_(distanceOf(replay_.baseline())) {}

  [[nodiscard]] double distanceOf(const World& world) const {
    return discrepancy(replay_, comparisonsTo(made_, replay_, world, evidence_), evidence_.part);
  }

  /// The value at which a cause of one number makes it, if there is one; not of causes that move rays, of which every
  /// value is traced anew.
  [[nodiscard]] std::optional<double> valueIn(const Candidate& other) const {
    const UnitCube cube(other.hypothesis.parameters);
    const auto worldAt = [&](double unit) { return worldOf(replay_, other.hypothesis, cube.valuesAt({unit})); };
    const auto distance = [&](double unit) { return distanceOf(worldAt(unit)); };
    double nearest = cube.unitOf(other.values)[0];
    if (replay_.movesRays(worldAt(nearest))) return std::nullopt;
    double least = distance(nearest);
    if (least > kSameWay * from_baseline_) return std::nullopt;
    for (int i = 0; i <= kEven; ++i) {
      const double unit = static_cast<double>(i) / kEven, apart = distance(unit);
      if (apart < least) nearest = unit, least = apart;
    }
    std::uintmax_t trials = kMostTrials;
    const auto [unit, apart] = boost::math::tools::brent_find_minima(
        distance, std::max(0.0, nearest - 1.0 / kEven), std::min(1.0, nearest + 1.0 / kEven), kLineBits, trials);
    if (std::min(apart, least) > kSameWorld * from_baseline_) return std::nullopt;
    return cube.valuesAt({apart < least ? unit : nearest})[0];
  }

 private:
  const Replay& replay_;
  Evidence evidence_;
  std::vector<Comparison> made_;
  double from_baseline_;
};

}  // namespace

void takeValuesOfTwins(const Judge& quick, const Judge& exact, std::vector<Candidate>& singles,
                       const core::Progress& progress) {
  for (std::size_t l = 0; l < std::min(kLeading, singles.size()); ++l) {
    const Candidate leading = singles[l];
    if (!ofOneNumber(leading)) continue;
    const WorldToMake world(quick, leading);
    std::vector<Candidate> twins = singles;
    core::parallelFor(twins.size(), 1, [&](std::size_t i, std::size_t) {
      core::stopIfCancelled(progress);
      Candidate& twin = twins[i];
      if (!ofOneNumber(twin) || twin.hypothesis.name == leading.hypothesis.name) return;
      const std::optional<double> value = world.valueIn(twin);
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
