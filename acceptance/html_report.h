#pragma once

#include <string>

#include "acceptance/result.h"

namespace acceptance {

/// The run as one self-contained HTML page (report/page.h): a table of verdicts; per test its requirement, expression,
/// value against limit of each sample, EDF figures, and the files with their hashes. A banner names the experiments
/// whose measurements are synthetic. Same result, same bytes.
[[nodiscard]] std::string htmlReport(const RunResult& run);

}  // namespace acceptance
