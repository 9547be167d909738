#pragma once

#include <Eigen/Dense>
#include <vector>

#include "gap/causes/split.h"
#include "gap/where/residual_tables.h"

namespace gap {

/// Residuals of one table on one side of the split, off edges. [unit of the table]
struct Residuals {
  std::vector<ResidualTable::Row> rows;
  double floor = 0.0;          ///< added to every error
  std::vector<double> scales;  ///< of every row, what a law's 1 stands for in the table's unit; empty: one unit

  [[nodiscard]] double error(const ResidualTable::Row& row) const;
  [[nodiscard]] Eigen::VectorXd values() const;
  /// Squares beyond noise of what a prediction leaves.
  [[nodiscard]] double squares(const Eigen::VectorXd& predicted) const;
  [[nodiscard]] double squares() const;
  /// Share of the squares beyond noise that a prediction takes.
  [[nodiscard]] double explainedBy(const Eigen::VectorXd& predicted) const;
};

/// Fewer tell nothing of what they depend on.
inline constexpr std::size_t kFewestRows = 30;

/// The floor of a table's residuals, a tenth of the median size of those that it held at first: nothing is sought
/// below.
[[nodiscard]] double floorOf(const ResidualTable& as_it_was);

/// Of the samples of `evidence`; some of them, evenly, where there are more than anybody needs.
[[nodiscard]] Residuals residualsOf(const Replay& replay, const ResidualTable& table, const Evidence& evidence);

/// Coefficients of the features (a column each) by least squares, residuals far out reweighted (Huber 1964, Ann. Math.
/// Stat. 35, 73).
[[nodiscard]] Eigen::VectorXd fitted(const Eigen::MatrixXd& features, const Residuals& residuals);

}  // namespace gap
