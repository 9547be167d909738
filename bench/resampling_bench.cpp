// How long intervals take on samples of the sizes of real measurements. Build with the release preset; run
// build/bin/resampling_bench. Bound: 1000 replicates of the double validation metric of 2 x 10^5 values in 3 s on 2
// cores.

#include <benchmark/benchmark.h>
#include <cstdint>
#include <vector>

#include "core/progress.h"
#include "core/random.h"
#include "metrics/area/double_validation_metric.h"
#include "metrics/resampling/bootstrap.h"

namespace {

std::vector<double> normalSample(std::uint32_t index, std::size_t n, double mean) {
  core::Random random({.seed = 1, .sample = index});
  std::vector<double> values(n);
  for (double& x : values) x = mean + 0.2 * random.normal();
  return values;
}

/// Units of `size` neighbouring values each: the detections of a frame.
std::vector<std::uint32_t> framesOf(std::size_t n, std::size_t size) {
  std::vector<std::uint32_t> frames(n);
  for (std::size_t i = 0; i < n; ++i) frames[i] = static_cast<std::uint32_t>(i / size);
  return frames;
}

void dvm(const metrics::Comparison& boxes, const metrics::SamplePair&, std::span<double> results) {
  const metrics::DoubleValidation both = metrics::doubleValidationMetric(boxes);
  results[0] = both.bias;
  results[1] = both.scatter;
}

void run(benchmark::State& state, const metrics::UnitComparison& samples, const metrics::BootstrapOptions& options) {
  core::SilentProgress progress;
  for (auto _ : state) {
    benchmark::DoNotOptimize(metrics::bootstrapIntervals(samples, 2, dvm, options, progress));
  }
}

void thousandReplicatesByDetection(benchmark::State& state) {
  const std::vector<double> simulated = normalSample(0, 100'000, 22.0);
  const std::vector<double> measured = normalSample(1, 100'000, 22.1);
  run(state, {.simulated = {{.values = simulated, .units = {}}}, .measured = {.values = measured, .units = {}}},
      {.replicates = 1000,
       .method = state.range(0) == 0 ? metrics::IntervalMethod::Percentile : metrics::IntervalMethod::BCa});
}
BENCHMARK(thousandReplicatesByDetection)->Arg(0)->Arg(1)->Unit(benchmark::kSecond)->UseRealTime();

void thousandReplicatesByFrame(benchmark::State& state) {
  const std::vector<double> simulated = normalSample(0, 100'000, 22.0);
  const std::vector<double> measured = normalSample(1, 100'000, 22.1);
  const std::vector<std::uint32_t> frames = framesOf(100'000, 100);
  run(state, {.simulated = {{.values = simulated, .units = frames}}, .measured = {.values = measured, .units = frames}},
      {.replicates = 1000, .block = static_cast<std::size_t>(state.range(0))});
}
BENCHMARK(thousandReplicatesByFrame)->Arg(1)->Arg(10)->Unit(benchmark::kSecond)->UseRealTime();

/// A p-box of 17 runs of 10000 values each.
void hundredReplicatesOfSeventeenRuns(benchmark::State& state) {
  const std::vector<double> measured = normalSample(0, 10'000, 22.1);
  std::vector<std::vector<double>> runs;
  for (std::uint32_t k = 1; k <= 17; ++k) runs.push_back(normalSample(k, 10'000, 22.0 + 0.01 * k));
  metrics::UnitComparison samples{.simulated = {}, .measured = {.values = measured, .units = {}}};
  for (const auto& values : runs) samples.simulated.push_back({.values = values, .units = {}});
  run(state, samples, {.replicates = 100});
}
BENCHMARK(hundredReplicatesOfSeventeenRuns)->Unit(benchmark::kSecond)->UseRealTime();

}  // namespace

BENCHMARK_MAIN();
