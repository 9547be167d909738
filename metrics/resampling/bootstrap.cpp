#include "metrics/resampling/bootstrap.h"

#include <algorithm>
#include <atomic>
#include <fmt/format.h>
#include <numeric>
#include <optional>

#include "core/error.h"
#include "core/parallel.h"
#include "metrics/distributions/summation.h"
#include "metrics/resampling/sorted_units.h"

namespace metrics {

namespace {

constexpr std::size_t kGrain = 4;  // replicates a piece: enough to reuse its memory
constexpr std::size_t kJackknifeEvaluations = 200;
constexpr std::size_t kFewestGroups = 10;

/// All sides, sorted once. Side 0 is the measurement, side k the k-th run.
class SortedSides {
 public:
  explicit SortedSides(const UnitComparison& samples) {
    if (samples.simulated.empty()) {
      throw core::InputError({}, "no simulated run to draw from.", "Give at least one simulated sample.");
    }
    sides_.reserve(samples.simulated.size() + 1);
    sides_.emplace_back(samples.measured, "measured sample");
    for (const UnitSample& run : samples.simulated) {
      sides_.emplace_back(
          run, samples.simulated.size() == 1 ? "simulated sample" : fmt::format("simulated run {}", sides_.size()));
    }
    if (samples.simulated.size() > 1) poolRuns();
  }

  [[nodiscard]] std::size_t count() const noexcept { return sides_.size(); }
  [[nodiscard]] const SortedUnits& side(std::size_t k) const { return sides_[k]; }

  /// The figures if unit u of side k is taken unit_counts[k][u] times.
  void evaluate(const std::vector<Counts>& unit_counts, const Figures& figures, std::span<double> results) const {
    Counts steps;
    sides_[0].countSteps(unit_counts[0], steps);
    const PBox measured = Edf::repeated(sides_[0].steps(), steps);
    std::vector<Edf> runs;
    Counts pooled(pooled_steps_.size(), 0);
    for (std::size_t k = 1; k < sides_.size(); ++k) {
      sides_[k].countSteps(unit_counts[k], steps);
      runs.push_back(Edf::repeated(sides_[k].steps(), steps));
      if (pooled.empty()) continue;
      for (std::size_t i = 0; i < steps.size(); ++i) pooled[pooled_step_of_[k - 1][i]] += steps[i];
    }
    const PBox simulated = PBox::envelope(runs);
    const std::optional<Edf> all = pooled.empty() ? std::nullopt : std::optional(Edf::repeated(pooled_steps_, pooled));
    figures({.simulated = simulated, .measured = measured},
            {.simulated = all ? *all : simulated.left(), .measured = measured.left()}, results);
  }

 private:
  void poolRuns() {
    for (std::size_t k = 1; k < sides_.size(); ++k) {
      const auto steps = sides_[k].steps();
      pooled_steps_.insert(pooled_steps_.end(), steps.begin(), steps.end());
    }
    std::sort(pooled_steps_.begin(), pooled_steps_.end());
    pooled_steps_.erase(std::unique(pooled_steps_.begin(), pooled_steps_.end()), pooled_steps_.end());
    for (std::size_t k = 1; k < sides_.size(); ++k) {
      std::vector<std::uint32_t>& places = pooled_step_of_.emplace_back();
      std::size_t place = 0;
      for (const double x : sides_[k].steps()) {
        while (pooled_steps_[place] < x) ++place;
        places.push_back(static_cast<std::uint32_t>(place));
      }
    }
  }

