// How long the metrics take on samples of the sizes of real measurements. Build with the release preset; run
// build/bin/metrics_bench. Sorting dominates a comparison of samples; everything after it is linear.

#include <benchmark/benchmark.h>
#include <cmath>
#include <cstdint>
#include <vector>

#include "core/random.h"
#include "metrics/area/double_validation_metric.h"
#include "metrics/area/largest_area_metric.h"
#include "metrics/samples/wasserstein.h"

namespace {

using metrics::Edf;
using metrics::PBox;

std::vector<double> normalSample(std::uint32_t index, std::size_t n, double mean, double resolution = 0.0) {
  core::Random random({.seed = 1, .sample = index});
  std::vector<double> values(n);
  for (double& x : values) {
    x = mean + 0.2 * random.normal();
    if (resolution > 0.0) x = resolution * std::round(x / resolution);
  }
  return values;
}

/// 17 simulated runs of 70000 values (a p-box of epistemic corners) and a measurement of 69000.
struct Corners {
  std::vector<std::vector<double>> runs;
  std::vector<double> measured;

  explicit Corners(double resolution) : measured(normalSample(0, 69'000, 22.0, resolution)) {
    for (std::uint32_t k = 1; k <= 17; ++k) runs.push_back(normalSample(k, 70'000, 22.0 + 0.01 * k, resolution));
  }
  [[nodiscard]] PBox box() const {
    std::vector<Edf> edfs;
    for (const auto& run : runs) edfs.emplace_back(run);
    return PBox::envelope(edfs);
  }
};

/// Resolution in mm: 0 continuous, 10 a counter of 1 cm.
double resolutionOf(const benchmark::State& state) { return 0.001 * static_cast<double>(state.range(0)); }

void edfOfSample(benchmark::State& state) {
  const std::vector<double> values = normalSample(0, static_cast<std::size_t>(state.range(0)), 22.0);
  for (auto _ : state) benchmark::DoNotOptimize(Edf(values));
}
BENCHMARK(edfOfSample)->Arg(100'000)->Arg(1'000'000)->Unit(benchmark::kMillisecond);

/// From unsorted values to the area, as scipy.stats.wasserstein_distance does.
void areaOfTwoSamples(benchmark::State& state) {
  const auto n = static_cast<std::size_t>(state.range(0));
  const std::vector<double> simulated = normalSample(0, n, 22.0);
  const std::vector<double> measured = normalSample(1, n, 22.1);
  for (auto _ : state) {
    benchmark::DoNotOptimize(metrics::areaValidationMetric({.simulated = Edf(simulated), .measured = Edf(measured)}));
  }
}
BENCHMARK(areaOfTwoSamples)->Arg(100'000)->Arg(1'000'000)->Unit(benchmark::kMillisecond);

void wassersteinOfTwoSamples(benchmark::State& state) {
  const auto n = static_cast<std::size_t>(state.range(0));
  const std::vector<double> simulated = normalSample(0, n, 22.0);
  const std::vector<double> measured = normalSample(1, n, 22.1);
  for (auto _ : state) {
    benchmark::DoNotOptimize(metrics::wassersteinDistance({.simulated = Edf(simulated), .measured = Edf(measured)}));
  }
}
BENCHMARK(wassersteinOfTwoSamples)->Arg(100'000)->Arg(1'000'000)->Unit(benchmark::kMillisecond);

/// From 17 + 1 unsorted samples to the area of the p-box.
void areaOfSeventeenRuns(benchmark::State& state) {
  const Corners corners(resolutionOf(state));
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        metrics::areaValidationMetric({.simulated = corners.box(), .measured = Edf(corners.measured)}));
  }
}
BENCHMARK(areaOfSeventeenRuns)->Arg(0)->Arg(10)->Unit(benchmark::kMillisecond);

void balancedShiftOfSeventeenRuns(benchmark::State& state) {
  const Corners corners(resolutionOf(state));
  const PBox box = corners.box();
  const PBox measured = Edf(corners.measured);
  for (auto _ : state) benchmark::DoNotOptimize(metrics::balancedShift({.simulated = box, .measured = measured}));
}
BENCHMARK(balancedShiftOfSeventeenRuns)->Arg(0)->Arg(10)->Unit(benchmark::kMillisecond);

void largestAreaOfSeventeenRuns(benchmark::State& state) {
  const Corners corners(resolutionOf(state));
  const PBox box = corners.box();
  const PBox measured = Edf(corners.measured).shifted(0.1);  // crosses the box: the search is needed
  for (auto _ : state) benchmark::DoNotOptimize(metrics::largestAreaMetric({.simulated = box, .measured = measured}));
  state.counters["error_m"] = metrics::largestAreaMetric({.simulated = box, .measured = measured}).error;
}
BENCHMARK(largestAreaOfSeventeenRuns)->Arg(0)->Arg(10)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
