#pragma once

#include <string>
#include <vector>

#include "report/axis.h"
#include "report/figure.h"

namespace report {

/// Clouds of points beside each other, each over the same cloud for comparison:
///
///   y | o o  .  |  | o o     |    o  reference, large and pale: stands in every panel
///     | ⊙ ⊙   . |  | ⊙ o     |    .  the panel's own points, small and strong, over it
///     |_________|  |_________|
///          x            x         a ring alone: lost; a dot alone: new; a dot in a ring: unchanged
struct PointFigure {
  struct Cloud {
    std::string name;
    std::vector<Point> points;  ///< [units of the axes]
  };
  std::string title;
  std::string x_name;  ///< with unit
  std::string y_name;
  Range x;
  Range y;
  bool one_scale = false;  ///< a metre across is a metre up: the scene from above
  Cloud reference;
  std::vector<Cloud> panels;  ///< one or two
};

/// SVG Tiny 1.2 (see figure.h). Points outside the ranges are left out.
[[nodiscard]] std::string pointFigure(const PointFigure& content);

}  // namespace report
