#pragma once

#include <vector>

#include "metrics/objects/object_list.h"
#include "metrics/objects/tracks.h"
#include "tests/metrics/points/random_clouds.h"

namespace metrics_test {

using ObjectList = std::vector<metrics::Object>;
using TrackList = std::vector<metrics::Track>;

inline ObjectList objectsAt(const Cloud& positions) {
  ObjectList list;
  for (const metrics::Position& p : positions) list.push_back({.id = static_cast<int>(list.size()), .position = p});
  return list;
}

/// Lists and tracks of all kinds: empty, crowded, with gaps.
class RandomObjects : public RandomClouds {
 public:
  using RandomClouds::RandomClouds;

  ObjectList list(std::uint32_t most, double spread = 3.0) { return objectsAt(cloud(below(most + 1), spread)); }

  /// Exists somewhere.
  metrics::Track track(std::size_t steps, double spread = 2.0) {
    metrics::Track one;
    metrics::Position p = position(spread);
    for (std::size_t k = 0; k < steps; ++k) {
      p.x_m += uniform(-1.0, 1.0);
      const bool there = below(4) != 0;
      one.positions.push_back(there ? std::optional(p) : std::nullopt);
    }
    if (!one.positions[0]) one.positions[0] = p;
    return one;
  }

  TrackList tracks(std::uint32_t most, std::size_t steps, double spread = 2.0) {
    TrackList all;
    for (std::uint32_t left = below(most + 1); left > 0; --left) all.push_back(track(steps, spread));
    return all;
  }
};

/// A track on the x axis from `first` on, one number a step.
inline metrics::Track trackAlongX(std::size_t first, const std::vector<double>& x_m, std::size_t steps) {
  metrics::Track track;
  track.positions.resize(steps);
  for (std::size_t k = 0; k < x_m.size(); ++k) track.positions[first + k] = metrics::Position{.x_m = x_m[k]};
  return track;
}

}  // namespace metrics_test
