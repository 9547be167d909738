#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "gap/where/residual_tables.h"

namespace gap {

/// A stratum of the measurement that holds a large part of the gap.
struct WhereRow {
  std::string measurand;  ///< a channel, or "existence"
  std::string component;  ///< "bias", "scatter", "missing" or "extra"
  std::string covariate;
  bool numeric = true;
  double low = 0.0;  ///< numeric covariates: [low, high]
  double high = 0.0;
  std::vector<std::string> names;  ///< the others
  double value = 0.0;              ///< measured minus simulated: mean, spread (standard deviation) or echoes per shot
  std::string unit;
  double share = 0.0;    ///< of this measurand's gap that lies in the stratum
  double size = 0.0;     ///< of the detections (shots) that lie in it
  double p_value = 1.0;  ///< corrected for the search
  double score = 0.0;    ///< by which rows of one measurand and component are ranked

  [[nodiscard]] bool mayBeChance() const { return p_value > 1e-3; }
};

/// Of tables, by measurand and component: in scale units, or as far as a cause changes them.
using SizeOfTables = std::map<std::pair<std::string, std::string>, double>;

/// The best stratum of every covariate in every table: intervals of numeric covariates, sets of the others,
/// found by exhaustive search over adjacent quantile groups. p-values are corrected for all strata tried (Bonferroni)
/// and use beams, not single detections, as units. Tables come in the order of `accounted_for` (what a cause changes in
/// them), then of their gap; what may be chance comes after what may not. `expected` as in covariates.h.
[[nodiscard]] std::vector<WhereRow> whereRows(const Replay& replay, const std::vector<ResidualTable>& tables,
                                              const CellsOfSamples& expected, const SizeOfTables& accounted_for = {});

}  // namespace gap
