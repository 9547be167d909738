#pragma once

#include <optional>

#include "gap/where/where.h"
#include "gap/which/candidates.h"
#include "gap/which/law.h"

namespace gap {

/// A plain function of the beams' azimuth or elevation (shortest_law.h) that describes the deviation of one measurand's
/// mean with fewer numbers than a cause does, or so much better that its further numbers are paid for: a gain that
/// falls towards the rim of the scan, of which a cloud or a dirty sector with enough numbers makes nearly as much.
/// Judged by held-out cells off edges, all tables together, as causes are told apart: every number costs four nats
/// (Judge), and so does the choice among all laws that were tried, its logarithm (Schwarz 1978, Ann. Stat. 6, 461).
///
/// Surfaces, distances and values are no covariates here: through these the causes of the library act, and two programs
/// differ along them.
///
/// `before`: residuals of the model as it was brought, `after`: of the world with the cause. Nothing if no law is so
/// good, or the data have no directions.
[[nodiscard]] std::optional<Law> directionLawIn(const Judge& judge, const Candidate& cause, const WhereResult& before,
                                                const WhereResult& after);

}  // namespace gap
