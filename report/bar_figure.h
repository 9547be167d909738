#pragma once

#include <optional>
#include <string>
#include <vector>

#include "report/axis.h"

namespace report {

/// Horizontal bars with intervals: the ranked causes of a gap, values against limits.
///
///   attenuation  |=========|--|        bar to `value`, whisker over `interval`, the number at the end
///   range walk   |==|-|
///                0       0.5       1
struct BarFigure {
  struct Bar {
    std::string name;
    double value;
    std::optional<Range> interval;
    bool emphasised = false;  ///< drawn in the strong colour: what the text speaks about
    std::string label = {};   ///< at the right end of the row; empty: the value
  };
  std::string title;
  std::string value_name;      ///< with unit
  std::vector<Bar> bars;       ///< drawn in this order, from the top
  std::optional<Range> range;  ///< of the axis; absent: from 0 to the farthest bar or interval
};

/// SVG Tiny 1.2 (see figure.h).
[[nodiscard]] std::string barFigure(const BarFigure& figure);

}  // namespace report