  std::vector<SortedUnits> sides_;
  std::vector<double> pooled_steps_;                        // empty for a single run
  std::vector<std::vector<std::uint32_t>> pooled_step_of_;  // of each run's steps
};

void check(const SortedSides& sides, const BootstrapOptions& options) {
  if (options.replicates < 2) {
    throw core::InputError({.item = "replicates"}, fmt::format("are {}; no interval can be read.", options.replicates),
                           "Draw 1000 or more.");
  }
  if (options.block == 0) {
    throw core::InputError({.item = "block"}, "has length 0.", "Give 1 to draw single units.");
  }
  for (std::size_t k = 0; k < sides.count(); ++k) {
    const std::string name = k == 0 ? "measured sample" : fmt::format("simulated run {}", k);
    const std::size_t units = sides.side(k).unitCount();
    if (units < 2) {
      throw core::InputError({.item = name}, "has one unit; drawing it again shows no scatter.",
                             "Give more frames or set-ups, or draw single detections.");
    }
    if (options.block >= units) {
      throw core::InputError({.item = name},
                             fmt::format("has {} units, no more than a block of {}.", units, options.block),
                             "Choose blocks that are a small part of the sample.");
    }
    if (options.paired && !std::ranges::equal(sides.side(k).units(), sides.side(0).units())) {
      throw core::InputError({.item = name}, "has other units than the measured sample; they cannot be paired.",
                             "Keep the set-ups that both have, or draw the sides apart.");
    }
  }
}

/// All sides' units, each taken once.
std::vector<Counts> eachUnitOnce(const SortedSides& sides) {
  std::vector<Counts> counts;
  for (std::size_t k = 0; k < sides.count(); ++k) counts.emplace_back(sides.side(k).unitCount(), 1);
  return counts;
}

void draw(const SortedSides& sides, const BootstrapOptions& options, std::size_t replicate,
          std::vector<Counts>& counts) {
  counts.resize(sides.count());
  for (std::size_t k = 0; k < sides.count(); ++k) {
    if (options.paired && k > 0) {
      counts[k] = counts[0];
      continue;
    }
    core::Random random({.seed = options.seed,
                         .sample = static_cast<std::uint32_t>(replicate),
                         .frame = static_cast<std::uint32_t>(k),
                         .purpose = core::purposeOf("bootstrap")});
    const std::size_t units = sides.side(k).unitCount();
    drawWithReplacement(units, units, options.block, random, counts[k]);
  }
}

/// In which group each unit is left out: random groups of equal size, or neighbours if units are drawn in blocks.
std::vector<std::size_t> groupsOf(std::size_t units, std::size_t groups, const BootstrapOptions& options,
                                  std::size_t side) {
  std::vector<std::size_t> order(units);
  std::iota(order.begin(), order.end(), std::size_t{0});
  if (options.block == 1) {
    core::Random random({.seed = options.seed,
                         .frame = static_cast<std::uint32_t>(side),
                         .purpose = core::purposeOf("jackknife groups")});
    for (std::size_t i = units - 1; i > 0; --i) {
      std::swap(order[i], order[random.below(static_cast<std::uint32_t>(i + 1))]);
    }
  }
  std::vector<std::size_t> group_of(units);
  for (std::size_t i = 0; i < units; ++i) group_of[order[i]] = i * groups / units;
  return group_of;
}

/// What each group of units of side k (of all sides, if paired) moves the figures by.
void addInfluences(const SortedSides& sides, std::size_t k, const Figures& figures, const BootstrapOptions& options,
                   core::Progress& progress, BootstrapReplicates& result) {
  const std::size_t units = sides.side(k).unitCount();
  const std::size_t wanted = std::max(kFewestGroups, kJackknifeEvaluations / (options.paired ? 1 : sides.count()));
  const std::size_t groups = std::min(wanted, units / options.block);
  const std::vector<std::size_t> group_of = groupsOf(units, groups, options, k);
  const std::size_t figure_count = result.estimates.size();
  std::vector<std::vector<double>> without(figure_count, std::vector<double>(groups));
  core::parallelFor(groups, 1, [&](std::size_t g, std::size_t) {
    core::stopIfCancelled(progress);
    std::vector<Counts> counts = eachUnitOnce(sides);
    for (std::size_t side = 0; side < sides.count(); ++side) {
      if (side != k && !options.paired) continue;
      for (std::size_t u = 0; u < units; ++u) counts[side][u] = group_of[u] == g ? 0 : 1;
    }
    std::vector<double> results(figure_count);
    sides.evaluate(counts, figures, results);
    for (std::size_t f = 0; f < figure_count; ++f) without[f][g] = results[f];
  });
  const auto share = static_cast<double>(groups - 1) / static_cast<double>(groups);
  for (std::size_t f = 0; f < figure_count; ++f) {
    Summation sum;
    for (const double t : without[f]) sum.add(t);
    const double mean = sum.value() / static_cast<double>(groups);
    for (const double t : without[f]) result.influences[f].push_back(share * (mean - t));
  }
  result.groups.push_back(groups);
}

}  // namespace

BootstrapReplicates bootstrapReplicates(const UnitComparison& samples, std::size_t figure_count, const Figures& figures,
                                        const BootstrapOptions& options, core::Progress& progress) {
  const SortedSides sides(samples);
  check(sides, options);
  BootstrapReplicates result;
  result.estimates.resize(figure_count);
  sides.evaluate(eachUnitOnce(sides), figures, result.estimates);

  result.replicates.assign(figure_count, std::vector<double>(options.replicates));
  std::atomic<std::size_t> done = 0;
  core::parallelFor(options.replicates, kGrain, [&](std::size_t begin, std::size_t end) {
    std::vector<Counts> counts;
    std::vector<double> results(figure_count);
    for (std::size_t b = begin; b < end; ++b) {
      core::stopIfCancelled(progress);
      draw(sides, options, b, counts);
      sides.evaluate(counts, figures, results);
      for (std::size_t f = 0; f < figure_count; ++f) result.replicates[f][b] = results[f];
    }
    done += end - begin;
    progress.report(static_cast<double>(done) / static_cast<double>(options.replicates), "resampling");
  });

  result.influences.resize(figure_count);
  if (options.method == IntervalMethod::BCa) {
    const std::size_t populations = options.paired ? 1 : sides.count();
    for (std::size_t k = 0; k < populations; ++k) addInfluences(sides, k, figures, options, progress, result);
  }
  return result;
}

ConfidenceInterval intervalOf(const BootstrapReplicates& all, std::size_t figure, const BootstrapOptions& options) {
  const double estimate = all.estimates[figure];
  return options.method == IntervalMethod::BCa
             ? bcaInterval(estimate, all.replicates[figure], all.influences[figure], options.confidence)
             : percentileInterval(estimate, all.replicates[figure], options.confidence);
}

std::vector<ConfidenceInterval> bootstrapIntervals(const UnitComparison& samples, std::size_t figure_count,
                                                   const Figures& figures, const BootstrapOptions& options,
                                                   core::Progress& progress) {
  const BootstrapReplicates all = bootstrapReplicates(samples, figure_count, figures, options, progress);
  std::vector<ConfidenceInterval> intervals;
  for (std::size_t f = 0; f < figure_count; ++f) intervals.push_back(intervalOf(all, f, options));
  return intervals;
}

}  // namespace metrics
