#pragma once

#include <functional>
#include <vector>

#include "gap/candidates/candidates.h"
#include "gap/distance/comparison.h"

namespace gap {

/// A world that causes make, and which value of another number makes one most like it. Few samples and frames tell:
/// under the same random numbers one world is one world.
class WorldToMake {
 public:
  /// The judge's replay lives longer than this.
  WorldToMake(const Judge& judge, const World& world);

  [[nodiscard]] double distanceOf(const World& world) const;

  struct Nearest {
    double value = 0.0;
    double distance = 0.0;
  };
  /// All over the range of a number, and at its start.
  [[nodiscard]] Nearest nearestOf(const FreeParameter& number, double start,
                                  const std::function<World(double)>& worldAt) const;

 private:
  const Replay& replay_;
  Evidence evidence_;
  std::vector<Comparison> made_;
};

}  // namespace gap
