#pragma once

#include <vector>

#include "gap/unexplained/law.h"
#include "gap/unexplained/residuals.h"
#include "gap/where/covariates.h"
#include "gap/where/residual_tables.h"

namespace gap {

/// Forward selection among simple functions of the covariates on the fitted rows, as in sparse regression of dynamics
/// (Brunton, Proctor & Kutz 2016, PNAS 113, 3932), judged on the others. In the table's unit or, of the means of echo
/// pulse widths and intensities if that explains more, in parts of the received power: a gain multiplies intensities I
/// and widens pulses E by (c·FWHM)² / (2 ln 2 E) of its logarithm (formats.md section 3, step 6).
[[nodiscard]] Law shortestLaw(const Replay& replay, const std::vector<Covariate>& covariates,
                              const ResidualTable& table, const CellsOfSamples& expected, const Residuals& fit,
                              const Residuals& judge);

}  // namespace gap
