#pragma once

#include <optional>
#include <string>
#include <vector>

#include "report/axis.h"

namespace report {

/// Functions of one variable on common axes, each a line of its own colour with its name in the legend:
///
///   y |~~~\__        lines end where a value is not finite and go on behind it; values outside the range are
///     |  __/ \       drawn on the border
///     |_/_____\__ x
struct CurveFigure {
  struct Curve {
    std::string name;
    std::vector<double> y;  ///< one for each x
    std::string colour;     ///< "": the next of the palette
    std::string dashes;     ///< as in SVG: "6 4"; "": drawn through
  };
  std::string title;
  std::string x_name;  ///< with unit: "incidence angle in °"
  std::string y_name;
  std::vector<double> x;  ///< ascending
  std::vector<Curve> curves;
  std::optional<Range> y_range;  ///< absent: all finite values
};

/// SVG Tiny 1.2 (see figure.h).
[[nodiscard]] std::string curveFigure(const CurveFigure& content);

}  // namespace report
