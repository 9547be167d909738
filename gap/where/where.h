#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "gap/where/covariates.h"

namespace gap {

/// Standard errors: a smaller difference may be noise.
inline constexpr double kBeyondNoise = 2.0;

/// Statistics of every cell, [sample][cell].
using CellsOfSamples = std::vector<std::vector<CellStatistics>>;

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

  /// Of what the component counts: missing echoes are residuals below 0, extra ones above; 0: of any sign.
  [[nodiscard]] double sign() const;
  /// Mean size of the residuals beyond their errors, in scale units: how much there is to explain.
  [[nodiscard]] double excess() const;
  /// Size of the mean residual in scale units, if it stands out of its error by a factor of five; else 0. Finds what is
  /// small in every cell but the same in all.
  [[nodiscard]] double commonShift() const;
};

/// What `measured` and `simulated` stand for in residual tables, with the frames of every sample.
struct Sides {
  const CellsOfSamples& measured;
  std::vector<int> measured_frames;
  const CellsOfSamples& simulated;
  std::vector<int> simulated_frames;
};

/// Residuals of every channel (bias and scatter) and of existence.
[[nodiscard]] std::vector<ResidualTable> residualTables(const Replay& replay, const Sides& sides);

/// The measurand of the experiment that a channel carries.
[[nodiscard]] const model::Measurand& measurandOf(const Replay& replay, Channel channel);

/// In scale units, by measurand and component.
using SizeOfTables = std::map<std::pair<std::string, std::string>, double>;

/// The best stratum of every covariate in every table: intervals of numeric covariates, sets of the others,
/// found by exhaustive search over adjacent quantile groups. p-values are corrected for all strata tried (Bonferroni)
/// and use beams, not single detections, as units. Tables come in the order of `accounted_for` (what a cause changes in
/// them), then of their gap; what may be chance comes after what may not. `expected` as in covariates.h.
[[nodiscard]] std::vector<WhereRow> whereRows(const Replay& replay, const std::vector<ResidualTable>& tables,
                                              const CellsOfSamples& expected, const SizeOfTables& accounted_for = {});

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
  std::vector<ResidualTable> by_beam;  ///< the same with moved echoes as residuals (moved_echoes.h); the rows' tables
  CellsOfSamples expected;             ///< by the world, under other noise,
  std::vector<int> frames;             ///< in so many frames of every sample
  std::vector<Sector> sectors;         ///< that explain the residuals best (sectors.h)
  Gate gate;                           ///< that explains what is missing best (gate.h)
  double false_echoes_per_shot = 0.0;  ///< that no surface makes, more than the world expects
  double largest_steps = 0.0;  ///< largest deviation of a whole table or a significant stratum, in resolution steps
};
[[nodiscard]] WhereResult whereIn(const Replay& replay, const World& world, std::uint64_t seed);

/// The rows of a world that lacks a cause once that cause is known: what it changes most comes first, as both worlds
/// show it under the same noise. What it leaves as it is, however large, comes after that: two programs, or a second
/// fault, differ in other places.
[[nodiscard]] std::vector<WhereRow> rowsOfCause(const Replay& replay, const WhereResult& without,
                                                const WhereResult& with);

}  // namespace gap
