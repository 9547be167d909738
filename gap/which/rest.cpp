#include "gap/which/rest.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <set>

#include "gap/replay/statistics.h"
#include "gap/where/covariates.h"

namespace gap {

namespace {

constexpr double kMostDeviation = 10.0;  // errors: no residual counts more
constexpr double kFloor = 0.1;           // of a table's median residual: nothing is sought below
constexpr std::size_t kMostRows = 12000;
constexpr std::size_t kFewestRows = 30;
constexpr std::size_t kKnots = 7;
constexpr double kRidge = 1e-3;  // of the mean diagonal
constexpr int kReweightings = 3;
constexpr double kHuber = 2.0;  // errors: residuals farther out pull no stronger than these
constexpr std::size_t kMostTerms = 2;
constexpr double kTermGain = 0.1;        // of what is to be explained: less does not earn a term
constexpr double kLeastExplained = 0.3;  // on held-out cells, by a law that is told
constexpr double kSteepest_deg = 85.0;

using Row = ResidualTable::Row;
using Column = Eigen::VectorXd;

/// Residuals of one table on one side of the split.
struct Residuals {
  std::vector<Row> rows;
  double floor = 0.0;  ///< added to every error

  [[nodiscard]] double error(const Row& row) const { return std::hypot(row.error, floor); }
  [[nodiscard]] Column values() const {
    Column column(static_cast<Eigen::Index>(rows.size()));
    for (std::size_t i = 0; i < rows.size(); ++i) column[static_cast<Eigen::Index>(i)] = rows[i].value;
    return column;
  }
  /// Squares beyond noise of what a prediction leaves.
  [[nodiscard]] double squares(const Column& predicted) const {
    double sum = 0.0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const double left = rows[i].value - predicted[static_cast<Eigen::Index>(i)];
      sum += std::min(kMostDeviation * kMostDeviation, std::pow(left / error(rows[i]), 2.0)) -
             std::pow(rows[i].error / error(rows[i]), 2.0);
    }
    return std::max(0.0, sum);
  }
  [[nodiscard]] double squares() const { return squares(Column::Zero(static_cast<Eigen::Index>(rows.size()))); }
};

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

double medianSize(const ResidualTable& table) {
  std::vector<double> sizes;
  for (const Row& row : table.rows) sizes.push_back(std::abs(row.value));
  return sizes.empty() ? 0.0 : medianOf(sizes);
}

/// Least squares, residuals far out reweighted (Huber 1964, Ann. Math. Stat. 35, 73).
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

std::vector<double> knotsOf(const Covariate& covariate, const std::vector<Row>& rows) {
  std::vector<double> values;
  for (const Row& row : rows) {
    if (const double x = covariate.number(row); std::isfinite(x)) values.push_back(x);
  }
  std::sort(values.begin(), values.end());
  std::vector<double> knots;
  for (std::size_t k = 0; k < kKnots && !values.empty(); ++k) {
    const double knot = values[k * (values.size() - 1) / (kKnots - 1)];
    if (knots.empty() || knot > knots.back() + 1e-9) knots.push_back(knot);
  }
  return knots;
}

/// Sum of piecewise linear functions of all covariates.
class AdditiveModel {
 public:
  AdditiveModel(const std::vector<Covariate>& covariates, const Residuals& residuals) {
    for (const Covariate& covariate : covariates) {
      Part part{&covariate, {}, {}};
      if (covariate.numeric) part.knots = knotsOf(covariate, residuals.rows);
      if (!covariate.numeric)
        for (const Row& row : residuals.rows) part.names.insert(covariate.text(row));
      if (part.knots.size() + part.names.size() > 1) parts_.push_back(std::move(part));
    }
    coefficients_ = fitted(features(residuals.rows), residuals);
  }

  [[nodiscard]] Column predict(const std::vector<Row>& rows) const { return features(rows) * coefficients_; }

 private:
  struct Part {
    const Covariate* covariate;
    std::vector<double> knots;
    std::set<std::string> names;
  };

