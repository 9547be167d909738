#pragma once

#include "gap/replay/replay.h"

namespace gap {

/// Whether a measurement was made on the grid of sub-rays that the model has, as `fidelis simulate` makes one: where
/// edges cut beams, or surfaces stretch them, it is nearer to `as_run` (the model on that grid) than to `dense` (on the
/// denser grid there). Real sensors have no grid, and other programs have others.
[[nodiscard]] bool madeOnTheModelsGrid(const Replay& dense, const Replay& as_run);

}  // namespace gap
