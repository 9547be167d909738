#pragma once

#include "metrics/grids/cell_mask.h"
#include "metrics/grids/occupancy_grid.h"

namespace metrics {

/// Two pictures of the same size.
struct MaskPair {
  const CellMask& simulated;
  const CellMask& measured;
};

/// Picture distance of one colour: how far set cells of one picture lie from the nearest set cell of the other, on
/// average, both ways. [cells]
///
///   psi_c = d(m, s) + d(s, m)       d(m, s) = mean over set cells of m of the Manhattan distance to the nearest of s
///
/// 0 for equal pictures and for two empty ones, infinite if only one is empty: nothing is near. Symmetric; grows with a
/// displacement where a cell-wise comparison only sees that cells differ. Linear in the cells (distance_transform.h).
/// Sources: Birk 1996, Learning geometric concepts with an evolutionary algorithm; Birk & Carpin 2006,
/// doi:10.1109/JPROC.2006.876965.
[[nodiscard]] double colourDistance(const MaskPair& pictures);

/// OPD, of the occupied cells, and UPD, of the unoccupied (free) ones. No source that spells out the abbreviations of
/// Rosenberger 2022, Tab. 4-3 was at hand: occupied and unoccupied picture distance is our reading.
/// In cells; times cell_size_m in metres. Throw InputError if the grids are not comparable.
[[nodiscard]] double occupiedPictureDistance(const GridPair& grids, const CellLimits& limits = {});
[[nodiscard]] double unoccupiedPictureDistance(const GridPair& grids, const CellLimits& limits = {});

/// Picture distance psi: the sum over the colours occupied and free. Unknown cells are no colour of their own, since
/// they say nothing of the world. [cells]
[[nodiscard]] double pictureDistance(const GridPair& grids, const CellLimits& limits = {});

}  // namespace metrics
