#include "gap/unexplained/direction_laws.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "gap/unexplained/residuals.h"
#include "gap/unexplained/shortest_law.h"
#include "gap/where/covariates.h"

namespace gap {

namespace {

constexpr double kNatsPerSquare = 0.5;

/// A law of one measurand's mean, and how many of the squared residuals beyond noise it takes on held-out cells.
struct Taken {
  Law law;
  double squares = 0.0;

  [[nodiscard]] double numbers() const { return 1.0 + static_cast<double>(law.terms.size()); }
  [[nodiscard]] bool pays() const {
    return !law.terms.empty() && kNatsPerSquare * squares > Judge::kNatsPerNumber * numbers();
  }
};

/// A bound of what chance makes of the difference of two sums of z²: its standard error if both were noise alone, and
/// not the same, Var χ²(n) = 2n. Means are compared under the same noise; how values scatter about other means is not.
double byChance(const Residuals& a, const Residuals& b) {
  return std::sqrt(2.0 * static_cast<double>(a.rows.size() + b.rows.size()));
}

std::vector<Covariate> directionsOf(const Replay& replay, const CellsOfSamples& expected) {
  std::vector<Covariate> covariates = covariatesOf(replay, expected);
  std::erase_if(covariates, [](const Covariate& covariate) { return covariate.name != "azimuth_deg"; });
  return covariates;
}

}  // namespace

std::vector<Law> directionLawsIn(const Judge& judge, const Candidate& cause, const WhereResult& before,
                                 const WhereResult& after) {
  const Replay& replay = judge.replay;
  const std::vector<Covariate> directions = directionsOf(replay, before.expected);
  std::vector<Taken> laws;
  double more_left_by_cause = 0.0, more_numbers = -static_cast<double>(cause.values.size()), tried = 0.0;
  for (const ResidualTable& table : before.tables) {
    const ResidualTable* with_cause = sameOf(after.tables, table);
    if (!with_cause) continue;
    Residuals fit = residualsOf(replay, table, judge.split.fitted);
    Residuals held_out = residualsOf(replay, table, judge.split.held_out);
    Residuals left = residualsOf(replay, *with_cause, judge.split.held_out);
    fit.floor = held_out.floor = left.floor = floorOf(table);
    if (fit.rows.size() < kFewestRows || held_out.rows.size() < kFewestRows) continue;
    const double more_left = left.squares() - held_out.squares();
    if (table.component == "bias" || std::abs(more_left) > byChance(held_out, left)) more_left_by_cause += more_left;
    if (table.component != "bias") continue;
    Taken taken{shortestLaw(replay, directions, table, before.expected, fit, held_out)};
    taken.squares = taken.law.explained * held_out.squares();
    ++tried;
    if (!taken.pays()) continue;
    more_left_by_cause += taken.squares;
    more_numbers += taken.numbers();
    laws.push_back(std::move(taken));
  }
  const double price_nats = Judge::kNatsPerNumber * (more_numbers + 1.0) + std::log(std::max(1.0, tried));
  if (laws.empty() || kNatsPerSquare * more_left_by_cause < price_nats) return {};
  std::stable_sort(laws.begin(), laws.end(), [](const Taken& a, const Taken& b) { return a.squares > b.squares; });
  std::vector<Law> told;
  for (Taken& taken : laws) told.push_back(std::move(taken.law));
  return told;
}

}  // namespace gap
