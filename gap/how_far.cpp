#include "gap/how_far.h"

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <span>

#include "core/parallel.h"
#include "core/random.h"

namespace gap {

namespace {

constexpr int kResamples = 60;
constexpr std::size_t kNoiseRefits = 4;

double quantile(std::vector<double> values, double p) {
  std::sort(values.begin(), values.end());
  const double place = p * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, values.size() - 1);
  return values[below] + (place - static_cast<double>(below)) * (values[above] - values[below]);
}

Interval central95(const std::vector<double>& values) { return {quantile(values, 0.025), quantile(values, 0.975)}; }

std::vector<int> resampledFrames(int frames, core::Random& random) {
  std::vector<int> chosen;
  for (int f = 0; f < frames; ++f) chosen.push_back(static_cast<int>(random.below(static_cast<std::uint32_t>(frames))));
  return chosen;
}

struct Pairing {
  core::Detections before;
  core::Detections after;
};

/// Sum of squares of the p-th values about their mean.
double squaresAbout(std::span<const std::vector<double>> fits, std::size_t p) {
  double mean = 0.0, squares = 0.0;
  for (const auto& values : fits) mean += values[p] / static_cast<double>(fits.size());
  for (const auto& values : fits) squares += (values[p] - mean) * (values[p] - mean);
  return squares;
}

}  // namespace

double shrinkOf(double before, double after) { return before > 0.0 ? 1.0 - after / before : 0.0; }

double totalOf(const Replay& replay, const World& world, const std::vector<std::size_t>& samples, std::uint64_t seed) {
  std::vector<TotalGap> gaps;
  for (const std::size_t s : samples) {
    const ReplaySample& sample = replay.samples()[s];
    gaps.push_back(
        totalGap(replay.experiment().measurands, sample.measured, replay.detections(world, s, seed), sample.frames));
  }
  return meanOf(gaps).total;
}

double selfTotalOf(const Replay& replay, const World& world, const std::vector<std::size_t>& samples,
                   std::uint64_t seed) {
  std::vector<TotalGap> gaps;
  for (const std::size_t s : samples) {
    gaps.push_back(totalGap(replay.experiment().measurands, replay.detections(world, s, seed + 1),
                            replay.detections(world, s, seed), replay.samples()[s].frames));
  }
  return meanOf(gaps).total;
}

BeforeAfter howFar(const Replay& replay, const World& after, const std::vector<std::size_t>& held_out,
                   std::uint64_t seed, const core::Progress& progress) {
  const auto& measurands = replay.experiment().measurands;
  std::vector<Pairing> pairings(held_out.size());
  std::vector<TotalGap> gaps_before(held_out.size()), gaps_after(held_out.size());
  core::parallelFor(held_out.size(), 1, [&](std::size_t i, std::size_t) {
    const ReplaySample& sample = replay.samples()[held_out[i]];
    pairings[i] = {replay.detections(replay.baseline(), held_out[i], seed),
                   replay.detections(after, held_out[i], seed)};
    gaps_before[i] = totalGap(measurands, sample.measured, pairings[i].before, sample.frames);
    gaps_after[i] = totalGap(measurands, sample.measured, pairings[i].after, sample.frames);
  });
  BeforeAfter result;
  result.before = meanOf(gaps_before);
  result.after = meanOf(gaps_after);
  result.shrink.fraction = shrinkOf(result.before.total, result.after.total);
  for (std::size_t i = 0; i < held_out.size(); ++i) {
    const model::Sample& sample = *replay.samples()[held_out[i]].sample;
    result.samples.push_back({sample.id, sample.setup, gaps_before[i].total, gaps_after[i].total});
  }

  std::vector<TotalGap> means_before(kResamples), means_after(kResamples);
  core::parallelFor(kResamples, 1, [&](std::size_t r, std::size_t) {
    core::stopIfCancelled(progress);
    core::Random random(
        {.seed = seed, .frame = static_cast<std::uint32_t>(r), .purpose = core::purposeOf("bootstrap")});
    std::vector<TotalGap> resampled_before, resampled_after;
    for (std::size_t k = 0; k < held_out.size(); ++k) {
      const std::size_t i = random.below(static_cast<std::uint32_t>(held_out.size()));
      const ReplaySample& sample = replay.samples()[held_out[i]];
      const auto frames = resampledFrames(sample.frames, random);
      const core::Detections measured = framesOf(sample.measured, frames);
      resampled_before.push_back(totalGap(measurands, measured, pairings[i].before, sample.frames));
      resampled_after.push_back(totalGap(measurands, measured, pairings[i].after, sample.frames));
    }
    means_before[r] = meanOf(resampled_before);
    means_after[r] = meanOf(resampled_after);
  });
  std::vector<double> shrinks;
  std::map<std::string, std::vector<double>> biases;
  for (int r = 0; r < kResamples; ++r) {
    const auto index = static_cast<std::size_t>(r);
    shrinks.push_back(shrinkOf(means_before[index].total, means_after[index].total));
    for (const MeasurandGap& m : means_before[index].measurands) biases[m.name].push_back(m.d_bias);
  }
  result.shrink.interval = central95(shrinks);
  for (const auto& [name, values] : biases) result.bias_intervals[name] = central95(values);
  return result;
}

std::vector<Interval> parameterIntervals(const Replay& replay, const Hypothesis& hypothesis,
                                         const std::vector<double>& values, const Evidence& evidence,
                                         const core::Progress& progress) {
  const std::vector<std::string> setups = setupsOf(replay, evidence.samples);
  std::vector<Interval> intervals;
  if (setups.size() < 2 || hypothesis.per_setup) return intervals;
  // The simulation's own noise is told by refits of everything under other noise, that of the data by a jackknife.
  std::vector<std::vector<double>> refits(setups.size() + kNoiseRefits);
  core::parallelFor(refits.size(), 1, [&](std::size_t k, std::size_t) {
    Evidence own = evidence;
    if (k < setups.size()) {
      std::erase_if(own.samples, [&](std::size_t s) { return replay.samples()[s].sample->setup == setups[k]; });
    } else {
      own.seed += 1 + k;
    }
    refits[k] = refine(replay, hypothesis, own, values, progress);
  });
  const std::span jackknife = std::span(refits).first(setups.size());
  const std::span noise = std::span(refits).subspan(setups.size());
  const double n = static_cast<double>(setups.size());
  const double t = boost::math::quantile(boost::math::students_t(n - 1.0), 0.975);
  for (std::size_t p = 0; p < values.size(); ++p) {
    const double error = std::sqrt((n - 1.0) / n * squaresAbout(jackknife, p) +
                                   squaresAbout(noise, p) / static_cast<double>(kNoiseRefits - 1));
    // Nothing is seen of a sector's end between two beams.
    const bool sector_end = hypothesis.parameters[p].name.rfind("azimuth_", 0) == 0;
    const double reach = std::max(t * error, sector_end ? azimuthStep_deg(replay) / 2.0 : 0.0);
    intervals.push_back({values[p] - reach, values[p] + reach});
  }
  return intervals;
}

}  // namespace gap
