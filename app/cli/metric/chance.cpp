#include "app/cli/metric/chance.h"

#include <array>
#include <fmt/format.h>
#include <set>

#include "metrics/resampling/bootstrap.h"
#include "metrics/resampling/box_width_floor.h"
#include "metrics/resampling/permutation_floor.h"
#include "metrics/resampling/repetitions.h"

namespace app {

namespace {

/// Whose intervals are told if no metric was asked for by name.
constexpr std::array<std::string_view, 7> kUsual = {"d_avm",  "d_plus",          "d_minus",       "d_bias",
                                                    "d_cavm", "mean_difference", "std_difference"};

/// The metrics that get intervals, and where the numbers of each begin.
struct Figured {
  std::vector<const metrics::Metric*> metrics;
  std::size_t numbers = 0;
};

Figured figured(const MeasurandResult& measurand, const MetricRequest& request) {
  Figured figured;
  for (const MetricResult& result : measurand.results) {
    const bool usual = std::find(kUsual.begin(), kUsual.end(), result.info.name) != kUsual.end();
    if (request.metrics.empty() && !usual) continue;
    figured.metrics.push_back(&metrics::metricNamed(result.info.name));
    figured.numbers += result.numbers.size();
  }
  return figured;
}

metrics::Figures figuresOf(const Figured& figured, const metrics::MetricOptions& options) {
  return [figured, options](const metrics::Comparison& boxes, const metrics::SamplePair& pooled,
                            std::span<double> results) {
    const metrics::MetricInput input(boxes, pooled, options);
    std::size_t at = 0;
    for (const metrics::Metric* metric : figured.metrics) {
      for (const double number : metric->compute(input)) results[at++] = number;
    }
  };
}

metrics::BootstrapOptions bootstrapOptions(const MetricRequest& request) {
  return {.replicates = request.intervals,
          .block = request.block,
          .paired = request.paired,
          .confidence = request.confidence,
          .method = request.bca ? metrics::IntervalMethod::BCa : metrics::IntervalMethod::Percentile,
          .seed = request.seed};
}

void addIntervals(const ChanceSamples& samples, const MetricRequest& request, const Session& session,
                  MeasurandResult& measurand) {
  const Figured which = figured(measurand, request);
  const auto intervals =
      metrics::bootstrapIntervals(samples.view(), which.numbers, figuresOf(which, request.metricOptions()),
                                  bootstrapOptions(request), session.progress);
  std::size_t at = 0;
  for (const metrics::Metric* metric : which.metrics) {
    const auto result = std::find_if(measurand.results.begin(), measurand.results.end(),
                                     [&](const MetricResult& r) { return r.info.name == metric->info.name; });
    for (std::size_t i = 0; i < result->numbers.size(); ++i) result->intervals.push_back(intervals[at++]);
  }
}

std::vector<metrics::UnitSample> runsOf(const ChanceSamples& samples) { return samples.view().simulated; }

std::size_t unitCount(const ChanceSample& sample) {
  if (sample.units.empty()) return sample.values.size();
  return std::set<std::uint32_t>(sample.units.begin(), sample.units.end()).size();
}

void addFloor(const ChanceSamples& samples, const MetricRequest& request, const Session& session,
              MeasurandResult& measurand) {
  const metrics::FloorOptions options{.shift = request.metricOptions().shift, .seed = request.seed};
  const metrics::Floor floor = metrics::permutationFloor(samples.view(), options, session.progress);
  std::vector<std::size_t> run_units;
  for (const ChanceSample& run : samples.simulated) run_units.push_back(unitCount(run));
  const metrics::Floor perfect = metrics::samplingFloor(samples.measured.view(), run_units, options, session.progress);
  const auto line = [&](std::string_view name, std::optional<double> perfect_median,
                        const metrics::NullDistribution& null) {
    const auto result = std::find_if(measurand.results.begin(), measurand.results.end(),
                                     [&](const MetricResult& r) { return r.info.name == name; });
    FloorResult floor_line{.name = name,
                           .perfect_median = perfect_median,
                           .median = null.median(),
                           .high = null.quantile(0.95),
                           .p_value = std::nullopt};
    if (result != measurand.results.end()) {
      floor_line.p_value = metrics::permutationPValue(result->numbers.front(), null);
    }
    measurand.floors.push_back(floor_line);
  };
  line("d_avm", perfect.area.median(), floor.area);
  line(options.shift == metrics::Shift::One ? "d_cavm" : "d_cavm_balanced", perfect.scatter.median(), floor.scatter);
  if (samples.simulated.size() < 2) return;
  line("pbox_area", std::nullopt, metrics::boxWidthFloor(runsOf(samples), {.seed = request.seed}, session.progress));
}

void addRepetitions(const ChanceSamples& samples, const MetricRequest& request, const Session& session,
                    MeasurandResult& measurand) {
  Figured which;
  std::vector<double> half_widths;
  for (const auto& [name, half_width] : request.wantedHalfWidths()) {
    which.metrics.push_back(&metrics::metricNamed(name));
    if (which.metrics.back()->shape != metrics::MetricShape::Number) {
      throw core::InputError({.item = "--half-width " + name}, "is no single number.", "Name a part, such as d_bias.");
    }
    ++which.numbers;
    half_widths.push_back(half_width);
  }
  metrics::BootstrapOptions options = bootstrapOptions(request);
  if (options.replicates == 0) options.replicates = 1000;
  const auto needed = metrics::repetitionsForFigures(
      samples.view(), half_widths, figuresOf(which, request.metricOptions()), options, session.progress);
  for (std::size_t i = 0; i < needed.size(); ++i) {
    const metrics::Repetitions& times = needed[i].repetitions;
    measurand.repetitions.push_back(
        {which.metrics[i]->info.name, half_widths[i], times.factor, times.low, times.high, needed[i].measured_share});
  }
}

}  // namespace

metrics::UnitComparison ChanceSamples::view() const {
  metrics::UnitComparison comparison{.simulated = {}, .measured = measured.view()};
  for (const ChanceSample& run : simulated) comparison.simulated.push_back(run.view());
  return comparison;
}

void addChance(const ChanceSamples& samples, const MetricRequest& request, const Session& session,
               MeasurandResult& measurand) {
  if (request.intervals > 0) addIntervals(samples, request, session, measurand);
  if (request.floor) addFloor(samples, request, session, measurand);
  if (!request.half_widths.empty()) addRepetitions(samples, request, session, measurand);
}

}  // namespace app
