#pragma once

#include <vector>

#include "gap/where/covariates.h"
#include "gap/where/residual_tables.h"
#include "gap/which/law.h"
#include "gap/which/residuals.h"

namespace gap {

/// Forward selection among simple functions of the covariates on the fitted rows, as in sparse regression of dynamics
/// (Brunton, Proctor & Kutz 2016, PNAS 113, 3932), judged on the others. In the table's unit or, if that explains more,
/// in parts of the value that is expected of a cell: a gain multiplies widths and intensities, but no ranges, and no
/// scatter of which most is noise.
[[nodiscard]] Law shortestLaw(const std::vector<Covariate>& covariates, const ResidualTable& table,
                              const CellsOfSamples& expected, const Residuals& fit, const Residuals& judge);

}  // namespace gap
