#pragma once

#include "gap/candidates.h"

namespace gap {

/// Whether a candidate brings the simulation nearer to held-out data than chance would, and whether anything is left.
/// Both worlds are simulated with the same random numbers, so what the candidate does not change cancels: small effects
/// show that the sum over all cells would hide in its noise.
struct Significance {
  double improvement_z = 0.0;  ///< of the gain of discrepancy, against measurements drawn from the baseline
  double p_value = 1.0;        ///< of such a gain by chance, of one candidate
  double rest_z = 0.0;         ///< of what is left, against measurements drawn from the candidate's own world
  /// As improvement_z, without the sample that gains most: a cause is in the sensor or in the reference of all, and
  /// what one sample alone shows may have happened there only. Of a single held-out sample, as improvement_z.
  double without_best_z = 0.0;
};

[[nodiscard]] Significance significanceOf(const Judge& judge, const Candidate& candidate);

/// The improvement_z of many candidates, from fewer measurements drawn: enough to see which to look at closely.
[[nodiscard]] std::vector<double> roughImprovements(const Judge& judge, const std::vector<Candidate>& candidates);

/// How much nearer to held-out data one candidate is than a rival, in standard deviations of that difference if the
/// first were right. Below two the data hardly tell them apart.
[[nodiscard]] double separation(const Judge& judge, const Candidate& best, const Candidate& rival);

}  // namespace gap
