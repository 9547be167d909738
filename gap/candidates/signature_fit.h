#pragma once

#include <vector>

#include "core/progress.h"
#include "gap/candidates/signatures.h"
#include "gap/causes/hypotheses.h"

namespace gap {

inline constexpr double kUsualSignatureStep = 0.02;

/// The values near `start` at which a cause shifts the data as the measurement is shifted, as nearly as it can: least
/// squares by Levenberg (1944, Q. Appl. Math. 2, 164) and Marquardt (1963, J. SIAM 11, 431) on signatures. Two causes
/// that all but cancel lie in a valley a few per cent wide, across all axes; this follows it, where a search along the
/// axes stands still. `step`, of each number's range, shows which way the shifts go.
[[nodiscard]] std::vector<double> signatureFitFrom(const Replay& replay, const SignatureSpace& space,
                                                   const Hypothesis& hypothesis, const std::vector<double>& start,
                                                   const core::Progress& progress, double step = kUsualSignatureStep);

/// What that fit makes small: squares of the shifts that a world leaves, far ones compressed.
[[nodiscard]] double shiftsLeftBy(const SignatureSpace& space, const World& world);

}  // namespace gap
