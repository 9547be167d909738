#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "gap/where/covariates.h"

namespace gap {

/// Standard errors: a smaller difference may be noise.
inline constexpr double kBeyondNoise = 2.0;

/// Statistics of every cell, [sample][cell].
using CellsOfSamples = std::vector<std::vector<CellStatistics>>;

/// Measured minus simulated of every cell, with everything that is known about it.
struct ResidualTable {
  struct Row : CellPlace {
    double value = 0.0;      ///< measured - simulated
    double error = 0.0;      ///< standard error
    double weight = 0.0;     ///< detections, or shots for existence
    std::uint32_t beam = 0;  ///< of existence: the places of one beam share its shots

    /// What of the residual its noise does not explain.
    [[nodiscard]] double beyondError() const;
  };
  std::string measurand;
  std::string component;
  std::string unit;
  double scale =
      1.0;  ///< one step of the total gap in this unit: the resolution; for existence a hundredth of the echoes
  std::vector<Row> rows;

  /// Whether it holds this component of this measurand.
  [[nodiscard]] bool isOf(const std::string& of_measurand, const std::string& of_component) const {
    return measurand == of_measurand && component == of_component;
  }
  /// Of what the component counts: missing echoes are residuals below 0, extra ones above; 0: of any sign.
  [[nodiscard]] double sign() const;
  /// How far noise alone moves the mean of a residual of this error: the tail of the other sign is cut off at
  /// kBeyondNoise, so what is left of a normal distribution has a mean of φ(kBeyondNoise) standard deviations.
  [[nodiscard]] double meanOfNoise(const Row& row) const;
  /// How many detections some of its rows stand for; of existence shots, each once, however many places of its beam are
  /// among them.
  [[nodiscard]] double weightOf(std::span<const Row* const> some) const;
  [[nodiscard]] double weight() const;  ///< of all rows
  /// Of the residuals, each beyond its error and with its weight.
  [[nodiscard]] double sumBeyondErrors() const;
  /// Mean size of the residuals beyond their errors, in scale units: how much there is to explain.
  [[nodiscard]] double excess() const;
  /// Size of the mean residual in scale units, if it stands out of what noise makes by five errors; else 0. Finds what
  /// is small in every cell but the same in all.
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

/// The same without the beams that an edge cuts.
[[nodiscard]] std::vector<ResidualTable> offEdges(const Replay& replay, std::vector<ResidualTable> tables);

/// The one of some tables that holds the same component of the same measurand; null if none does.
[[nodiscard]] const ResidualTable* sameOf(const std::vector<ResidualTable>& tables, const ResidualTable& table);

/// The measurand of the experiment that a channel carries.
[[nodiscard]] const model::Measurand& measurandOf(const Replay& replay, Channel channel);

}  // namespace gap
