#include "gap/which/pair_by_means.h"

#include <algorithm>
#include <span>
#include <utility>

#include "core/parallel.h"
#include "gap/which/tried.h"

namespace gap {

namespace {

constexpr double kMaterial = 0.05;  // of the squared deviations of the model as it is: less is how programs differ
constexpr double kLeft = 0.1;       // of those that the nearest single cause leaves

/// Which of some candidates is nearest by the means, and its criterion. There is one at least.
std::pair<const Candidate*, double> nearest(const Judge& quick, std::span<const Candidate> candidates,
                                            const core::Progress& progress) {
  std::vector<double> bic(candidates.size());
  core::parallelFor(bic.size(), 1, [&](std::size_t i, std::size_t) {
    core::stopIfCancelled(progress);
    const Candidate& candidate = candidates[i];
    const World world = worldOf(quick.replay, candidate.hypothesis, candidate.values);
    bic[i] = bicOf(quick.replay, world, quick.split.refined, candidate.values.size());
  });
  const auto least = std::min_element(bic.begin(), bic.end());
  return {&candidates[static_cast<std::size_t>(least - bic.begin())], *least};
}

}  // namespace

std::optional<Candidate> pairByMeans(const Judge& quick, const std::vector<Candidate>& singles,
                                     const std::vector<Candidate>& pairs, const core::Progress& progress) {
  if (singles.empty() || pairs.empty()) return std::nullopt;
  const std::span leaders = std::span(singles).first(std::min(kLeaders, singles.size()));
  const double single = nearest(quick, leaders, progress).second;
  if (single < kMaterial * bicOf(quick.replay, quick.replay.baseline(), quick.split.refined, 0)) return std::nullopt;
  const auto [pair, left] = nearest(quick, pairs, progress);
  return left < kLeft * single ? std::optional(*pair) : std::nullopt;
}

}  // namespace gap
