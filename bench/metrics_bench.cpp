// How long the metrics take on samples of the sizes of real measurements, beside what bounds them: one std::sort, one
// pass over the memory. Build with the release preset; run build/bin/metrics_bench, or bench/compare_with_python.py for
// the table of docs/metrics-speed.md.

#include <algorithm>
#include <benchmark/benchmark.h>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <optional>
#include <vector>

#include "core/random.h"
#include "metrics/area/double_validation_metric.h"
#include "metrics/area/largest_area_metric.h"
#include "metrics/samples/kolmogorov_smirnov.h"
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

  explicit Corners(double resolution, bool one_size = true) : measured(normalSample(0, 69'000, 22.0, resolution)) {
    for (std::uint32_t k = 1; k <= 17; ++k) {
      runs.push_back(normalSample(k, one_size ? 70'000 : 69'100 + 100 * k, 22.0 + 0.01 * k, resolution));
    }
  }
  [[nodiscard]] PBox box() const {
    std::vector<Edf> edfs;
    for (const auto& run : runs) edfs.emplace_back(run);
    return PBox::envelope(edfs);
  }
};

/// Resolution in mm: 0 continuous, 10 a counter of 1 cm.
double resolutionOf(const benchmark::State& state) { return 0.001 * static_cast<double>(state.range(0)); }

std::size_t sizeOf(const benchmark::State& state) { return static_cast<std::size_t>(state.range(0)); }

/// Ascending and without ties: no work is left but to read it.
std::vector<double> sortedSample(std::uint32_t index, std::size_t n, double mean) {
  std::vector<double> values = normalSample(index, n, mean);
  std::sort(values.begin(), values.end());
  for (std::size_t i = 1; i < n; ++i) values[i] = std::max(values[i], std::nextafter(values[i - 1], 1e300));
  return values;
}

void countBytes(benchmark::State& state) {
  state.SetBytesProcessed(state.iterations() * 2 * state.range(0) * static_cast<std::int64_t>(sizeof(double)));
}

/// The bound for unsorted samples.
void standardSort(benchmark::State& state) {
  const std::vector<double> values = normalSample(0, sizeOf(state), 22.0);
  for (auto _ : state) {
    state.PauseTiming();
    std::vector<double> copy = values;
    state.ResumeTiming();
    std::sort(copy.begin(), copy.end());
    benchmark::DoNotOptimize(copy.data());
  }
}
BENCHMARK(standardSort)->Arg(1'000'000)->Unit(benchmark::kMillisecond);

/// The bound for sorted samples: both arrays added up one value after the other.
void streamingSum(benchmark::State& state) {
  const std::vector<double> simulated = sortedSample(0, sizeOf(state), 22.0);
  const std::vector<double> measured = sortedSample(1, sizeOf(state), 22.1);
  for (auto _ : state) {
    benchmark::DoNotOptimize(std::accumulate(simulated.begin(), simulated.end(), 0.0));
    benchmark::DoNotOptimize(std::accumulate(measured.begin(), measured.end(), 0.0));
  }
  countBytes(state);
}
BENCHMARK(streamingSum)->Arg(1'000'000)->Arg(10'000'000)->Unit(benchmark::kMillisecond);

double sumOfLanes(const std::vector<double>& values) {
  double lanes[16] = {};
  for (std::size_t i = 0; i + 16 <= values.size(); i += 16) {
    for (std::size_t lane = 0; lane < 16; ++lane) lanes[lane] += values[i + lane];
  }
  return std::accumulate(std::begin(lanes), std::end(lanes), 0.0);
}

/// A stricter one: 16 sums side by side do not wait for each other's additions, only for the memory.
void streamingSumOfLanes(benchmark::State& state) {
  const std::vector<double> simulated = sortedSample(0, sizeOf(state), 22.0);
  const std::vector<double> measured = sortedSample(1, sizeOf(state), 22.1);
  for (auto _ : state) {
    benchmark::DoNotOptimize(sumOfLanes(simulated));
    benchmark::DoNotOptimize(sumOfLanes(measured));
  }
  countBytes(state);
}
BENCHMARK(streamingSumOfLanes)->Arg(1'000'000)->Arg(10'000'000)->Unit(benchmark::kMillisecond);

