#pragma once

#include <optional>
#include <string>
#include <vector>

#include "report/map_figure.h"

namespace report {

/// Maps beside and below each other on one scale of colour, so that they can be compared:
///
///   bias, sample a        scatter, sample a       y of a cell is the number of its row, 0 at the bottom
///   1.2° |## ++|          1.2° |     |
///   0.4° |## ++|          0.4° |     |
///   bias, sample b        …
///        low |blue  white  red| high   ▒ no data      one colour bar below them all, with the meaning of its ends
struct PanelFigure {
  struct Panel {
    std::string title;
    std::vector<std::string> row_names;  ///< from the bottom; some are left out where there is no room
    std::vector<MapFigure::Cell> cells;  ///< NaN: no data
    double cell_width = 1.0;             ///< [unit of x]
  };
  std::string title;
  std::string x_name;         ///< with unit
  std::string y_name;         ///< with unit
  std::string value_name;     ///< under the colour bar, with unit
  std::string low_end;        ///< what blue means
  std::string high_end;       ///< what red means
  std::vector<Panel> panels;  ///< row by row, two in each
  bool x_grows_leftwards = false;
  /// Value at the ends of the colour bar; absent: the largest magnitude in 98 % of the cells of all panels.
  std::optional<double> full_scale;
};

/// SVG Tiny 1.2 (see figure.h).
[[nodiscard]] std::string panelFigure(const PanelFigure& content);

}  // namespace report