  [[nodiscard]] Eigen::MatrixXd features(const std::vector<Row>& rows) const {
    Eigen::Index columns = 1;
    for (const Part& part : parts_) columns += static_cast<Eigen::Index>(part.knots.size() + part.names.size());
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(rows.size()), columns);
    matrix.col(0).setOnes();
    for (Eigen::Index r = 0; r < matrix.rows(); ++r) {
      Eigen::Index first = 1;
      for (const Part& part : parts_) {
        fill(part, rows[static_cast<std::size_t>(r)], matrix.row(r).segment(first, width(part)));
        first += width(part);
      }
    }
    return matrix;
  }
  static Eigen::Index width(const Part& part) {
    return static_cast<Eigen::Index>(part.knots.size() + part.names.size());
  }
  template <typename Segment>
  static void fill(const Part& part, const Row& row, Segment segment) {
    if (!part.covariate->numeric) {
      const auto name = part.names.find(part.covariate->text(row));
      if (name != part.names.end()) segment[std::distance(part.names.begin(), name)] = 1.0;
      return;
    }
    const double x = part.covariate->number(row);
    if (!std::isfinite(x)) return;
    const auto above = std::upper_bound(part.knots.begin(), part.knots.end(), x);
    const auto k = static_cast<Eigen::Index>(above - part.knots.begin());
    if (above == part.knots.begin() || above == part.knots.end()) {
      segment[above == part.knots.begin() ? 0 : k - 1] = 1.0;  // beyond the ends it stays as it is there
      return;
    }
    const double share = (x - *(above - 1)) / (*above - *(above - 1));
    segment[k - 1] = 1.0 - share;
    segment[k] = share;
  }

  std::vector<Part> parts_;
  Column coefficients_;
};

/// A function of one covariate that a law may have; NaN where it is not defined.
struct SimpleFunction {
  const char* name;
  double (*of)(double);
};

constexpr SimpleFunction kFunctions[] = {
    {"x", [](double x) { return x; }},
    {"x²", [](double x) { return x * x; }},
    {"1/x", [](double x) { return x > 0.0 ? 1.0 / x : NAN; }},
    {"ln x", [](double x) { return x > 0.0 ? std::log(x) : NAN; }},
};
constexpr SimpleFunction kOfIncidence = {"tan² x", [](double x) {
                                           const double slope = std::tan(x * std::numbers::pi / 180.0);
                                           return x < kSteepest_deg ? slope * slope : NAN;
                                         }};

/// A function of a covariate, its values standardised as on the fitted rows.
struct Feature {
  const Covariate* covariate;
  SimpleFunction function;
  double mean = 0.0;
  double spread = 1.0;

  [[nodiscard]] Column on(const std::vector<Row>& rows) const {
    Column column(static_cast<Eigen::Index>(rows.size()));
    for (std::size_t i = 0; i < rows.size(); ++i)
      column[static_cast<Eigen::Index>(i)] = (function.of(covariate->number(rows[i])) - mean) / spread;
    return column;
  }
};

/// Functions that are defined on all rows and not constant.
std::vector<Feature> featuresOf(const std::vector<Covariate>& covariates, const Residuals& fit,
                                const Residuals& judge) {
  std::vector<Feature> features;
  const auto offer = [&](const Covariate& covariate, const SimpleFunction& function) {
    Feature feature{&covariate, function};
    const Column values = feature.on(fit.rows);
    if (!values.allFinite() || !feature.on(judge.rows).allFinite()) return;
    feature.mean = values.mean();
    feature.spread = std::sqrt((values.array() - feature.mean).square().mean());
    if (feature.spread > 1e-9 * std::max(1.0, std::abs(feature.mean))) features.push_back(feature);
  };
  for (const Covariate& covariate : covariates) {
    if (!covariate.numeric) continue;
    for (const SimpleFunction& function : kFunctions) offer(covariate, function);
    if (covariate.name == "incidence_deg") offer(covariate, kOfIncidence);
  }
  return features;
}

Eigen::MatrixXd matrixOf(const std::vector<Feature>& features, const std::vector<Row>& rows) {
  Eigen::MatrixXd matrix(static_cast<Eigen::Index>(rows.size()), static_cast<Eigen::Index>(features.size()) + 1);
  matrix.col(0).setOnes();
  for (std::size_t f = 0; f < features.size(); ++f) matrix.col(static_cast<Eigen::Index>(f) + 1) = features[f].on(rows);
  return matrix;
}

