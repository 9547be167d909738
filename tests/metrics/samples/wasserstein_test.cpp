#include "metrics/samples/wasserstein.h"

#include <cmath>
#include <gtest/gtest.h>

namespace {

using metrics::Edf;
using metrics::wassersteinDistance;

// scipy.stats.wasserstein_distance, examples of its documentation, scipy 1.10.1.
TEST(WassersteinDistance, ReproducesScipy) {
  const auto weighted = [](std::vector<double> x, std::vector<double> w) { return Edf::weighted(x, w); };
  EXPECT_DOUBLE_EQ(wassersteinDistance({.simulated = Edf({0.0, 1.0, 3.0}), .measured = Edf({5.0, 6.0, 8.0})}), 5.0);
  EXPECT_DOUBLE_EQ(wassersteinDistance(
                       {.simulated = weighted({0.0, 1.0}, {3.0, 1.0}), .measured = weighted({0.0, 1.0}, {2.0, 2.0})}),
                   0.25);
  EXPECT_NEAR(wassersteinDistance({.simulated = weighted({3.4, 3.9, 7.5, 7.8}, {1.4, 0.9, 3.1, 7.2}),
                                   .measured = weighted({4.5, 1.4}, {3.2, 3.5})}),
              4.078133143804786, 1e-14);
}

TEST(WassersteinDistance, FarFromZeroKeepsItsDigits) {
  const Edf measured({1e6, 1e6 + 1.0});
  EXPECT_NEAR(wassersteinDistance({.simulated = measured.shifted(0.125), .measured = measured}), 0.125, 1e-12);
}

}  // namespace
