#pragma once

#include <optional>
#include <string>
#include <vector>

#include "gap/where/covariates.h"

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

/// Measured minus simulated of every cell, with everything that is known about it.
struct ResidualTable {
  struct Row : CellPlace {
    double value = 0.0;   ///< measured - simulated
    double error = 0.0;   ///< standard error
    double weight = 0.0;  ///< detections, or shots for existence
  };
  std::string measurand;
  std::string component;
  std::string unit;
  double scale =
      1.0;  ///< one step of the total gap in this unit: the resolution; for existence a hundredth of the echoes
  std::vector<Row> rows;

  /// Mean size of the residuals beyond their errors, in scale units: how much there is to explain.
  [[nodiscard]] double excess() const;
  /// Size of the mean residual in scale units, if it stands out of its error by a factor of five; else 0. Finds what is
  /// small in every cell but the same in all.
  [[nodiscard]] double commonShift() const;
};

/// Residuals of every channel (bias and scatter) and of existence.
[[nodiscard]] std::vector<ResidualTable> residualTables(const Replay& replay,
                                                        const std::vector<std::vector<CellStatistics>>& simulated,
                                                        const std::vector<int>& simulated_frames);

/// The best stratum of every covariate in every table, best first: intervals of numeric covariates, sets of the others,
/// found by exhaustive search over adjacent quantile groups. p-values are corrected for all strata tried (Bonferroni)
/// and use beams, not single detections, as units. What may be chance comes after what may not. `expected` as in
/// covariates.h.
[[nodiscard]] std::vector<WhereRow> whereRows(const Replay& replay, const std::vector<ResidualTable>& tables,
                                              const std::vector<std::vector<CellStatistics>>& expected);

/// Azimuths from one to another.
struct Sector {
  double from_deg = 0.0;
  double to_deg = 0.0;
};

/// The ranges at which the loss of expected echoes begins: what a gate of the receiver would do. [m]
struct Gate {
  std::optional<double> opens_m;   ///< nearer, more echoes are lost than are there; nothing if it is so nowhere
  std::optional<double> closes_m;  ///< the same beyond
};

/// Where a world differs from the measurement, the reference settled within its tolerance.
struct WhereResult {
  std::vector<WhereRow> rows;
  std::vector<ResidualTable> tables;
  std::vector<std::vector<CellStatistics>> expected;  ///< by the world, under other noise; [sample][cell]
  std::vector<Sector> sectors;                        ///< that explain the residuals best (sectors.h)
  Gate gate;                                          ///< that explains what is missing best (gate.h)
  double largest_steps = 0.0;  ///< largest deviation of a whole table or a significant stratum, in resolution steps
};
[[nodiscard]] WhereResult whereIn(const Replay& replay, const World& world, std::uint64_t seed);

}  // namespace gap
