#include "metrics/resampling/box_width_floor.h"

#include <gtest/gtest.h>

#include "core/error.h"
#include "tests/metrics/random_cases.h"
#include "tests/metrics/resampling/normal_samples.h"

namespace {

using metrics::NullDistribution;
using metrics::UnitSample;
using metrics_test::normalGrid;
using metrics_test::normalSample;
using Values = std::vector<double>;

NullDistribution floorOf(const std::vector<Values>& runs, std::size_t replicates = 200) {
  std::vector<UnitSample> samples;
  for (const Values& run : runs) samples.push_back({.values = run, .units = {}});
  core::SilentProgress progress;
  return metrics::boxWidthFloor(samples, {.replicates = replicates}, progress);
}

/// K runs of n values, together a noise-free normal sample.
std::vector<Values> parts(std::size_t runs, std::size_t n) {
  const Values grid = normalGrid(0.0, 1.0, static_cast<int>(runs * n));
  std::vector<Values> all(runs);
  for (std::size_t i = 0; i < grid.size(); ++i) all[i % runs].push_back(grid[i]);
  return all;
}

// By numpy: tests/data/metrics/resampling/floors.py; its own means are good to 1 %, ours of 200 deals to 2 %.
TEST(BoxWidthFloor, IsThatOfIdenticalNormals) {
  EXPECT_NEAR(floorOf(parts(17, 100)).mean(), 0.568, 0.03 * 0.568);
  EXPECT_NEAR(floorOf(parts(17, 1000)).mean(), 0.183, 0.03 * 0.183);
  EXPECT_NEAR(floorOf(parts(3, 100)).mean(), 0.263, 0.07 * 0.263);
  EXPECT_NEAR(floorOf(parts(3, 1000)).mean(), 0.0855, 0.07 * 0.0855);
}

TEST(BoxWidthFloor, IsFarExceededByRunsThatDiffer) {
  const std::vector<Values> runs{normalSample(1, 100, 0.0), normalSample(2, 100, 1.0), normalSample(3, 100, 2.0)};
  const std::vector<metrics::Edf> edfs{metrics::Edf(runs[0]), metrics::Edf(runs[1]), metrics::Edf(runs[2])};
  const double width = metrics::PBox::envelope(edfs).area();
  EXPECT_DOUBLE_EQ(metrics::permutationPValue(width, floorOf(runs)), 1.0 / 201.0);
}

TEST(BoxWidthFloor, OfRunsOfOneNumberIsZero) {
  EXPECT_EQ(floorOf({{2.0, 2.0}, {2.0}, {2.0, 2.0, 2.0}}).quantile(0.99), 0.0);
}

// Two runs of one value each: always the same box.
TEST(BoxWidthFloor, OfTwoNumbersIsTheirDistance) {
  EXPECT_EQ(floorOf({{1.0}, {4.0}}).quantile(0.01), 3.0);
  EXPECT_EQ(floorOf({{1.0}, {4.0}}).quantile(0.99), 3.0);
}

TEST(BoxWidthFloor, NeedsTwoRuns) { EXPECT_THROW((void)floorOf({{1.0, 2.0}}), core::InputError); }

}  // namespace
