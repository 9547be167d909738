#pragma once

#include <QPalette>
#include <QString>

#include "proposals/gap_report.h"

namespace desktop {

/// A gap report as rich text: the verdict and what to bear in mind of it, where the gap lies, which causes were
/// weighed, how far it shrinks, the acceptance tests whose verdict flips (links `test:`), the next experiment.
[[nodiscard]] QString diagnosisText(const proposals::GapReport& report, const QPalette& palette);

/// What to do where no report is open.
[[nodiscard]] QString diagnosisHint(bool any_experiment, const QPalette& palette);

}  // namespace desktop
