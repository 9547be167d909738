#include "gap/pairs/pair_by_means.h"

#include <algorithm>

#include "core/parallel.h"
#include "gap/candidates/tried.h"

namespace gap {

namespace {

constexpr double kMaterial = 0.05;  // of the squared deviations of the model as it is: less is how programs differ
constexpr double kLeft = 0.1;       // of those that the nearest leader leaves
constexpr double kOnlyNoise = 0.5;  // of the noise, beyond it: so little a pair leaves where no programs differ

/// A candidate, and what it leaves: Σ z² with the price of its numbers, beyond the n that a right one leaves.
struct Left {
  const Candidate* candidate;
  double beyond_noise;
  double noise;
};

/// Which of some candidates leaves least. There is one at least.
Left nearest(const Judge& quick, std::span<const Candidate> candidates, const core::Progress& progress) {
  std::vector<Left> left(candidates.size());
  core::parallelFor(left.size(), 1, [&](std::size_t i, std::size_t) {
    core::stopIfCancelled(progress);
    const Candidate& candidate = candidates[i];
    const World world = worldOf(quick.replay, candidate.hypothesis, candidate.values);
    const MeansApart means = meansApart(quick.replay, world, quick.split.refined);
    const auto noise = static_cast<double>(means.terms);
    left[i] = {&candidate, bicOf(means, candidate.values.size()) - noise, noise};
  });
  return *std::min_element(left.begin(), left.end(),
                           [](const Left& a, const Left& b) { return a.beyond_noise < b.beyond_noise; });
}

}  // namespace

std::optional<Candidate> pairByMeans(const Judge& quick, std::span<const Candidate> leaders,
                                     const std::vector<Candidate>& pairs, const core::Progress& progress) {
  if (leaders.empty() || pairs.empty()) return std::nullopt;
  const Left leader = nearest(quick, leaders, progress);
  const double at_first = meansApart(quick.replay, quick.replay.baseline(), quick.split.refined).sum;
  const bool material = leader.beyond_noise >= kMaterial * at_first;
  if (!material && leader.beyond_noise < leader.noise) return std::nullopt;
  const Left pair = nearest(quick, pairs, progress);
  const bool agree = pair.beyond_noise < kOnlyNoise * pair.noise;
  const bool takes = pair.beyond_noise < kLeft * leader.beyond_noise;
  return takes && (material || agree) ? std::optional(*pair.candidate) : std::nullopt;
}

}  // namespace gap
