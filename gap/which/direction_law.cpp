#include "gap/which/direction_law.h"

#include <cmath>
#include <utility>
#include <vector>

#include "gap/where/covariates.h"
#include "gap/which/residuals.h"
#include "gap/which/shortest_law.h"

namespace gap {

namespace {

std::vector<Covariate> directionsOf(const Replay& replay, const CellsOfSamples& expected) {
  std::vector<Covariate> covariates = covariatesOf(replay, expected);
  std::erase_if(covariates, [](const Covariate& covariate) {
    return covariate.name != "azimuth_deg" && covariate.name != "elevation_deg";
  });
  return covariates;
}

}  // namespace

std::optional<Law> directionLawIn(const Judge& judge, const Candidate& cause, const WhereResult& before,
                                  const WhereResult& after) {
  const Replay& replay = judge.replay;
  const std::vector<Covariate> directions = directionsOf(replay, before.expected);
  Law best;
  double was = 0.0, left_by_cause = 0.0, taken_by_law = 0.0, tried = 0.0;
  for (const ResidualTable& table : before.tables) {
    const ResidualTable* with_cause = sameOf(after.tables, table);
    if (!with_cause) continue;
    Residuals fit = residualsOf(replay, table, judge.split.fitted);
    Residuals held_out = residualsOf(replay, table, judge.split.held_out);
    Residuals left = residualsOf(replay, *with_cause, judge.split.held_out);
    fit.floor = held_out.floor = left.floor = floorOf(table);
    if (fit.rows.size() < kFewestRows || held_out.rows.size() < kFewestRows) continue;
    was += held_out.squares();
    left_by_cause += left.squares();
    if (table.component != "bias") continue;
    Law law = shortestLaw(directions, table, before.expected, fit, held_out);
    ++tried;
    const double taken = law.explained * held_out.squares();
    if (law.terms.empty() || taken <= taken_by_law) continue;
    taken_by_law = taken;
    best = std::move(law);
  }
  if (best.terms.empty()) return std::nullopt;
  const double nearer_nats = 0.5 * (left_by_cause - (was - taken_by_law));
  const double more_numbers = 1.0 + static_cast<double>(best.terms.size()) - static_cast<double>(cause.values.size());
  const double price_nats = Judge::kNatsPerNumber * (more_numbers + 1.0) + std::log(tried);
  return nearer_nats < price_nats ? std::nullopt : std::optional(std::move(best));
}

}  // namespace gap
