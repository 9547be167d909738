#pragma once

#include <functional>
#include <string>
#include <vector>

#include "gap/replay/replay.h"

namespace gap {

/// A cell of a sample.
struct CellPlace {
  std::size_t sample = 0;
  std::size_t cell = 0;
};

/// What may be known of a cell: a number, or a name.
struct Covariate {
  std::string name;
  bool numeric = true;
  std::function<double(const CellPlace&)> number;     ///< NaN where it is not known
  std::function<std::string(const CellPlace&)> text;  ///< of those that are not numeric
};

/// Everything that experiment and simulation know of the cells: range, direction, incidence angle, time in the frame,
/// object, material, sensor, set-up, the parameters of the sample, and the values that are expected there (measured
/// ones where nothing is). Pooled data know no geometry. `expected` is no simulation that residuals are taken from:
/// among values that scatter, those that came out high have residuals that came out high, too. The functions refer to
/// both arguments. [expected: sample][cell]
[[nodiscard]] std::vector<Covariate> covariatesOf(const Replay& replay,
                                                  const std::vector<std::vector<CellStatistics>>& expected);

}  // namespace gap
