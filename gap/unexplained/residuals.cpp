#include "gap/unexplained/residuals.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "gap/distance/discrepancy.h"
#include "gap/replay/statistics.h"

namespace gap {

namespace {

constexpr double kFloor = 0.1;           // of a table's median residual
constexpr double kMostDeviation = 10.0;  // errors: no residual counts more
constexpr std::size_t kMostRows = 12000;
constexpr double kRidge = 1e-3;  // of the mean diagonal
constexpr int kReweightings = 3;
constexpr double kHuber = 2.0;  // errors: residuals farther out pull no stronger than these

using Row = ResidualTable::Row;
using Column = Eigen::VectorXd;

}  // namespace

double Residuals::error(const Row& row) const { return std::hypot(row.error, floor); }

Column Residuals::values() const {
  Column column(static_cast<Eigen::Index>(rows.size()));
  for (std::size_t i = 0; i < rows.size(); ++i) column[static_cast<Eigen::Index>(i)] = rows[i].value;
  return column;
}

double Residuals::squares(const Column& predicted) const {
  double sum = 0.0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double left = rows[i].value - predicted[static_cast<Eigen::Index>(i)];
    sum += std::min(kMostDeviation * kMostDeviation, std::pow(left / error(rows[i]), 2.0)) -
           std::pow(rows[i].error / error(rows[i]), 2.0);
  }
  return std::max(0.0, sum);
}

double Residuals::squares() const { return squares(Column::Zero(static_cast<Eigen::Index>(rows.size()))); }

double Residuals::explainedBy(const Column& predicted) const {
  return 1.0 - squares(predicted) / std::max(1e-9, squares());
}

double floorOf(const ResidualTable& as_it_was) {
  constexpr double kLeast = 1e-12;
  std::vector<double> sizes;
  for (const Row& row : as_it_was.rows) sizes.push_back(std::abs(row.value));
  return sizes.empty() ? kLeast : std::max(kFloor * medianOf(sizes), kLeast);
}

Residuals residualsOf(const Replay& replay, const ResidualTable& table, const Evidence& evidence) {
  const std::set<std::size_t> samples(evidence.samples.begin(), evidence.samples.end());
  Residuals residuals;
  for (const Row& row : table.rows) {
    const ReplaySample& sample = replay.samples()[row.sample];
    const Cell& cell = sample.layout->cells()[row.cell];
    if (samples.contains(row.sample) && !cell.at_edge && row.weight > 0.0 && takesPart(sample, cell, evidence.part))
      residuals.rows.push_back(row);
  }
  const std::size_t step = 1 + residuals.rows.size() / kMostRows;
  std::vector<Row> some;
  for (std::size_t i = 0; i < residuals.rows.size(); i += step) some.push_back(residuals.rows[i]);
  residuals.rows = std::move(some);
  return residuals;
}

Column fitted(const Eigen::MatrixXd& features, const Residuals& residuals) {
  const Column values = residuals.values();
  Column weights(values.size()), coefficients = Column::Zero(features.cols());
  for (int round = 0; round < kReweightings; ++round) {
    const Column left = values - features * coefficients;
    for (Eigen::Index i = 0; i < weights.size(); ++i) {
      const double error = residuals.error(residuals.rows[static_cast<std::size_t>(i)]);
      const double far = round == 0 ? 0.0 : std::abs(left[i]) / error;
      weights[i] = (far > kHuber ? kHuber / far : 1.0) / (error * error);
    }
    const Eigen::MatrixXd weighted = features.transpose() * weights.asDiagonal();
    Eigen::MatrixXd normal = weighted * features;
    normal.diagonal().array() += kRidge * normal.trace() / static_cast<double>(normal.rows());
    coefficients = normal.ldlt().solve(weighted * values);
  }
  return coefficients;
}

}  // namespace gap
