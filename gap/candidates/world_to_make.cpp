#include "gap/candidates/world_to_make.h"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cstdint>

#include "gap/causes/scale.h"
#include "gap/causes/search.h"

namespace gap {

namespace {

constexpr std::size_t kSamples = 3;  // that are simulated,
constexpr int kFrames = 4;           // and how often
constexpr int kEven = 24;            // values all over the range
constexpr std::uintmax_t kMostTrials = 24;

}  // namespace

WorldToMake::WorldToMake(const Judge& judge, const World& world)
    : replay_(judge.replay),
      evidence_(spreadOver(judge.split.fitted, kSamples, kFrames)),
      made_(comparisonsOf(replay_, world, evidence_)) {}

double WorldToMake::distanceOf(const World& world) const {
  return discrepancy(replay_, comparisonsTo(made_, replay_, world, evidence_), evidence_.part);
}

WorldToMake::Nearest WorldToMake::nearestOf(const FreeParameter& number, double start,
                                            const std::function<World(double)>& worldAt) const {
  const UnitCube cube({number});
  const auto valueAt = [&](double unit) { return cube.valuesAt({unit})[0]; };
  const auto distanceAt = [&](double unit) { return distanceOf(worldAt(valueAt(unit))); };
  double nearest = cube.unitOf({start})[0];
  double least = distanceAt(nearest);
  for (int i = 0; i <= kEven; ++i) {
    const double unit = static_cast<double>(i) / kEven, apart = distanceAt(unit);
    if (apart < least) nearest = unit, least = apart;
  }
  std::uintmax_t trials = kMostTrials;
  const auto [unit, apart] = boost::math::tools::brent_find_minima(
      distanceAt, std::max(0.0, nearest - 1.0 / kEven), std::min(1.0, nearest + 1.0 / kEven), kLineBits, trials);
  return apart < least ? Nearest{valueAt(unit), apart} : Nearest{valueAt(nearest), least};
}

}  // namespace gap
