#pragma once

#include "gap/replay/geometry_cache.h"
#include "gap/replay/replay_sample.h"
#include "gap/replay/world.h"

namespace gap {

/// What the beams of a sample meet in a world, as closely as the detail says: those that are not wholly on one face of
/// one object on a denser, sheared grid, hits on one object joined. All beams of the scan where one beam's echo depends
/// on others in that world. Of the baseline only the width of its pulse counts: worlds that differ in theirs share
/// their hits.
[[nodiscard]] GeometryCache::Geometry traceSample(const model::Experiment& experiment, const ReplaySample& replayed,
                                                  const World& world, const World& baseline, const Detail& detail);

}  // namespace gap
