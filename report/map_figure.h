#pragma once

#include <optional>
#include <string>
#include <vector>

namespace report {

/// A field of values over two coordinates, e.g. the residual over azimuth and layer:
///
///   layer 2 |##  ++|     each cell a rectangle around its centre; colours run from blue (negative) over white (zero)
///         1 |##  ++|     to red (positive), with a colour bar; cells without a value stay grey
///         0 |      |
///            azimuth
struct MapFigure {
  struct Cell {
    double x;
    double y;
    double value;  ///< NaN: nothing known there
  };
  std::string title;
  std::string x_name;  ///< with unit: "azimuth in °"
  std::string y_name;
  std::string value_name;    ///< at the colour bar: "EPW bias in m"
  double cell_width = 1.0;   ///< [unit of x]
  double cell_height = 1.0;  ///< [unit of y]
  std::vector<Cell> cells;
  /// Value at the ends of the colour bar; absent: the largest magnitude in 98 % of the cells.
  std::optional<double> full_scale;
  /// Azimuth grows to the left: the picture looks as the sensor sees the scene.
  bool x_grows_leftwards = false;
};

/// SVG Tiny 1.2 (see figure.h).
[[nodiscard]] std::string mapFigure(const MapFigure& map);

/// Colour of a value on the diverging scale, "#rrggbb"; -1 deep blue, 0 near white, 1 deep red, clamped. Blue and red
/// of equal magnitude are equally dark; people with any colour vision tell them apart.
[[nodiscard]] std::string divergingColour(double share);

}  // namespace report
