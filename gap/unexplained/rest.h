#pragma once

#include <optional>
#include <vector>

#include "gap/candidates/candidates.h"
#include "gap/unexplained/law.h"
#include "gap/where/where.h"

namespace gap {

/// What a world leaves unexplained, and how much of that could be explained by anything that depends on the covariates.
struct Rest {
  double left = 0.0;        ///< of the gap's squared residuals beyond noise, on held-out cells
  double systematic = 0.0;  ///< of what is left: follows functions of the covariates, on held-out cells
  std::vector<Law> laws;    ///< best first

  /// Share of the gap that the world and a function of the covariates explain together.
  [[nodiscard]] double ceiling() const { return 1.0 - left * (1.0 - systematic); }
  /// How much less of the gap the world explains by itself.
  [[nodiscard]] double belowCeiling() const { return left * systematic; }
  /// Whether a law says more than half of what is left of a measurand: no function with many numbers is needed, as for
  /// what two programs differ in.
  [[nodiscard]] bool isPlain() const;
  /// Laws in place of those that were found for the same components, before all others.
  void putFirst(std::vector<Law> first);
};

/// Of the gap, what a cause leaves that follows something, by the measure that sees least of it: of the rest, of the
/// discrepancy or of the total gap.
[[nodiscard]] double systematicallyLeft(const Rest& rest, const Candidate& cause);

/// Of the gap: so much that follows a plain law is left by what is not the cause, or not the only one.
inline constexpr double kLeftByAPlainLaw = 0.05;

/// `before`: residuals of the model as it was brought, `after`: of the world in question.
///
/// The ceiling is an additive model (Hastie & Tibshirani 1990, Generalized Additive Models, ch. 4): a sum of piecewise
/// linear functions, one for each covariate, fitted by penalised least squares to the residuals of the fitted samples.
/// The laws are the shortest sum of simple functions (shortest_law.h) or a wave (periodic_law.h), whichever explains
/// more; where a law explains more than the additive model does, it is the ceiling. All are judged by the held-out
/// samples only. Beams at edges take no part: two programs never agree there.
///
/// Nothing if too few cells off edges can be compared to say anything.
[[nodiscard]] std::optional<Rest> restOf(const Replay& replay, const Split& split, const WhereResult& before,
                                         const WhereResult& after);

/// Whether a cause leaves so much that follows a plain law. A regression over all cells shows that where their sum is
/// no more than noise. `before` as in restOf.
[[nodiscard]] bool leavesAPlainLaw(const Judge& judge, const WhereResult& before, const Candidate& cause);

}  // namespace gap
