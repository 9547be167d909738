#pragma once

#include <optional>
#include <span>
#include <vector>

#include "metrics/points/point_cloud.h"

namespace metrics {

/// Where one object is at each time step; absent while it is not tracked. Gaps are allowed.
struct Track {
  int id = 0;
  std::vector<std::optional<Position>> positions;

  [[nodiscard]] bool existsAt(std::size_t step) const noexcept { return positions[step].has_value(); }
};

/// Two sets of tracks over the same time steps. Referred to, not owned. Either may be empty.
struct TrackSets {
  std::span<const Track> simulated;
  std::span<const Track> measured;

  /// Common number of time steps; 0 if there is no track.
  [[nodiscard]] std::size_t steps() const noexcept;
};

/// Throws InputError that names side, row (from 1) and step (from 1): numbers of steps differ, a position is not
/// finite, or a track exists nowhere.
void mustBeValid(const TrackSets& sets);

}  // namespace metrics
