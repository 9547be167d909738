#include "metrics/samples/positive_ks_tests.h"

#include <algorithm>
#include <fmt/format.h>
#include <limits>

#include "core/error.h"
#include "metrics/samples/kolmogorov_smirnov.h"

namespace metrics {

PositiveKsTests positiveKsTests(std::span<const SamplePair> pairs, double alpha) {
  if (!(alpha > 0.0 && alpha < 1.0)) {
    throw core::InputError({.item = "alpha"}, fmt::format("is {}; a level of significance lies in (0, 1).", alpha),
                           "Usual is 0.05.");
  }
  PositiveKsTests result{.frequency = std::numeric_limits<double>::quiet_NaN(),
                         .rejected = 0,
                         .counted = 0,
                         .too_small = 0,
                         .heavy_ties = 0};
  for (const SamplePair& pair : pairs) {
    if (std::min(pair.simulated.effectiveN(), pair.measured.effectiveN()) < kSmallestKsSample) {
      ++result.too_small;
      continue;
    }
    const KolmogorovSmirnov test = kolmogorovSmirnovTest(pair);
    ++result.counted;
    if (test.p_value <= alpha) ++result.rejected;
    if (test.heavy_ties) ++result.heavy_ties;
  }
  if (result.counted > 0) {
    result.frequency = static_cast<double>(result.rejected) / static_cast<double>(result.counted);
  }
  return result;
}

}  // namespace metrics
