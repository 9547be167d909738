#pragma once

#include <vector>

#include "gap/which/law.h"
#include "gap/which/residuals.h"

namespace gap {

/// Forward selection among simple functions of the covariates on the fitted rows, as in sparse regression of dynamics
/// (Brunton, Proctor & Kutz 2016, PNAS 113, 3932), judged on the others. Names neither measurand nor unit.
[[nodiscard]] Law shortestLaw(const std::vector<Covariate>& covariates, const Residuals& fit, const Residuals& judge);

}  // namespace gap
