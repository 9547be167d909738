#pragma once

#include <functional>
#include <string_view>
#include <vector>

namespace metrics {

/// What a metric compares: real and simulated samples of one measurand, series in step with each other, or what a
/// sensor gives at one of its interfaces.
enum class DataKind { Values, Series, PointCloud, RangeImage, OccupancyGrid, ObjectList, Tracks };

/// Scale of measurement that data must have at least for a metric to mean something. Source: Stevens 1946,
/// doi:10.1126/science.103.2684.677.
enum class Scale {
  Nominal,   ///< names: equal or not
  Ordinal,   ///< ranks: more or less
  Interval,  ///< differences have a meaning
  Ratio      ///< and so have quotients: there is a true zero
};

/// How a result is written: 0.1, [0.1, 0.2], or {"left": 0.1, "right": 0.2}.
enum class MetricShape { Number, List, Object };

enum class MetricUnit {
  Measurand,  ///< that of the compared values
  Square,     ///< its square
  Cells,      ///< edge of a grid cell
  Bit,
  None
};

/// What a reader must know of a metric before believing it.
struct MetricInfo {
  int number = 0;            ///< in Rosenberger 2022, Tab. 4-3; 0: not in it
  std::string_view name;     ///< in files and expressions
  std::string_view title;    ///< usual name in the literature
  std::string_view meaning;  ///< one line, no full stop
  std::string_view formula;  ///< plain text; x real, y simulated
  std::string_view best;     ///< value of two equal inputs
  std::string_view worst;
  MetricUnit unit = MetricUnit::Measurand;
  Scale scale = Scale::Interval;
  std::vector<DataKind> data;
  bool p_box = false;       ///< handles epistemic uncertainty
  bool on_request = false;  ///< too slow or too special to be computed unless it is named
  std::string_view source;  ///< author, year, doi or equation
  std::string_view meets;   ///< digits of the criteria for validation metrics (docs/metrics.md) that it meets: "1257"
};

/// A metric on one kind of data. Options it takes (orders, cut-offs) are part of the input.
template <typename Input>
struct MetricOf {
  MetricInfo info;
  MetricShape shape = MetricShape::Number;
  std::vector<std::string_view> parts;  ///< names of the results in order; empty for a number
  std::function<std::vector<double>(const Input& input)> compute;  ///< as many numbers as parts; NaN where undefined
};

}  // namespace metrics
