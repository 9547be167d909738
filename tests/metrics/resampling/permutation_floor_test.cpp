#include "metrics/resampling/permutation_floor.h"

#include <cmath>
#include <gtest/gtest.h>

#include "core/error.h"
#include "tests/metrics/random_cases.h"
#include "tests/metrics/resampling/normal_samples.h"

namespace {

using metrics::Edf;
using metrics::Floor;
using metrics::FloorOptions;
using metrics::NullDistribution;
using metrics::UnitComparison;
using metrics_test::normalGrid;
using metrics_test::normalSample;
using Values = std::vector<double>;
using Units = std::vector<std::uint32_t>;

Floor floorOf(const UnitComparison& samples, const FloorOptions& options = {}) {
  core::SilentProgress progress;
  return metrics::permutationFloor(samples, options, progress);
}

Floor samplingFloorOf(const Values& measured, const std::vector<std::size_t>& runs, const FloorOptions& options = {}) {
  core::SilentProgress progress;
  return metrics::samplingFloor({.values = measured, .units = {}}, runs, options, progress);
}

UnitComparison singles(const Values& simulated, const Values& measured) {
  return {.simulated = {{.values = simulated, .units = {}}}, .measured = {.values = measured, .units = {}}};
}

/// The floor by its definition: independent pairs of samples of N(0, 1).
Floor parametricFloor(std::size_t n, std::uint32_t pairs) {
  Values areas;
  Values scatters;
  for (std::uint32_t k = 0; k < pairs; ++k) {
    const metrics::PBox simulated = Edf(normalSample(50'000 + 2 * k, n));
    const metrics::PBox measured = Edf(normalSample(50'001 + 2 * k, n));
    areas.push_back(metrics::areaValidationMetric({.simulated = simulated, .measured = measured}));
    scatters.push_back(metrics::doubleValidationMetric({.simulated = simulated, .measured = measured}).scatter);
  }
  return {.area = NullDistribution(areas), .scatter = NullDistribution(scatters)};
}

void expectClose(const NullDistribution& floor, const NullDistribution& truth, double relative) {
  for (const double p : {0.1, 0.5, 0.9}) {
    EXPECT_NEAR(floor.quantile(p), truth.quantile(p), relative * truth.quantile(p)) << "level " << p;
  }
}

/// Floors of 40 pairs of samples of N(0, 1), 50 deals each, put together.
Floor floorOfNormals(std::size_t n) {
  Values areas;
  Values scatters;
  for (std::uint32_t k = 0; k < 40; ++k) {
    const Floor floor =
        floorOf(singles(normalSample(2 * k, n), normalSample(2 * k + 1, n)), {.replicates = 50, .seed = k});
    areas.insert(areas.end(), floor.area.ascending().begin(), floor.area.ascending().end());
    scatters.insert(scatters.end(), floor.scatter.ascending().begin(), floor.scatter.ascending().end());
  }
  return {.area = NullDistribution(areas), .scatter = NullDistribution(scatters)};
}

// By numpy: tests/data/metrics/resampling/floors.py. d_avm scatters by 40 % of itself, d_cavm by 30 %: means of 2000
// deals are good to 1 %; the scale of 40 pairs of n values to 1/sqrt(160 n), that is 1.5 % at n = 30.
TEST(PermutationFloor, IsWhatTwoSamplesOfOneNormalGive) {
  const Floor thirty = floorOfNormals(30);
  EXPECT_NEAR(thirty.area.mean(), 0.3101, 0.06 * 0.3101);
  EXPECT_NEAR(thirty.scatter.mean(), 0.2257, 0.06 * 0.2257);
  const Floor hundred = floorOfNormals(100);
  EXPECT_NEAR(hundred.area.mean(), 0.1757, 0.04 * 0.1757);
  EXPECT_NEAR(hundred.area.quantile(0.025), 0.0886, 0.1 * 0.0886);
  EXPECT_NEAR(hundred.area.quantile(0.975), 0.3361, 0.1 * 0.3361);
  EXPECT_NEAR(hundred.scatter.mean(), 0.1302, 0.04 * 0.1302);
  EXPECT_NEAR(hundred.scatter.quantile(0.025), 0.0750, 0.1 * 0.0750);
  EXPECT_NEAR(hundred.scatter.quantile(0.975), 0.2189, 0.1 * 0.2189);
  const Floor thousand = floorOfNormals(1000);
  EXPECT_NEAR(thousand.area.mean(), 0.0573, 0.04 * 0.0573);
  EXPECT_NEAR(thousand.scatter.mean(), 0.0428, 0.04 * 0.0428);
}

TEST(PermutationFloor, OfTheScatterIsFreeOfABias) {
  const Values measured = normalSample(1, 80);
  Values simulated = normalSample(2, 80);
  const Floor before = floorOf(singles(simulated, measured));
  for (double& x : simulated) x += 100.0;
  const Floor after = floorOf(singles(simulated, measured));
  EXPECT_NEAR(after.scatter.mean(), before.scatter.mean(), 1e-10);
  EXPECT_GT(after.area.mean(), 10.0 * before.area.mean());  // the area has no way to know that it is no scatter
}

// Under the null the p-value of a permutation test is uniform: of 300 pairs 10 % lie below 0.1 (deviation 1.7 %).
TEST(PermutationFloor, GivesUniformPValuesIfNothingIsWrong) {
  int rejected = 0;
  for (std::uint32_t k = 0; k < 300; ++k) {
    const Values simulated = normalSample(3000 + 2 * k, 25);
    const Values measured = normalSample(3001 + 2 * k, 20);
    const Floor floor = floorOf(singles(simulated, measured), {.replicates = 99, .seed = k});
    const double observed = metrics::areaValidationMetric({.simulated = Edf(simulated), .measured = Edf(measured)});
    rejected += metrics::permutationPValue(observed, floor.area) <= 0.1 ? 1 : 0;
  }
  EXPECT_NEAR(rejected / 300.0, 0.1, 0.06);
}

// All 20 deals of 3 + 3 values; the largest distance has the two deals that split them in the middle.
TEST(PermutationFloor, OfSixValuesHasTheChancesOfTwentyDeals) {
  const Floor floor = floorOf(singles({1.0, 2.0, 3.0}, {4.0, 5.0, 6.0}), {.replicates = 4000});
  EXPECT_NEAR(1.0 - floor.area.shareUpTo(2.99), 0.1, 4.0 * std::sqrt(0.09 / 4000.0));
  EXPECT_NEAR(metrics::permutationPValue(3.0, floor.area), 0.1, 0.02);
}

TEST(PermutationFloor, IsLowerForABoxThatExcuses) {
  const Values measured = normalSample(10, 50);
  std::vector<Values> runs;
  for (std::uint32_t k = 0; k < 8; ++k) runs.push_back(normalSample(11 + k, 50));
  UnitComparison box{.simulated = {}, .measured = {.values = measured, .units = {}}};
  for (const Values& run : runs) box.simulated.push_back({.values = run, .units = {}});
  EXPECT_LT(floorOf(box).area.mean(), 0.5 * floorOf(singles(runs[0], measured)).area.mean());
}

// Ten equal detections a frame: by detection the floor of 400 values, by frame that of 40.
TEST(PermutationFloor, ByFrameIsThatOfTheFrames) {
  Values simulated;
  Values measured;
  Units frames;
  const Values a = normalSample(20, 40);
  const Values b = normalSample(21, 40);
  for (std::uint32_t frame = 0; frame < 40; ++frame) {
    simulated.insert(simulated.end(), 10, a[frame]);
    measured.insert(measured.end(), 10, b[frame]);
    frames.insert(frames.end(), 10, frame);
  }
  const Floor by_frame = floorOf(
      {.simulated = {{.values = simulated, .units = frames}}, .measured = {.values = measured, .units = frames}});
  EXPECT_NEAR(by_frame.area.mean(), floorOf(singles(a, b)).area.mean(), 0.02);
  EXPECT_NEAR(by_frame.area.mean() / floorOf(singles(simulated, measured)).area.mean(), std::sqrt(10.0), 0.35);
}

TEST(PermutationFloor, NeedsARun) {
  const Values measured{1.0, 2.0};
  EXPECT_THROW((void)floorOf({.simulated = {}, .measured = {.values = measured, .units = {}}}), core::InputError);
  EXPECT_THROW((void)samplingFloorOf(measured, {}), core::InputError);
  EXPECT_THROW((void)samplingFloorOf(measured, {0}), core::InputError);
}

TEST(SamplingFloor, AgreesWithIndependentPairsOfSamples) {
  const Floor truth = parametricFloor(60, 1000);
  const Floor floor = samplingFloorOf(normalGrid(0.0, 1.0, 60), {60});
  expectClose(floor.area, truth.area, 0.12);
  expectClose(floor.scatter, truth.scatter, 0.12);
}

// Noise of both sides adds: sqrt(1/n + 1/m). With m = 9 n, sqrt(10 / 18) of the floor of m = n.
TEST(SamplingFloor, FallsWithTheSizeOfBothSides) {
  const Values measured = normalGrid(0.0, 1.0, 200);
  const double equal = samplingFloorOf(measured, {200}).area.mean();
  const double more = samplingFloorOf(measured, {1800}).area.mean();
  EXPECT_NEAR(more / equal, std::sqrt(10.0 / 18.0), 0.05);
}

TEST(SamplingFloor, DoesNotDependOnABadSimulation) {
  const Values measured = normalSample(30, 100, 0.0, 0.2);
  const Values too_wide = normalSample(31, 100, 0.0, 2.0);
  const Floor perfect = samplingFloorOf(measured, {100});
  EXPECT_GT(floorOf(singles(too_wide, measured)).scatter.mean(), 3.0 * perfect.scatter.mean());
  EXPECT_NEAR(perfect.scatter.mean(), 0.2 * 0.13, 0.006);
}

TEST(Attainable, IsAThresholdThatAPerfectModelPasses) {
  const NullDistribution floor({0.1, 0.2, 0.3, 0.4});
  EXPECT_FALSE(metrics::attainable(0.15, floor));
  EXPECT_TRUE(metrics::attainable(0.2, floor));
  EXPECT_FALSE(metrics::attainable(0.3, floor, 0.95));
  EXPECT_TRUE(metrics::attainable(0.4, floor, 0.95));
}

}  // namespace
