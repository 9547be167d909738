#include "metrics/objects/track_ospa.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "core/error.h"
#include "metrics/distributions/summation.h"

namespace metrics {

namespace {

/// What two tracks cost over time, and at how many steps at least one exists.
struct Overlap {
  double cost = 0.0;
  std::size_t steps = 0;
};

Overlap overlap(const Track& a, const Track& b, double cutoff_m) {
  Overlap result;
  Summation sum;
  for (std::size_t k = 0; k < a.positions.size(); ++k) {
    if (!a.existsAt(k) && !b.existsAt(k)) continue;
    ++result.steps;
    const bool both = a.existsAt(k) && b.existsAt(k);
    sum.add(both ? std::min(cutoff_m, distance(*a.positions[k], *b.positions[k])) : cutoff_m);
  }
  result.cost = sum.value();
  return result;
}

double costAlone(const Track& track, double cutoff_m) {
  return cutoff_m *
         static_cast<double>(std::ranges::count_if(track.positions, [](const auto& p) { return p.has_value(); }));
}

std::vector<std::size_t> existingAt(std::size_t step, std::span<const Track> tracks) {
  std::vector<std::size_t> indices;
  for (std::size_t i = 0; i < tracks.size(); ++i) {
    if (tracks[i].existsAt(step)) indices.push_back(i);
  }
  return indices;
}

void mustBeValid(const LabelledOptions& options) {
  metrics::mustBeValid(options.set);
  mustBePenalty(options.label_m, "label penalty");
  if (options.label_m <= options.set.cutoff_m) return;
  throw core::InputError(
      {.item = "label penalty"},
      fmt::format("is {} m; it must not exceed the cut-off {} m.", options.label_m, options.set.cutoff_m),
      "Take at most the cut-off: as much as a missing object.");
}

}  // namespace

std::vector<std::optional<std::size_t>> labelsOf(const TrackSets& sets, double cutoff_m) {
  mustBeValid(sets);
  // Tracks left over pay for themselves; what counts for a pair is how much less it costs together.
  const CostTable gains(sets.simulated.size(), sets.measured.size(), [&](std::size_t s, std::size_t m) {
    return overlap(sets.simulated[s], sets.measured[m], cutoff_m).cost - costAlone(sets.simulated[s], cutoff_m) -
           costAlone(sets.measured[m], cutoff_m);
  });
  return optimalAssignment(gains);
}

TrackOspa ospaT(const TrackSets& sets, const LabelledOptions& options) {
  mustBeValid(options);
  const auto label_of = labelsOf(sets, options.set.cutoff_m);
  const double wrong = std::pow(options.label_m, options.set.order);
  TrackOspa result;
  Summation sum;
  for (std::size_t k = 0; k < sets.steps(); ++k) {
    const std::vector<std::size_t> measured = existingAt(k, sets.measured);
    const std::vector<std::size_t> simulated = existingAt(k, sets.simulated);
    const CostTable distances(measured.size(), simulated.size(), [&](std::size_t i, std::size_t j) {
      const double d = distance(*sets.measured[measured[i]].positions[k], *sets.simulated[simulated[j]].positions[k]);
      const bool same = label_of[simulated[j]] == measured[i];
      return same ? d : std::pow(std::pow(d, options.set.order) + wrong, 1.0 / options.set.order);
    });
    result.per_step.push_back(ospa(distances, options.set).distance);
    sum.add(result.per_step.back());
  }
  if (!result.per_step.empty()) result.mean = sum.value() / static_cast<double>(result.per_step.size());
  return result;
}

Ospa ospaOfTracks(const TrackSets& sets, const SetOptions& options) {
  mustBeValid(sets);
  metrics::mustBeValid(options);
  const CostTable distances(sets.measured.size(), sets.simulated.size(), [&](std::size_t i, std::size_t j) {
    const Overlap both = overlap(sets.measured[i], sets.simulated[j], options.cutoff_m);
    return both.cost / static_cast<double>(both.steps);
  });
  return ospa(distances, options);
}

}  // namespace metrics
