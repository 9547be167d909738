#pragma once

#include <optional>
#include <vector>

#include "app/cli/metric/request.h"
#include "metrics/distributions/edf.h"
#include "metrics/distributions/p_box.h"

namespace app {

/// One column of one file.
struct ColumnValues {
  std::vector<double> values;
  std::vector<double> weights;  ///< empty: all alike
};

/// Both sides of one column as boxes and as pooled samples.
struct Boxes {
  metrics::PBox simulated;
  metrics::PBox measured;
  metrics::Edf pooled;           ///< all simulated runs, without boxes
  metrics::Edf measured_sample;  ///< without what is only known of it
};

/// Combines the runs and applies the margins and the confidence band that the request asks for. Takes the values.
/// Throws InputError if the runs do not fit the way in which they are to be combined.
[[nodiscard]] Boxes boxesOf(ColumnValues measured, std::vector<ColumnValues> runs, const MetricRequest& request);

}  // namespace app
