#pragma once

#include <string>
#include <vector>

#include "metrics/sensitivity/sensitivity_plan.h"

namespace app {

/// Names and ranges (formats.md, fidelis-parameters).
[[nodiscard]] std::vector<metrics::UncertainParameter> readParameters(const std::string& file);

/// One line a run: block, curve, and the value of each parameter.
void writeDesign(const std::string& file, const metrics::SensitivityPlan& plan);

/// The shape of a plan from its file: method, names of parameters, n and curves; what indices are computed with needs
/// no values. Throws InputError with the line if the rows are not those of a whole design in its order.
[[nodiscard]] metrics::SensitivityPlan readDesign(const std::string& file);

}  // namespace app
