#pragma once

#include <iosfwd>
#include <nlohmann/json.hpp>
#include <string>

#include "app/cli/predict/point_boxes.h"

namespace app {

/// Part of "fidelis-predict" (docs/formats.md): each box by its name, with quantiles, mean and width.
[[nodiscard]] nlohmann::ordered_json toJson(const PointBoxes& at, const BoxRequest& request);

/// What a reader should know of the point.
struct BoxCaption {
  std::string where;  ///< "range_m=40"
  double level;       ///< of the bounds
};
/// For people: quantile intervals, one column a box.
void writeBoxTable(const PointBoxes& at, const BoxRequest& request, const BoxCaption& caption, std::ostream& out);

/// Which boxes there are not, why, and what to do.
void writeBoxRemarks(const PointBoxes& at, std::ostream& messages);

/// Both edges of every box as CSV: p, then left and right of each. Between one p and the next the edges stand at the
/// values of the row with the higher p: they are steps.
[[nodiscard]] std::string edgesAsCsv(const PointBoxes& at);

}  // namespace app
