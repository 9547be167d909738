#pragma once

#include <span>
#include <vector>

namespace metrics {

/// A share of the variance of a model's output, with the interval in which it lies by what the runs tell. Estimates
/// may leave [0, 1] by their error; they are not cut off.
struct SensitivityIndex {
  double value;  ///< NaN if the output does not vary
  double low;    ///< NaN if not known
  double high;
};

/// What one parameter does to the output. first <= total; they differ by interactions with other parameters.
struct ParameterSensitivity {
  SensitivityIndex first;  ///< share that would vanish if the parameter were known
  SensitivityIndex total;  ///< share that would remain if all others were known; 0: the parameter does nothing
};

struct SensitivityResult {
  double mean;                                   ///< of the output [its unit]
  double variance;                               ///< [its unit squared]
  std::vector<ParameterSensitivity> parameters;  ///< in the order of the plan
};

/// Throws InputError that names the row (from 1) of an output that is not finite.
void mustBeFinite(std::span<const double> outputs);

}  // namespace metrics
