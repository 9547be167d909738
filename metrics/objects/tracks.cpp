#include "metrics/objects/tracks.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "core/error.h"

namespace metrics {

namespace {

void mustBeValid(const Track& track, std::size_t steps, const std::string& where) {
  if (track.positions.size() != steps) {
    throw core::InputError({.item = where},
                           fmt::format("has {} time steps, the first track has {}.", track.positions.size(), steps),
                           "Give every track all steps; where it does not exist, leave the position out.");
  }
  if (std::ranges::none_of(track.positions, [](const auto& p) { return p.has_value(); })) {
    throw core::InputError({.item = where}, "exists at no time step.", "Remove it.");
  }
  for (std::size_t k = 0; k < steps; ++k) {
    if (!track.positions[k]) continue;
    const Position& p = *track.positions[k];
    if (std::isfinite(p.x_m) && std::isfinite(p.y_m) && std::isfinite(p.z_m)) continue;
    throw core::InputError({.item = fmt::format("{}, step {}", where, k + 1)},
                           fmt::format("is at ({}, {}, {}) m; a position must be finite.", p.x_m, p.y_m, p.z_m),
                           "Leave it out where the track does not exist, else correct it.");
  }
}

}  // namespace

std::size_t TrackSets::steps() const noexcept {
  if (!measured.empty()) return measured.front().positions.size();
  return simulated.empty() ? 0 : simulated.front().positions.size();
}

void mustBeValid(const TrackSets& sets) {
  for (std::size_t i = 0; i < sets.measured.size(); ++i) {
    mustBeValid(sets.measured[i], sets.steps(), fmt::format("measured track {}", i + 1));
  }
  for (std::size_t i = 0; i < sets.simulated.size(); ++i) {
    mustBeValid(sets.simulated[i], sets.steps(), fmt::format("simulated track {}", i + 1));
  }
}

}  // namespace metrics
