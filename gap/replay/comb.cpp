#include "gap/replay/comb.h"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace gap {

namespace {

constexpr double kPlacesPerTurn = 8.0;  // of the farthest value's phase: the peak is one turn wide
constexpr double kMostPlaces = 40000.0;
constexpr double kAligned = 0.9;  // of the mean cosine that a comb with this rounding has
constexpr double kLikely = 0.05;  // by chance: no comb, not even to begin with
constexpr double kCoarser = 4.0;  // times the rounding: two of its steps; finer combs look like coarser ones (aliasing)
constexpr int kBitsOfPeak = 30;
constexpr std::size_t kFewest = 5;
constexpr std::size_t kMostValues = 500;

/// How near the values are to multiples of 1/frequency: 1 if all are.
double alignment(const std::vector<double>& values, double frequency) {
  double sum = 0.0;
  for (const double value : values) sum += std::cos(2.0 * std::numbers::pi * frequency * value);
  return sum / static_cast<double>(values.size());
}

/// What rounding, evenly spread over so much to either side, leaves of the alignment with a comb of this frequency.
double alignmentLeftBy(double rounding, double frequency) {
  const double phase = 2.0 * std::numbers::pi * frequency * rounding;
  return phase > 0.0 ? std::sin(phase) / phase : 1.0;
}

/// Of neighbours in a sorted list of two at least.
std::vector<double> distancesIn(const std::vector<double>& sorted) {
  std::vector<double> distances;
  for (std::size_t i = 1; i < sorted.size(); ++i) distances.push_back(sorted[i] - sorted[i - 1]);
  return distances;
}

std::vector<double> thinned(const std::vector<double>& values) {
  std::vector<double> some;
  const std::size_t stride = (values.size() + kMostValues - 1) / kMostValues;
  for (std::size_t i = 0; i < values.size(); i += stride) some.push_back(values[i]);
  return some;
}

/// The steps of whose multiples no value is farther than its rounding; none where noise is in the values, too.
std::optional<Comb> stepsThatRoundTo(const std::vector<double>& values, double step, double rounding) {
  double low = 0.0, high = std::numeric_limits<double>::infinity();
  for (const double value : values) {
    const double steps = std::round(value / step);
    if (steps < 1.0) continue;
    low = std::max(low, (value - rounding) / steps);
    high = std::min(high, (value + rounding) / steps);
  }
  if (low > high) return std::nullopt;
  return Comb{0.5 * (low + high), 0.5 * (high - low), 0.0};
}

}  // namespace

std::optional<Comb> combOf(std::vector<double> values, double rounding) {
  constexpr double kSame = 1e-6;
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end(), [](double a, double b) { return b - a < kSame; }),
               values.end());
  if (values.size() < kFewest) return std::nullopt;
  const std::vector<double> distances = distancesIn(values);
  const double smallest = *std::min_element(distances.begin(), distances.end());
  const double finest = kCoarser * rounding;
  if (smallest < finest - kSame) return std::nullopt;

  const std::vector<double> some = thinned(values);
  const double lowest = 1.0 / (smallest + 2.0 * rounding), highest = 1.0 / std::max(finest, smallest - 2.0 * rounding);
  const double turns = kPlacesPerTurn * values.back(), places = std::ceil((highest - lowest) * turns);
  if (places > kMostPlaces) return std::nullopt;
  double best = lowest, most = alignment(some, lowest);
  for (double place = 1.0; place <= places; place += 1.0) {
    const double frequency = lowest + place / turns, aligned = alignment(some, frequency);
    if (aligned <= most) continue;
    most = aligned;
    best = frequency;
  }
  // Noise that spreads values over neighbouring steps of a finer comb leaves one out at every second place at best.
  const auto neighbours = std::count_if(distances.begin(), distances.end(),
                                        [&](double distance) { return distance < smallest + 2.0 * rounding + kSame; });
  const double by_chance = std::min(1.0, (places + 1.0) * std::exp(-static_cast<double>(some.size()) * most * most)) *
                           std::exp2(-static_cast<double>(neighbours));
  if (most < kAligned * alignmentLeftBy(rounding, best) || by_chance > kLikely) return std::nullopt;
  const auto misaligned = [&](double frequency) { return -alignment(values, frequency); };
  const double place = 1.0 / turns;
  best = boost::math::tools::brent_find_minima(misaligned, best - place, best + place, kBitsOfPeak).first;
  const double step = 1.0 / best;
  Comb comb = stepsThatRoundTo(values, step, rounding + kSame).value_or(Comb{step, place * step * step, 0.0});
  comb.by_chance = by_chance;
  return comb;
}

bool lieOnSteps(const std::vector<double>& values, double step) {
  constexpr double kHalf = 0.5;  // of the alignment: scattered values have none, and all of it if they are multiples
  return values.empty() || step <= 0.0 || alignment(values, 1.0 / step) > kHalf;
}

double jumpVariance(double step, double moved, double noise) {
  const double of_noise = std::numbers::sqrt2 * noise;
  return step * std::sqrt(2.0 / std::numbers::pi) * (std::hypot(moved, of_noise) - of_noise);
}

}  // namespace gap
