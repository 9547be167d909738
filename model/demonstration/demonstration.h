#pragma once

#include <string>
#include <vector>

#include "model/demonstration/plan.h"

namespace model {

/// What one effect does to the detections, as numbers for a picture: the real model on a scene in which the effect
/// shows, without it and with it.
struct Demonstration {
  struct Series {
    std::string name;
    std::vector<double> x;
    std::vector<double> y;  ///< NaN: nothing was detected there
  };
  DemonstrationPlan plan;
  /// First the one without the effect, then one for each setting. Lines share their x; points do not.
  std::vector<Series> series;
};

/// Simulates what the plan asks for. Deterministic.
[[nodiscard]] Demonstration demonstrate(const DemonstrationPlan& plan);

/// How far a series lies from the one without the effect, 0 … 1: of lines the mean distance (at most the whole picture)
/// over all values' spread, a value against none counting as all of it; of points the share of places that only one of
/// both has.
[[nodiscard]] double difference(const Demonstration& demonstration, std::size_t series);

}  // namespace model
