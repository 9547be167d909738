#include "gap/unexplained/rest.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>

#include "gap/unexplained/periodic_law.h"
#include "gap/unexplained/residuals.h"
#include "gap/unexplained/shortest_law.h"
#include "gap/where/covariates.h"

namespace gap {

namespace {

constexpr std::size_t kKnots = 7;
constexpr double kLeastExplained = 0.3;  // on held-out cells, by a law that is told

using Row = ResidualTable::Row;
using Column = Eigen::VectorXd;

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

/// The shortest sum of functions, or a wave.
Law bestLaw(const Replay& replay, const std::vector<Covariate>& covariates, const ResidualTable& table,
            const CellsOfSamples& expected, const Residuals& fit, const Residuals& judge) {
  Law law = shortestLaw(replay, covariates, table, expected, fit, judge);
  std::optional<Law> wave = periodicLaw(covariates, fit, judge);
  if (!wave || wave->explained <= law.explained) return law;
  wave->measurand = table.measurand;
  wave->component = table.component;
  wave->unit = table.unit;
  return *std::move(wave);
}

/// Of squared residuals beyond noise, summed over tables.
struct Sums {
  double before = 0.0, left = 0.0, beyond_any = 0.0;
};

}  // namespace

bool Rest::isPlain() const {
  constexpr double kMost = 0.5;
  return std::any_of(laws.begin(), laws.end(), [](const Law& law) { return law.explained > kMost; });
}

void Rest::putFirst(std::vector<Law> first) {
  for (Law& law : laws) {
    const bool told = std::any_of(first.begin(), first.end(), [&](const Law& other) {
      return other.measurand == law.measurand && other.component == law.component;
    });
    if (!told) first.push_back(std::move(law));
  }
  laws = std::move(first);
}

double systematicallyLeft(const Rest& rest, const Candidate& cause) {
  return std::min({rest.belowCeiling(), 1.0 - cause.explained, cause.total_left});
}

std::optional<Rest> restOf(const Replay& replay, const Split& split, const WhereResult& before,
                           const WhereResult& after) {
  std::vector<Covariate> covariates = covariatesOf(replay, after.expected);
  // Set-ups differ between the two sides of the split. What a measurand is expected to be may well explain its
  // residual: both are simulated under different noise (covariatesOf).
  std::erase_if(covariates, [](const Covariate& covariate) { return covariate.name == "setup"; });
  Rest rest;
  Sums sums;
  for (const ResidualTable& table : after.tables) {
    const ResidualTable* as_it_was = sameOf(before.tables, table);
    if (!as_it_was) continue;
    Residuals was = residualsOf(replay, *as_it_was, split.held_out);
    Residuals fit = residualsOf(replay, table, split.fitted), judge = residualsOf(replay, table, split.held_out);
    was.floor = fit.floor = judge.floor = floorOf(*as_it_was);
    if (fit.rows.size() < kFewestRows || judge.rows.size() < kFewestRows) continue;
    const double left = judge.squares();
    sums.before += was.squares();
    sums.left += left;
    double beyond_any = std::min(left, judge.squares(AdditiveModel(covariates, fit).predict(judge.rows)));
    // Twice the spread of a sum of squares of standard normal numbers: less is noise.
    const bool noise = left < 2.0 * std::sqrt(2.0 * static_cast<double>(judge.rows.size()));
    Law law = noise ? Law{} : bestLaw(replay, covariates, table, after.expected, fit, judge);
    const bool told = law.explained >= kLeastExplained;
    if (told) beyond_any = std::min(beyond_any, (1.0 - law.explained) * left);
    sums.beyond_any += beyond_any;
    if (!told) continue;
    rest.laws.push_back(std::move(law));
  }
  if (sums.before <= 0.0) return std::nullopt;
  rest.left = sums.left / sums.before;
  rest.systematic = sums.left > 0.0 ? 1.0 - sums.beyond_any / sums.left : 0.0;
  std::stable_sort(rest.laws.begin(), rest.laws.end(),
                   [](const Law& a, const Law& b) { return a.explained > b.explained; });
  return rest;
}

bool leavesAPlainLaw(const Judge& judge, const WhereResult& before, const Candidate& cause) {
  if (std::min(1.0 - cause.explained, cause.total_left) < kLeftByAPlainLaw) return false;
  const World world = worldOf(judge.replay, cause.hypothesis, cause.values);
  const WhereResult after = whereIn(judge.replay, world, judge.split.fitted.seed);
  const std::optional<Rest> rest = restOf(judge.replay, judge.split, before, after);
  return rest && rest->isPlain() && systematicallyLeft(*rest, cause) >= kLeftByAPlainLaw;
}

}  // namespace gap
