#pragma once

#include <optional>
#include <string>
#include <vector>

#include "metrics/distributions/comparison.h"

namespace report {

/// What an EDF figure says beside the curves.
struct EdfFigureText {
  std::string title;
  std::string quantity;  ///< "range", "echo pulse width"
  std::string unit;      ///< "m"
  /// Size of every simulated run that went into the box; its number is the number of runs.
  std::vector<std::size_t> simulated_n;
  /// One line under the title, e.g. "d_bias = -0.012 m (limit 0.050 m), d_CAVM = 0.004 m".
  std::string note;
  /// Largest |d_bias| that is accepted, in the measurand's unit: drawn around the mean of the measurement.
  std::optional<double> bias_limit;
};

/// Measurement against simulation on one axis:
///
///   1 |         ______---   EDF of the measurement; p-box of the simulation (both edges, filled between);
///     |   ___--|  __|       d+ and d- shaded in two colours that also differ in grey
///   0 |__|_____--|________
///       |-[  |  ]-----|     box plots (median, quartiles, whiskers to 1.5 interquartile ranges, diamond: mean);
///          |-[ | ]--|       of a p-box the outer quartiles, with median and mean as intervals
///
/// The axis spans all values unless a few outliers would squeeze the rest (they lie more than 1.5 times the range of
/// the middle 99 % away from it); the arrow at the border then says that the curve goes on. Any sample size gives a
/// picture of some ten kilobytes: steps below a tenth of a pixel are left out. Returns SVG Tiny 1.2 (see figure.h), the
/// same bytes for the same input.
[[nodiscard]] std::string edfFigure(const metrics::Comparison& boxes, const EdfFigureText& text);

}  // namespace report
