#include "metrics/resampling/permutation_floor.h"

#include <algorithm>
#include <fmt/format.h>
#include <utility>
#include <vector>

#include "core/error.h"
#include "metrics/area/area_metric.h"
#include "metrics/resampling/exchange.h"
#include "metrics/resampling/replicated.h"
#include "metrics/resampling/sorted_units.h"

namespace metrics {

namespace {

void mustHaveRuns(std::size_t runs) {
  if (runs > 0) return;
  throw core::InputError({}, "no simulated run; a floor is one of two sides.", "Give at least one simulated sample.");
}

/// Measurement first, then the runs.
std::vector<UnitSample> sidesOf(const UnitComparison& samples) {
  std::vector<UnitSample> sides{samples.measured};
  sides.insert(sides.end(), samples.simulated.begin(), samples.simulated.end());
  return sides;
}

double biasOf(const UnitComparison& samples, Shift shift) {
  const auto edfOf = [](const UnitSample& sample) {
    return Edf(std::vector<double>(sample.values.begin(), sample.values.end()));
  };
  std::vector<Edf> runs;
  for (const UnitSample& run : samples.simulated) runs.push_back(edfOf(run));
  return doubleValidationMetric({.simulated = PBox::envelope(runs), .measured = edfOf(samples.measured)}, shift).bias;
}

/// A measured sample, then its runs, as a comparison.
template <typename Figure>
auto figureOf(std::vector<Edf> sides, Figure figure) {
  const PBox measured = std::move(sides.front());
  const PBox simulated = PBox::envelope(std::span(sides).subspan(1));
  return figure(Comparison{.simulated = simulated, .measured = measured});
}

}  // namespace

Floor permutationFloor(const UnitComparison& samples, const FloorOptions& options, core::Progress& progress) {
  mustHaveRuns(samples.simulated.size());
  const std::vector<UnitSample> sides = sidesOf(samples);
  std::vector<double> shifts(sides.size(), 0.0);
  const Exchange as_they_are(sides, shifts);
  std::fill(shifts.begin() + 1, shifts.end(), -biasOf(samples, options.shift));
  const Exchange aligned(sides, shifts);

  const auto scatter = [&](const Comparison& boxes) { return doubleValidationMetric(boxes, options.shift).scatter; };
  core::PartOfProgress first(progress, 0.0, 0.3);
  core::PartOfProgress second(progress, 0.3, 1.0);
  return {.area = NullDistribution(replicated<double>(
              options.replicates, options.seed, "permutation of areas", first,
              [&](core::Random& random) { return figureOf(as_they_are.dealt(random), areaValidationMetric); })),
          .scatter = NullDistribution(
              replicated<double>(options.replicates, options.seed, "permutation of scatters", second,
                                 [&](core::Random& random) { return figureOf(aligned.dealt(random), scatter); }))};
}

Floor samplingFloor(const UnitSample& measured, std::span<const std::size_t> run_units, const FloorOptions& options,
                    core::Progress& progress) {
  mustHaveRuns(run_units.size());
  const SortedUnits sorted(measured, "measured sample");
  std::vector<std::size_t> sizes{sorted.unitCount()};
  for (const std::size_t size : run_units) {
    if (size == 0) {
      throw core::InputError({.item = fmt::format("simulated run {}", sizes.size())}, "has no units.",
                             "Give the number of values, or of frames, that it will have.");
    }
    sizes.push_back(size);
  }
  struct Distances {
    double area;
    double scatter;
  };
  const auto distances = [&](const Comparison& boxes) {
    return Distances{.area = areaValidationMetric(boxes),
                     .scatter = doubleValidationMetric(boxes, options.shift).scatter};
  };
  const auto drawn =
      replicated<Distances>(options.replicates, options.seed, "sampling floor", progress, [&](core::Random& random) {
        Counts units;
        Counts steps;
        std::vector<Edf> sides;
        for (const std::size_t size : sizes) {
          drawWithReplacement(sorted.unitCount(), size, 1, random, units);
          sorted.countSteps(units, steps);
          sides.push_back(Edf::repeated(sorted.steps(), steps));
        }
        return figureOf(std::move(sides), distances);
      });
  std::vector<double> areas;
  std::vector<double> scatters;
  for (const Distances& both : drawn) {
    areas.push_back(both.area);
    scatters.push_back(both.scatter);
  }
  return {.area = NullDistribution(std::move(areas)), .scatter = NullDistribution(std::move(scatters))};
}

bool attainable(double threshold, const NullDistribution& floor, double chance) {
  return floor.shareUpTo(threshold) >= chance;
}

}  // namespace metrics
