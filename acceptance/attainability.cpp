#include "acceptance/attainability.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "core/text.h"
#include "metrics/resampling/permutation_floor.h"

namespace acceptance {

namespace {

/// Enough for a median; the verdict does not depend on it.
constexpr std::size_t kReplicates = 200;

/// A limit from above of a distance that is > 0 for equal distributions, too.
bool hasFloor(const Relation& relation) {
  const bool upper = relation.order == Order::LessOrEqual || relation.order == Order::Less;
  return upper && !std::isnan(relation.limit) && (relation.left == "d_avm" || relation.left == "d_cavm");
}

}  // namespace

std::vector<std::string> unattainableLimits(const std::vector<Relation>& relations, const Distributions& distributions,
                                            const std::string& unit, std::uint64_t seed, core::Progress& progress) {
  std::vector<std::string> remarks;
  if (std::none_of(relations.begin(), relations.end(), hasFloor) || !distributions.complete()) return remarks;
  std::vector<std::size_t> sizes;
  for (const std::vector<double>& run : distributions.simulated) sizes.push_back(run.size());
  const metrics::Floor floor = metrics::samplingFloor({.values = distributions.measured, .units = {}}, sizes,
                                                      {.replicates = kReplicates, .seed = seed}, progress);
  for (const Relation& relation : relations) {
    if (!hasFloor(relation)) continue;
    const metrics::NullDistribution& null = relation.left == "d_avm" ? floor.area : floor.scatter;
    if (metrics::attainable(relation.limit, null)) continue;
    const std::string suffix = unit.empty() ? "" : " " + unit;
    remarks.push_back(fmt::format(
        "the limit of {}, {}{}, is below {}{}, which chance alone gives at n = {}; take more data or a higher limit",
        relation.left, core::significant(relation.limit, 3), suffix, core::significant(null.median(), 3), suffix,
        distributions.measured.size()));
  }
  return remarks;
}

}  // namespace acceptance
