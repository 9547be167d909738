#pragma once

#include "metrics/grids/occupancy_grid.h"

namespace metrics {

/// How near to certainty probabilities are believed: they are clipped to [clip, 1 - clip] before the map score. Our
/// default; a cell then scores between -7.97 and 1.00 bit.
inline constexpr double kUsualClip = 1e-3;

/// Map score: how well two grids predict each other, summed over all cells. [bit]
///
///   score = sum over cells of 1 + log2( p q + (1 - p)(1 - q) )      p simulated, q measured
///
/// A cell counts 1 if both are certain and agree, 0 if either is unknown (0.5), and -inf if both are certain and
/// differ: hence the clip. With a clip of 0 nothing is clipped, and one such cell makes the score -inf.
///
/// High is good; the best is the number of cells, reached by certain grids only. The score rewards certainty, not
/// equality: against q = 0.6 it is highest for p = 1. Grows with the number of cells, so that a larger empty margin
/// raises it: see mapScorePerCell.
///
/// Throws InputError if the grids are not comparable or the clip is not in [0, 0.5).
/// Source: Martin & Moravec 1996, Robot evidence grids, CMU-RI-TR-96-06.
[[nodiscard]] double mapScore(const GridPair& grids, double clip = kUsualClip);

/// The same divided by the number of cells, at most 1. [bit]
[[nodiscard]] double mapScorePerCell(const GridPair& grids, double clip = kUsualClip);

}  // namespace metrics