Law lawOf(const std::vector<Feature>& chosen, const Column& coefficients) {
  Law law;
  law.constant = coefficients[0];
  for (std::size_t f = 0; f < chosen.size(); ++f) {
    const double coefficient = coefficients[static_cast<Eigen::Index>(f) + 1] / chosen[f].spread;
    law.constant -= coefficient * chosen[f].mean;
    law.terms.push_back({chosen[f].covariate->name, chosen[f].function.name, coefficient});
  }
  return law;
}

/// Forward selection on the fitted rows, judged on the others.
Law shortestLaw(const std::vector<Covariate>& covariates, const Residuals& fit, const Residuals& judge) {
  const std::vector<Feature> offered = featuresOf(covariates, fit, judge);
  std::vector<Feature> chosen;
  Column coefficients = fitted(matrixOf(chosen, fit.rows), fit);
  double left = fit.squares(matrixOf(chosen, fit.rows) * coefficients);
  const double worth_a_term = kTermGain * fit.squares();
  while (chosen.size() < kMostTerms) {
    std::vector<Feature> best;
    double least = left - worth_a_term;
    for (const Feature& feature : offered) {
      std::vector<Feature> tried = chosen;
      tried.push_back(feature);
      const Eigen::MatrixXd matrix = matrixOf(tried, fit.rows);
      const double now = fit.squares(matrix * fitted(matrix, fit));
      if (now >= least) continue;
      least = now;
      best = std::move(tried);
    }
    if (best.empty()) break;
    chosen = std::move(best);
    coefficients = fitted(matrixOf(chosen, fit.rows), fit);
    left = least;
  }
  Law law = lawOf(chosen, coefficients);
  law.explained = 1.0 - judge.squares(matrixOf(chosen, judge.rows) * coefficients) / std::max(1e-9, judge.squares());
  return law;
}

/// Of squared residuals beyond noise, summed over tables.
struct Sums {
  double before = 0.0, left = 0.0, beyond_any = 0.0;
};

}  // namespace

std::optional<Rest> restOf(const Replay& replay, const Split& split, const WhereResult& before,
                           const WhereResult& after) {
  std::vector<Covariate> covariates = covariatesOf(replay, after.expected);
  // Set-ups differ between the two sides of the split. What a measurand is expected to be may well explain its
  // residual: both are simulated under different noise (covariatesOf).
  std::erase_if(covariates, [](const Covariate& covariate) { return covariate.name == "setup"; });
  Rest rest;
  Sums sums;
  for (const ResidualTable& table : after.tables) {
    const auto as_it_was = std::find_if(before.tables.begin(), before.tables.end(), [&](const ResidualTable& t) {
      return t.measurand == table.measurand && t.component == table.component;
    });
    if (as_it_was == before.tables.end()) continue;
    const double floor = std::max(kFloor * medianSize(*as_it_was), 1e-12);
    Residuals was = residualsOf(replay, *as_it_was, split.held_out);
    Residuals fit = residualsOf(replay, table, split.fitted), judge = residualsOf(replay, table, split.held_out);
    was.floor = fit.floor = judge.floor = floor;
    if (fit.rows.size() < kFewestRows || judge.rows.size() < kFewestRows) continue;
    const double left = judge.squares();
    sums.before += was.squares();
    sums.left += left;
    sums.beyond_any += std::min(left, judge.squares(AdditiveModel(covariates, fit).predict(judge.rows)));
    // Twice the spread of a sum of squares of standard normal numbers: less is noise.
    if (left < 2.0 * std::sqrt(2.0 * static_cast<double>(judge.rows.size()))) continue;
    Law law = shortestLaw(covariates, fit, judge);
    if (law.explained < kLeastExplained) continue;
    law.measurand = table.measurand;
    law.component = table.component;
    law.unit = table.unit;
    rest.laws.push_back(std::move(law));
  }
  if (sums.before <= 0.0) return std::nullopt;
  rest.left = sums.left / sums.before;
  rest.systematic = sums.left > 0.0 ? 1.0 - sums.beyond_any / sums.left : 0.0;
  std::stable_sort(rest.laws.begin(), rest.laws.end(),
                   [](const Law& a, const Law& b) { return a.explained > b.explained; });
  return rest;
}

}  // namespace gap