void portionsOfTwoEdfs(benchmark::State& state) {
  const Edf simulated(sortedSample(0, sizeOf(state), 22.0));
  const Edf measured(sortedSample(1, sizeOf(state), 22.1));
  for (auto _ : state) {
    benchmark::DoNotOptimize(metrics::areaPortions({.simulated = simulated, .measured = measured}));
  }
  countBytes(state);
}
BENCHMARK(portionsOfTwoEdfs)->Arg(1'000'000)->Arg(10'000'000)->Unit(benchmark::kMillisecond);

/// From values to portions; they are moved in.
void portions(benchmark::State& state, const std::vector<double>& simulated, const std::vector<double>& measured) {
  std::optional<Edf> first;
  std::optional<Edf> second;
  for (auto _ : state) {
    state.PauseTiming();
    std::vector<double> x = simulated;
    std::vector<double> y = measured;
    first.reset();
    second.reset();
    state.ResumeTiming();
    first.emplace(std::move(x));
    second.emplace(std::move(y));
    benchmark::DoNotOptimize(metrics::areaPortions({.simulated = *first, .measured = *second}));
  }
  countBytes(state);
}

void portionsOfUnsortedSamples(benchmark::State& state) {
  portions(state, normalSample(0, sizeOf(state), 22.0), normalSample(1, sizeOf(state), 22.1));
}
BENCHMARK(portionsOfUnsortedSamples)->Arg(1'000'000)->Unit(benchmark::kMillisecond);

void portionsOfSortedSamples(benchmark::State& state) {
  portions(state, sortedSample(0, sizeOf(state), 22.0), sortedSample(1, sizeOf(state), 22.1));
}
BENCHMARK(portionsOfSortedSamples)->Arg(1'000'000)->Arg(10'000'000)->Unit(benchmark::kMillisecond);

void edfOfSample(benchmark::State& state) {
  const std::vector<double> values = normalSample(0, sizeOf(state), 22.0);
  for (auto _ : state) benchmark::DoNotOptimize(Edf(values));
}
BENCHMARK(edfOfSample)->Arg(100'000)->Arg(1'000'000)->Unit(benchmark::kMillisecond);

/// From unsorted values to the distance, as scipy.stats.wasserstein_distance does.
void wassersteinOfTwoSamples(benchmark::State& state) {
  const std::vector<double> simulated = normalSample(0, sizeOf(state), 22.0);
  const std::vector<double> measured = normalSample(1, sizeOf(state), 22.1);
  for (auto _ : state) {
    benchmark::DoNotOptimize(metrics::wassersteinDistance({.simulated = Edf(simulated), .measured = Edf(measured)}));
  }
}
BENCHMARK(wassersteinOfTwoSamples)->Arg(100'000)->Arg(1'000'000)->Unit(benchmark::kMillisecond);

void kolmogorovSmirnovOfTwoSamples(benchmark::State& state) {
  const std::vector<double> simulated = normalSample(0, sizeOf(state), 22.0);
  const std::vector<double> measured = normalSample(1, sizeOf(state), 22.0);
  for (auto _ : state) {
    benchmark::DoNotOptimize(metrics::kolmogorovSmirnovTest({.simulated = Edf(simulated), .measured = Edf(measured)}));
  }
}
BENCHMARK(kolmogorovSmirnovOfTwoSamples)->Arg(100'000)->Unit(benchmark::kMillisecond);

/// From 17 + 1 unsorted samples to the area of the p-box.
void areaOfSeventeenRuns(benchmark::State& state) {
  const Corners corners(resolutionOf(state));
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        metrics::areaValidationMetric({.simulated = corners.box(), .measured = Edf(corners.measured)}));
  }
}
BENCHMARK(areaOfSeventeenRuns)->Arg(0)->Arg(10)->Unit(benchmark::kMillisecond);

/// No two of them of one size: the envelope walks levels.
void areaOfSeventeenSizes(benchmark::State& state) {
  const Corners corners(resolutionOf(state), false);
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        metrics::areaValidationMetric({.simulated = corners.box(), .measured = Edf(corners.measured)}));
  }
}
BENCHMARK(areaOfSeventeenSizes)->Arg(0)->Unit(benchmark::kMillisecond);

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
