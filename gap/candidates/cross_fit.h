#pragma once

#include "gap/candidates/significance.h"

namespace gap {

/// Proof of a cause by all samples, though none judges values that were fitted to it: what was held out judges the fit,
/// and what was fitted judges another fit, from scratch, to what was held out (cross-fitting; Wasserman, Ramdas &
/// Balakrishnan 2020, PNAS 117, 16880). A cause that acts in every set-up gains twice. One that fits noise does not: of
/// one number, with a and b the standard scores of its best value in either half, the joint score of the two gains is
/// 2ab/sqrt(a² + b²), which is standard normal if a and b are.
class CrossFit {
 public:
  /// `quick` sees some of the beams and finds the values to begin with; `runs` of the null.
  CrossFit(const Judge& quick, const Judge& exact, std::size_t runs);

  /// Whether a hypothesis can be fitted to some samples and judged by others at all.
  [[nodiscard]] static bool applies(const Judge& judge, const Hypothesis& hypothesis);
  /// What the hypothesis gains on the samples that were fitted, itself fitted to those that were held out.
  [[nodiscard]] NullRuns::Gains gainsOf(const Hypothesis& hypothesis, const core::Progress& progress) const;

 private:
  const Judge& quick_;
  const Judge& exact_;
  Split exchanged_;
  NullRuns nulls_;
};

}  // namespace gap
