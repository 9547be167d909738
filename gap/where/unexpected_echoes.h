#pragma once

#include <optional>
#include <vector>

#include "gap/where/residual_tables.h"

namespace gap {

/// Where echoes lie together that neither a surface nor the world makes: a false target, a cloud.
struct UnexpectedEchoes {
  double azimuth_deg;  ///< middle of their quartiles
  double width_deg;    ///< of an even distribution with these quartiles; a column of beams at least
  double range_m;      ///< median
};

/// `expected` by the world in so many `frames` of every sample. What it expects of a beam itself (fog, what stands
/// behind a pane) is left out. Nothing if fewer than five beams have such echoes near a common range.
[[nodiscard]] std::optional<UnexpectedEchoes> unexpectedEchoes(const Replay& replay, const CellsOfSamples& expected,
                                                               const std::vector<int>& frames);

}  // namespace gap
