#include "gap/far/how_far.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "core/parallel.h"
#include "core/random.h"
#include "gap/distance/settle.h"

namespace gap {

namespace {

constexpr int kResamples = 60;
constexpr std::size_t kRuns = 3;        // of a world: a few false echoes far away make much of a pooled gap, or nothing
constexpr double kMaterialTotal = 1.5;  // times the total gap of a right model
constexpr double kLeastBeyond = 0.1;    // of the total gap of a right model: less is not known of what is beyond it

double shrinkOf(double before, double after) { return before > 0.0 ? 1.0 - after / before : 0.0; }

double quantile(std::vector<double> values, double p) {
  std::sort(values.begin(), values.end());
  const double place = p * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, values.size() - 1);
  return values[below] + (place - static_cast<double>(below)) * (values[above] - values[below]);
}

Interval central95(const std::vector<double>& values) { return {quantile(values, 0.025), quantile(values, 0.975)}; }

/// Where a repetition is expected nine times in ten. Draws with replacement repeat frames, so their distributions are
/// coarser and their gaps larger than those of the data: the draws tell a spread, about another mean. The repetition
/// scatters as the data did, so the difference of the two has twice the variance. A few draws far out may carry their
/// mean beyond nine tenths of them; the interval holds the value all the same.
Interval predicted90(double value, const std::vector<double>& draws) {
  const double mean = std::accumulate(draws.begin(), draws.end(), 0.0) / static_cast<double>(draws.size());
  const auto at = [&](double p) { return value + std::numbers::sqrt2 * (quantile(draws, p) - mean); };
  return {std::min(value, at(0.05)), std::max(value, std::min(1.0, at(0.95)))};
}

std::vector<int> resampledFrames(int frames, core::Random& random) {
  std::vector<int> chosen;
  for (int f = 0; f < frames; ++f) chosen.push_back(static_cast<int>(random.below(static_cast<std::uint32_t>(frames))));
  return chosen;
}

std::size_t placeOf(const std::vector<std::size_t>& samples, std::size_t index) {
  return static_cast<std::size_t>(std::find(samples.begin(), samples.end(), index) - samples.begin());
}

}  // namespace

HeldOutGaps::HeldOutGaps(const Replay& replay, std::vector<std::size_t> samples, std::uint64_t seed)
    : replay_(replay), samples_(std::move(samples)), seed_(seed), draws_(kResamples) {
  for (const SetUp& setup : setupsOf(replay, samples_)) {
    of_setup_.emplace_back();
    for (const std::size_t index : setup.samples) of_setup_.back().push_back(placeOf(samples_, index));
  }
  for (const std::size_t index : samples_) {
    const ReplaySample& sample = replay.samples()[index];
    cells_.push_back(sample.layout->cellsOf(sample.measured, sample.beam_of));
  }
  const std::vector<core::Detections> baseline = simulated(replay.baseline(), seed);
  gaps_before_ = gapsTo(baseline);
  before_ = meanOf(gaps_before_);
  noise_ = between(baseline, simulated(replay.baseline(), seed + 1));
  core::parallelFor(draws_.size(), 1, [&](std::size_t number, std::size_t) {
    draws_[number] = drawn(number);
    draws_[number].before = gapOf(draws_[number], baseline);
  });
}

std::vector<core::Detections> HeldOutGaps::simulated(const World& world, std::uint64_t seed) const {
  std::vector<core::Detections> detections(samples_.size());
  core::parallelFor(samples_.size(), 1,
                    [&](std::size_t i, std::size_t) { detections[i] = replay_.detections(world, samples_[i], seed); });
  return detections;
}

std::vector<TotalGap> HeldOutGaps::gapsTo(const std::vector<core::Detections>& simulated) const {
  std::vector<TotalGap> gaps;
  for (std::size_t i = 0; i < samples_.size(); ++i) {
    const ReplaySample& sample = replay_.samples()[samples_[i]];
    gaps.push_back(totalGap(replay_.experiment().measurands, sample.measured, simulated[i], sample.frames));
  }
  return gaps;
}

double HeldOutGaps::totalIn(const World& world) const { return meanOf(gapsTo(simulated(world, seed_))).total; }

double HeldOutGaps::between(const std::vector<core::Detections>& one,
                            const std::vector<core::Detections>& other) const {
  std::vector<TotalGap> gaps;
  for (std::size_t i = 0; i < samples_.size(); ++i) {
    const int frames = replay_.samples()[samples_[i]].frames;
    gaps.push_back(totalGap(replay_.experiment().measurands, other[i], one[i], frames));
  }
  return meanOf(gaps).total;
}

double HeldOutGaps::toMeasurement(const std::vector<core::Detections>& simulated) const {
  const std::vector<TotalGap> gaps = gapsTo(simulated);
  double total = meanOf(gaps).total;
  for (std::size_t i = 0; i < gaps.size(); ++i)
    total += ofMeasurandsLostIn(gaps[i], gaps_before_[i]) / static_cast<double>(gaps.size());
  return total;
}

