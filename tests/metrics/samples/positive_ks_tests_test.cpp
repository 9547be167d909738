#include "metrics/samples/positive_ks_tests.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numeric>

#include "core/error.h"
#include "core/random.h"

namespace {

using metrics::Edf;
using metrics::PositiveKsTests;
using metrics::positiveKsTests;
using metrics::SamplePair;

Edf ranks(int n, double first) {
  std::vector<double> values(static_cast<std::size_t>(n));
  std::iota(values.begin(), values.end(), first);
  return Edf(values);
}

TEST(PositiveKsTests, AreRejectionsOverPairsThatCount) {
  const Edf here = ranks(50, 0.0);
  const Edf near = ranks(50, 0.5);
  const Edf far = ranks(50, 1000.5);
  const Edf small = ranks(11, 1000.5);
  const std::vector<SamplePair> pairs = {{.simulated = near, .measured = here},
                                         {.simulated = far, .measured = here},
                                         {.simulated = small, .measured = here},
                                         {.simulated = here, .measured = small},
                                         {.simulated = far, .measured = near}};
  const PositiveKsTests tests = positiveKsTests(pairs);
  EXPECT_EQ(tests.counted, 3u);
  EXPECT_EQ(tests.rejected, 2u);
  EXPECT_EQ(tests.too_small, 2u);
  EXPECT_EQ(tests.heavy_ties, 0u);
  EXPECT_DOUBLE_EQ(tests.frequency, 2.0 / 3.0);
}

TEST(PositiveKsTests, TwelveValuesCountAndElevenDoNot) {
  const Edf twelve = ranks(12, 0.0);
  const Edf eleven = ranks(11, 0.5);
  const std::vector<SamplePair> pairs = {{.simulated = twelve, .measured = twelve},
                                         {.simulated = twelve, .measured = eleven}};
  EXPECT_EQ(positiveKsTests(pairs).counted, 1u);
  EXPECT_EQ(positiveKsTests(pairs).heavy_ties, 1u);  // a sample against itself
}

TEST(PositiveKsTests, OfNothingHaveNoFrequency) {
  EXPECT_TRUE(std::isnan(positiveKsTests({}).frequency));
  EXPECT_EQ(positiveKsTests({}).counted, 0u);
}

// The test at 5 % rejects 5 % of equal pairs. Stephens' p-value is right to some 0.2 % here; 1500 pairs have a standard
// error of 0.6 %.
TEST(PositiveKsTests, OfEqualDistributionsAreAboutAlpha) {
  core::Random random({.seed = 33});
  std::vector<Edf> samples;
  for (int k = 0; k < 3000; ++k) {
    std::vector<double> values(100);
    for (double& x : values) x = random.normal();
    samples.emplace_back(values);
  }
  std::vector<SamplePair> pairs;
  for (std::size_t k = 0; k < samples.size(); k += 2) {
    pairs.push_back({.simulated = samples[k], .measured = samples[k + 1]});
  }
  EXPECT_NEAR(positiveKsTests(pairs, 0.05).frequency, 0.05, 4 * 0.006 + 0.002);
}

TEST(PositiveKsTests, RefuseALevelOutsideZeroToOne) {
  for (const double alpha : {0.0, 1.0, -0.1, std::nan("")})
    EXPECT_THROW((void)positiveKsTests({}, alpha), core::InputError);
}

}  // namespace
