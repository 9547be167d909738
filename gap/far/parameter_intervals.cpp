#include "gap/far/parameter_intervals.h"

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <span>

#include "core/parallel.h"
#include "gap/causes/scale.h"

namespace gap {

namespace {

constexpr std::size_t kNoiseRefits = 4;
constexpr std::size_t kMostGroups = 6;  // of set-ups, each left out in turn
constexpr int kRefitFrames = 8;

/// Sum of squares of the p-th values about their mean.
double squaresAbout(std::span<const std::vector<double>> fits, std::size_t p) {
  double mean = 0.0, squares = 0.0;
  for (const auto& values : fits) mean += values[p] / static_cast<double>(fits.size());
  for (const auto& values : fits) squares += (values[p] - mean) * (values[p] - mean);
  return squares;
}

}  // namespace

std::vector<Interval> parameterIntervals(const Replay& replay, const Hypothesis& hypothesis,
                                         const std::vector<double>& values, const Evidence& evidence,
                                         const core::Progress& progress) {
  const std::vector<SetUp> setups = setupsOf(replay, evidence.samples);
  std::vector<Interval> intervals;
  if (setups.size() < 2 || hypothesis.per_setup) return intervals;
  // The simulation's own noise is told by refits of everything under other noise, that of the data by a jackknife.
  const std::size_t groups = std::min(setups.size(), kMostGroups);
  std::vector<std::vector<double>> refits(groups + kNoiseRefits);
  core::parallelFor(refits.size(), 1, [&](std::size_t k, std::size_t) {
    Evidence own = evidence;
    own.most_frames = std::min(own.most_frames, kRefitFrames);
    if (k < groups) {
      for (std::size_t i = k; i < setups.size(); i += groups)
        for (const std::size_t left_out : setups[i].samples) std::erase(own.samples, left_out);
    } else {
      own.seed += 1 + k;
    }
    refits[k] = refine(replay, hypothesis, own, values, progress);
  });
  const std::span jackknife = std::span(refits).first(groups);
  const std::span noise = std::span(refits).subspan(groups);
  const double n = static_cast<double>(groups);
  const double t = boost::math::quantile(boost::math::students_t(n - 1.0), 0.975);
  for (std::size_t p = 0; p < values.size(); ++p) {
    const double error = std::sqrt((n - 1.0) / n * squaresAbout(jackknife, p) +
                                   squaresAbout(noise, p) / static_cast<double>(kNoiseRefits - 1));
    // Nothing is seen of a sector's end between two beams, and of no value what is finer than the search.
    const FreeParameter& parameter = hypothesis.parameters[p];
    const double least = parameter.azimuth ? azimuthStep_deg(replay) / 2.0 : resolvedAt(parameter, values[p]);
    const double reach = std::max(t * error, least);
    intervals.push_back({std::max(parameter.low, values[p] - reach), std::min(parameter.high, values[p] + reach)});
  }
  return intervals;
}

}  // namespace gap