double HeldOutGaps::leftIn(const World& world) const {
  std::vector<std::vector<core::Detections>> runs;
  for (std::size_t r = 0; r < kRuns; ++r) runs.push_back(simulated(world, seed_ + r));
  double beyond = 0.0;
  for (std::size_t r = 0; r < kRuns; ++r)
    beyond += (toMeasurement(runs[r]) - between(runs[r], runs[(r + 1) % kRuns])) / static_cast<double>(kRuns);
  // Of a gap that is no larger than noise, a share is one of noise.
  return std::max(0.0, beyond / std::max({1e-9, kLeastBeyond * noise_, before_.total - noise_}));
}

double HeldOutGaps::shrinkTo(double after) const { return shrinkOf(before_.total, after); }

double HeldOutGaps::aboveNoise() const { return std::clamp(shrinkTo(noise_), 0.0, 1.0); }

bool HeldOutGaps::material() const noexcept { return before_.total > kMaterialTotal * noise_; }

HeldOutGaps::Drawn HeldOutGaps::drawn(std::size_t number) const {
  core::Random random(
      {.seed = seed_, .frame = static_cast<std::uint32_t>(number), .purpose = core::purposeOf("bootstrap")});
  Drawn drawn;
  std::map<std::pair<std::string, std::string>, double> of_setups;
  for (std::size_t k = 0; k < of_setup_.size(); ++k) {
    const std::vector<std::size_t>& places = of_setup_[random.below(static_cast<std::uint32_t>(of_setup_.size()))];
    drawn.samples.insert(drawn.samples.end(), places.begin(), places.end());
  }
  for (const std::size_t place : drawn.samples) {
    const ReplaySample& sample = replay_.samples()[samples_[place]];
    drawn.frames.push_back(resampledFrames(sample.frames, random));
    drawn.offsets.emplace_back();
    for (const Tolerance& tolerance : sample.tolerances) {
      const auto [offset, unseen] = of_setups.try_emplace({sample.sample->setup, tolerance.pointer});
      if (unseen) offset->second = drawnOffset(tolerance, random);
      drawn.offsets.back().push_back(offset->second);
    }
  }
  return drawn;
}

core::Detections HeldOutGaps::measuredAt(const std::vector<double>& offsets, std::size_t place) const {
  const ReplaySample& sample = replay_.samples()[samples_[place]];
  core::Detections moved = sample.measured;
  for (std::size_t t = 0; t < offsets.size(); ++t) {
    const std::vector<float>& range_per_unit = sample.tolerances[t].range_per_unit;
    for (std::size_t d = 0; d < moved.size(); ++d) {
      const std::size_t cell = cells_[place][d];
      if (cell < range_per_unit.size() && std::isfinite(range_per_unit[cell]))
        moved.range_m[d] += offsets[t] * static_cast<double>(range_per_unit[cell]);
    }
  }
  return moved;
}

TotalGap HeldOutGaps::gapOf(const Drawn& drawn, const std::vector<core::Detections>& simulated) const {
  std::vector<TotalGap> gaps;
  for (std::size_t k = 0; k < drawn.samples.size(); ++k) {
    const ReplaySample& sample = replay_.samples()[samples_[drawn.samples[k]]];
    const core::Detections measured = measuredAt(drawn.offsets[k], drawn.samples[k]);
    gaps.push_back(totalGap(replay_.experiment().measurands, framesOf(measured, drawn.frames[k]),
                            simulated[drawn.samples[k]], sample.frames));
  }
  return meanOf(gaps);
}

std::map<std::string, Interval> HeldOutGaps::biasIntervals() const {
  std::map<std::string, std::vector<double>> biases;
  for (const Drawn& drawn : draws_) {
    for (const MeasurandGap& m : drawn.before.measurands) biases[m.name].push_back(m.d_bias);
  }
  std::map<std::string, Interval> intervals;
  for (const auto& [name, values] : biases) intervals[name] = central95(values);
  return intervals;
}

After HeldOutGaps::with(const World& world, const core::Progress& progress) const {
  const std::vector<core::Detections> detections = simulated(world, seed_);
  const std::vector<TotalGap> gaps = gapsTo(detections);
  After after;
  after.gap = meanOf(gaps);
  after.shrink.fraction = shrinkTo(after.gap.total);
  for (std::size_t i = 0; i < samples_.size(); ++i) {
    const model::Sample& sample = *replay_.samples()[samples_[i]].sample;
    after.samples.push_back({sample.id, sample.setup, gaps_before_[i].total, gaps[i].total});
  }
  std::vector<double> shrinks(draws_.size());
  core::parallelFor(draws_.size(), 1, [&](std::size_t d, std::size_t) {
    core::stopIfCancelled(progress);
    shrinks[d] = shrinkOf(draws_[d].before.total, gapOf(draws_[d], detections).total);
  });
  after.shrink.interval = predicted90(after.shrink.fraction, shrinks);
  return after;
}

}  // namespace gap
