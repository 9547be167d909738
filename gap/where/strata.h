#pragma once

#include <string>
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

/// What a cause changes in a table, and how far that is: the residuals, free of noise, of a world that lacks the cause
/// against one that has it.
struct TableChange {
  ResidualTable table;
  double size = 0.0;
};

/// The best stratum of every covariate in every table: intervals of numeric covariates, sets of the others,
/// found by exhaustive search over adjacent quantile groups. p-values are corrected for all strata tried (Bonferroni)
/// and use beams, not single detections, as units. Tables come in the order of what a cause changes in them (`changes`,
/// if one is named), then of their gap; what may be chance comes after what may not. A cause that does not act
/// everywhere alike says where its strata end, for it has no noise; the table says what they hold. `expected` as in
/// covariates.h.
[[nodiscard]] std::vector<WhereRow> whereRows(const Replay& replay, const std::vector<ResidualTable>& tables,
                                              const CellsOfSamples& expected,
                                              const std::vector<TableChange>& changes = {});

}  // namespace gap
