#pragma once

#include <vector>

#include "gap/candidates/candidates.h"
#include "gap/unexplained/law.h"
#include "gap/where/where.h"

namespace gap {

/// Plain functions of the beams' azimuth (shortest_law.h) that describe the deviations of the measurands' means with
/// fewer numbers than a cause does, or so much better that their further numbers are paid for: a gain that falls
/// towards the rim of the scan, of which a cloud or a dirty sector with enough numbers makes nearly as much. Judged by
/// held-out cells off edges, all tables together, as causes are told apart: every number costs four nats (Judge), and
/// the choice among all laws that were tried the logarithm of their number (Schwarz 1978, Ann. Stat. 6, 461).
///
/// Surfaces, distances and values are no covariates here: through these the causes of the library act, and two programs
/// differ along them. Nor is the elevation: a function of three numbers describes any gains of four layers, and uneven
/// layers are a cause of the library.
///
/// `before`: residuals of the model as it was brought, `after`: of the world with the cause. What describes most comes
/// first. Nothing if the laws are not so good, or the data have no directions.
[[nodiscard]] std::vector<Law> directionLawsIn(const Judge& judge, const Candidate& cause, const WhereResult& before,
                                               const WhereResult& after);

}  // namespace gap
