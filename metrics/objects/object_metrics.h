#pragma once

#include <span>

#include "metrics/metric_info.h"
#include "metrics/objects/object_list.h"
#include "metrics/objects/tracks.h"

namespace metrics {

/// What the metrics of objects and tracks may be told. The defaults are ours.
struct ObjectOptions {
  SetOptions set;                ///< order p, cut-off c
  double label_m = 2.5;          ///< OSPA-T: what a wrong label costs, at most c
  double piece_m = 2.5;          ///< OSPA-MT: what a step of a further piece of a broken track costs, at most c
  double switch_m = 1.0;         ///< track metric: gamma, what a switch costs
  double least_existence = 0.0;  ///< objects of smaller probability are no part of a list
};

/// Two object lists of one instant in one frame. Results in metres, Jaccard's without unit.
struct ObjectListInput {
  ObjectLists lists;
  ObjectOptions options = {};
};

/// Two sets of tracks over the same time steps in one frame. Results in metres.
struct TracksInput {
  TrackSets sets;
  ObjectOptions options = {};
};

/// Every metric of two object lists, and of two sets of tracks; one entry each in the source.
[[nodiscard]] std::span<const MetricOf<ObjectListInput>> objectMetrics();
[[nodiscard]] std::span<const MetricOf<TracksInput>> trackMetrics();

}  // namespace metrics
