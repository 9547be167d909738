#pragma once

#include <optional>
#include <vector>

#include "gap/unexplained/law.h"
#include "gap/unexplained/residuals.h"

namespace gap {

/// Frequencies that a wave over values of such a span is looked for with: from three periods in the span (what is
/// longer is a curve) up to `highest`, five hundred periods at most, a fifth of a period over the whole span apart.
[[nodiscard]] std::vector<double> frequenciesIn(double span, double highest);

/// The wave over distance or azimuth that takes most of the fitted residuals, judged on the others: errors of counters,
/// of phase measurements and of mirrors repeat themselves, and no smooth function follows them. The period is that of
/// the least squares of a sine with a constant (generalised Lomb-Scargle periodogram: Zechmeister & Kürster 2009, A&A
/// 496, 577), among those from a third of the values' span down to two steps between neighbours, and a five
/// hundredth of the span. Nothing if neither covariate is known, or one has too few values. Names neither measurand nor
/// unit.
[[nodiscard]] std::optional<Law> periodicLaw(const std::vector<Covariate>& covariates, const Residuals& fit,
                                             const Residuals& judge);

}  // namespace gap
