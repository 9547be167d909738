#include "gap/causes/search.h"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <exception>
#include <memory>
#include <nlopt.h>
#include <optional>

namespace gap {

namespace {

constexpr int kHalvings = 3;         // of the steps of a search along a line
constexpr double kUsualStep = 0.06;  // of the scaled range; for the end of a sector it is
constexpr double kUsualStep_deg = 1.5;

/// n-th element of the van der Corput sequence in a base: together a Halton sequence, even and deterministic.
double vanDerCorput(unsigned n, unsigned base) {
  double value = 0.0, part = 1.0;
  for (; n > 0; n /= base) {
    part /= base;
    value += part * (n % base);
  }
  return value;
}

unsigned coarseCount(std::size_t dimensions) { return dimensions == 1 ? 14 : dimensions == 2 ? 24 : 40; }

/// Halves the steps beside the best of some points on a line. Where several are equally good (an effect does nothing on
/// a part of its range), the best value may lie just beyond the last of them.
void lookBetween(const Objective& objective, std::vector<Point>& points) {
  for (int round = 0; round < kHalvings; ++round) {
    std::sort(points.begin(), points.end(), [](const Point& a, const Point& b) { return a.unit < b.unit; });
    double best = std::numeric_limits<double>::infinity();
    for (const Point& point : points) best = std::min(best, point.discrepancy);
    std::vector<Point> between;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      const bool left = points[i].discrepancy == best, right = points[i + 1].discrepancy == best;
      if (left == right) continue;
      const std::vector<double> middle{0.5 * (points[i].unit[0] + points[i + 1].unit[0])};
      between.push_back({middle, objective(middle)});
    }
    points.insert(points.end(), between.begin(), between.end());
  }
}

/// Of the best points on a line, the one in their middle: where the data leave a range open (two echoes merge up to
/// some distance between those that were seen), its ends are the worst guess for other samples.
Point middleOfBest(std::vector<Point> points) {
  std::sort(points.begin(), points.end(), [](const Point& a, const Point& b) { return a.unit < b.unit; });
  const auto best = std::min_element(points.begin(), points.end(),
                                     [](const Point& a, const Point& b) { return a.discrepancy < b.discrepancy; });
  const auto end = std::find_if(best, points.end(), [&](const Point& p) { return p.discrepancy > best->discrepancy; });
  const double middle = 0.5 * (best->unit[0] + (end - 1)->unit[0]);
  return *std::min_element(best, end, [&](const Point& a, const Point& b) {
    return std::abs(a.unit[0] - middle) < std::abs(b.unit[0] - middle);
  });
}

/// A smallest value between two others on a line.
Point lowestBetween(const Objective& objective, double low, double high, std::uintmax_t most_trials) {
  const auto [unit, discrepancy] = boost::math::tools::brent_find_minima([&](double x) { return objective({x}); }, low,
                                                                         high, kLineBits, most_trials);
  return {{unit}, discrepancy};
}

/// The interval of an even search in which the objective changes most, if that is a good part of its change at all and
/// leads to where it is nearly as good as anywhere; else nothing.
std::optional<std::size_t> abruptStep(const std::vector<Point>& even, const Point& best) {
  constexpr double kMuchOfAll = 0.3, kNearly = 0.1;  // of the whole change
  double highest = best.discrepancy, largest = 0.0;
  for (const Point& point : even) highest = std::max(highest, point.discrepancy);
  const double whole = highest - best.discrepancy;
  std::optional<std::size_t> step;
  for (std::size_t i = 0; i + 1 < even.size(); ++i) {
    const auto [low, high] = std::minmax(even[i].discrepancy, even[i + 1].discrepancy);
    if (high - low <= std::max(largest, kMuchOfAll * whole)) continue;
    largest = high - low;
    step = low < best.discrepancy + kNearly * whole ? std::optional(i) : std::nullopt;
  }
  return step;
}

/// The best point of a line, dips included that are narrower than its steps: where a cause takes all echoes of a
/// sample, more of it changes nothing and seems best, and what takes nearly all of them lies just beside that.
Point withDips(const Objective& objective, const std::vector<Point>& even, const Point& best) {
  constexpr int kParts = 12;
  constexpr std::uintmax_t kTrials = 10;
  const std::optional<std::size_t> abrupt = abruptStep(even, best);
  if (!abrupt) return best;
  const double from = even[*abrupt].unit[0], part = (even[*abrupt + 1].unit[0] - from) / kParts;
  Point nearest = best;
  for (int p = 1; p < kParts; ++p) {
    const std::vector<double> unit{from + p * part};
    const double discrepancy = objective(unit);
    if (discrepancy < nearest.discrepancy) nearest = {unit, discrepancy};
  }
  if (nearest.unit == best.unit) return best;
  const Point dip = lowestBetween(objective, nearest.unit[0] - part, nearest.unit[0] + part, kTrials);
  return dip.discrepancy < nearest.discrepancy ? dip : nearest;
}

/// What lies between a place where a cause does nothing and one where it does far too much: what it does first may be
/// right. Halves the distance until it meets something better than nothing, or the places are next to each other.
Point atOnset(const Objective& objective, Point nothing, Point too_much) {
  constexpr double kNext = 1e-4;  // of the line
  constexpr std::uintmax_t kTrials = 10;
  while (std::abs(too_much.unit[0] - nothing.unit[0]) > kNext) {
    Point middle{{0.5 * (nothing.unit[0] + too_much.unit[0])}};
    middle.discrepancy = objective(middle.unit);
    if (middle.discrepancy < nothing.discrepancy) {
      const auto [low, high] = std::minmax(nothing.unit[0], too_much.unit[0]);
      Point dip = lowestBetween(objective, low, high, kTrials);
      return dip.discrepancy < middle.discrepancy ? dip : middle;
    }
    (middle.discrepancy == nothing.discrepancy ? nothing : too_much) = std::move(middle);
  }
  return nothing;
}

/// The best point of a line, if it is no better than those where the cause does nothing: what is between them and the
/// next ones (an aperture that begins to take echoes does so within half a millimetre).
Point withOnsets(const Objective& objective, std::vector<Point> points, const Point& best) {
  std::sort(points.begin(), points.end(), [](const Point& a, const Point& b) { return a.unit < b.unit; });
  Point nearest = best;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const Point &a = points[i], &b = points[i + 1];
    const bool left = a.discrepancy == best.discrepancy, right = b.discrepancy == best.discrepancy;
    if (left == right || (left ? i == 0 : i + 2 == points.size())) continue;
    const bool flat = points[left ? i - 1 : i + 2].discrepancy == best.discrepancy;
    if (!flat) continue;
    Point onset = left ? atOnset(objective, a, b) : atOnset(objective, b, a);
    if (onset.discrepancy < nearest.discrepancy) nearest = std::move(onset);
  }
  return nearest;
}

/// Nearer to the start again where a wide search leads away from a dip that was known.
Point refineOne(const Objective& objective, double start, double reach) {
  constexpr std::uintmax_t kTrials = 24;
  constexpr double kNearer = 0.15;
  constexpr int kSearches = 3;
  const double known = objective({start});
  for (int search = 0; search < kSearches; ++search, reach *= kNearer) {
    Point found = lowestBetween(objective, std::max(0.0, start - reach), std::min(1.0, start + reach), kTrials);
    if (found.discrepancy < known) return found;
  }
  return {{start}, known};
}

/// A number that stays where it is, in the unit cube.
struct Held {
  std::size_t index;
  double unit;
};

struct OptimiserCall {
  const Objective* objective;
  const std::vector<Held>* held;
  std::exception_ptr error;
  nlopt_opt optimiser;

  [[nodiscard]] std::vector<double> unitOf(std::vector<double> place) const {
    std::vector<double> unit = objective->edges().unitOf(std::move(place));
    for (const Held& one : *held) unit[one.index] = one.unit;
    return unit;
  }
};

double onTrial(unsigned n, const double* x, double*, void* data) {
  auto& call = *static_cast<OptimiserCall*>(data);
  try {
    return (*call.objective)(call.unitOf({x, x + n}));
  } catch (...) {
    call.error = std::current_exception();  // must not pass through C
    nlopt_force_stop(call.optimiser);
    return std::numeric_limits<double>::max();
  }
}

/// An algorithm of NLopt, and when it ends: after so many trials, or when it moves less in the unit cube, or gains
/// less.
struct Search {
  nlopt_algorithm algorithm;
  double first_step;
  int trials;
  double least_step;
  double least_gain = 0.0;
};

Point searchedBy(const Search& search, const Objective& objective, std::vector<double> start,
                 const std::vector<Held>& held = {}) {
  const auto n = static_cast<unsigned>(start.size());
  const std::unique_ptr<nlopt_opt_s, void (*)(nlopt_opt)> optimiser(nlopt_create(search.algorithm, n), nlopt_destroy);
  OptimiserCall call{&objective, &held, nullptr, optimiser.get()};
  nlopt_set_min_objective(optimiser.get(), onTrial, &call);
  for (unsigned i = 0; i < n; ++i) {
    const double beyond = objective.edges().isEdge(i) ? 0.5 : 0.0;
    nlopt_set_lower_bound(optimiser.get(), static_cast<int>(i), -beyond);
    nlopt_set_upper_bound(optimiser.get(), static_cast<int>(i), 1.0 + beyond);
  }
  nlopt_set_initial_step(optimiser.get(), objective.firstSteps(search.first_step).data());
  nlopt_set_xtol_abs1(optimiser.get(), search.least_step);
  nlopt_set_ftol_rel(optimiser.get(), 0.2 * search.least_step);
  nlopt_set_ftol_abs(optimiser.get(), search.least_gain);
  nlopt_set_maxeval(optimiser.get(), search.trials);
  for (double& x : start) x = std::clamp(x, 1e-3, 1.0 - 1e-3);
  std::vector<double> place = objective.edges().edgesOf(std::move(start));
  for (const Held& one : held) {  // NLopt leaves out what has no room
    nlopt_set_lower_bound(optimiser.get(), static_cast<int>(one.index), place[one.index]);
    nlopt_set_upper_bound(optimiser.get(), static_cast<int>(one.index), place[one.index]);
  }
  double best = 0.0;
  nlopt_optimize(optimiser.get(), place.data(), &best);
  if (call.error) std::rethrow_exception(call.error);
  return {call.unitOf(std::move(place)), best};
}

Search subplex(const Reach& reach) { return {NLOPT_LN_SBPLX, reach.step, reach.trials, 5e-4}; }

/// A count is one more or one less at once, and the other numbers follow it: no small step leads there. Goes on while
/// that leads on.
Point withOtherCounts(const Objective& objective, Point best, const Reach& reach, const std::vector<Held>& held) {
  constexpr int kMostSteps = 6;
  for (const std::size_t count : objective.counts()) {
    for (const double one : {1.0, -1.0}) {
      for (int step = 0; step < kMostSteps; ++step) {
        std::vector<double> values = objective.valuesAt(best.unit);
        values[count] += one;
        const std::vector<double> start = objective.unitOf(values);
        std::vector<Held> all = held;
        all.push_back({count, start[count]});
        Point other = searchedBy(subplex(reach), objective, start, all);
        if (other.discrepancy >= best.discrepancy) break;
        best = std::move(other);
      }
    }
  }
  return best;
}

std::vector<Held> heldAt(const std::vector<std::size_t>& numbers, const std::vector<double>& unit) {
  std::vector<Held> held;
  for (const std::size_t i : numbers) held.push_back({i, unit[i]});
  return held;
}

/// The numbers that stay where they are when a valley is followed.
std::vector<Held> heldInValley(const Objective& objective, const std::vector<double>& start) {
  std::vector<std::size_t> numbers = objective.thatJump();
  const std::vector<std::size_t> tracing = objective.thatTraceAnew(start);
  numbers.insert(numbers.end(), tracing.begin(), tracing.end());
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  return heldAt(numbers, start);
}

/// The numbers that stay where they are because every look would trace anew.
std::vector<Held> heldBy(const Objective& objective, const std::vector<double>& start, const Reach& reach) {
  if (!reach.holds_rays) return {};
  const std::vector<std::size_t> tracing = objective.thatTraceAnew(start);
  return tracing.size() < start.size() ? heldAt(tracing, start) : std::vector<Held>();
}

}  // namespace

Objective::Objective(const Replay& replay, const Hypothesis& hypothesis, Evidence evidence,
                     const core::Progress& progress)
    : replay_(replay),
      hypothesis_(hypothesis),
      evidence_(std::move(evidence)),
      progress_(progress),
      cube_(hypothesis.parameters),
      edges_(hypothesis.parameters) {}

double Objective::operator()(const std::vector<double>& unit) const {
  core::stopIfCancelled(progress_);
  return discrepancyOf(replay_, worldOf(replay_, hypothesis_, valuesAt(unit)), evidence_);
}

std::vector<double> Objective::firstSteps(double step) const {
  std::vector<double> steps;
  for (const FreeParameter& p : hypothesis_.parameters) {
    const bool angle = p.azimuth || edges_.isEdge(steps.size());
    steps.push_back(angle ? kUsualStep_deg * step / kUsualStep / (p.high - p.low) : step);
  }
  return steps;
}

std::vector<std::size_t> Objective::counts() const {
  std::vector<std::size_t> counts;
  for (std::size_t i = 0; i < hypothesis_.parameters.size(); ++i)
    if (hypothesis_.parameters[i].whole) counts.push_back(i);
  return counts;
}

std::vector<std::size_t> Objective::thatJump() const {
  std::vector<std::size_t> numbers;
  for (std::size_t i = 0; i < hypothesis_.parameters.size(); ++i)
    if (jumps(hypothesis_.parameters[i]) || edges_.isEdge(i)) numbers.push_back(i);
  return numbers;
}

bool jumps(const FreeParameter& number) { return number.azimuth || number.whole; }

bool smooth(const Hypothesis& hypothesis) {
  return std::none_of(hypothesis.parameters.begin(), hypothesis.parameters.end(), jumps);
}

std::vector<std::size_t> Objective::thatTraceAnew(const std::vector<double>& unit) const {
  constexpr double kElsewhere = 0.25;
  if (evidence_.samples.empty()) return {};
  const model::Sample& sample = *replay_.samples()[evidence_.samples.front()].sample;
  const auto keyAt = [&](const std::vector<double>& place) {
    return geometryKey(worldOf(replay_, hypothesis_, valuesAt(place)), sample);
  };
  const auto key = keyAt(unit);
  std::vector<std::size_t> numbers;
  for (std::size_t i = 0; i < unit.size(); ++i) {
    std::vector<double> other = unit;
    other[i] += other[i] < 0.5 ? kElsewhere : -kElsewhere;
    if (keyAt(other) != key) numbers.push_back(i);
  }
  return numbers;
}

std::vector<std::vector<double>> evenPoints(std::size_t dimensions, unsigned count) {
  constexpr unsigned kBases[] = {2, 3, 5, 7, 11, 13};
  std::vector<std::vector<double>> points;
  for (unsigned n = 0; n < count; ++n) {
    std::vector<double> point;
    for (std::size_t d = 0; d < dimensions; ++d) {
      point.push_back(dimensions == 1 ? (n + 0.5) / count : vanDerCorput(n + 1, kBases[d % 6]));
    }
    points.push_back(point);
  }
  return points;
}

Point coarseSearch(const Objective& objective, const std::vector<std::vector<double>>& starts) {
  std::vector<std::vector<double>> points;
  for (const auto& start : starts) points.push_back(objective.unitOf(start));
  const auto even_points = evenPoints(objective.dimensions(), coarseCount(objective.dimensions()));
  points.insert(points.end(), even_points.begin(), even_points.end());
  std::vector<Point> looked_at;
  for (const auto& point : points) looked_at.push_back({point, objective(point)});
  if (objective.dimensions() == 1) {
    for (const double end : {0.0, 1.0}) looked_at.push_back({{end}, objective({end})});
    std::vector<Point> even = looked_at;
    std::sort(even.begin(), even.end(), [](const Point& a, const Point& b) { return a.unit < b.unit; });
    lookBetween(objective, looked_at);
    return withDips(objective, even, withOnsets(objective, looked_at, middleOfBest(looked_at)));
  }
  return *std::min_element(looked_at.begin(), looked_at.end(),
                           [](const Point& a, const Point& b) { return a.discrepancy < b.discrepancy; });
}

Point searched(const Objective& objective, const std::vector<double>& start, const Reach& reach) {
  if (start.size() == 1) return refineOne(objective, start[0], reach.line);
  const std::vector<Held> held = heldBy(objective, start, reach);
  const Point near = searchedBy(subplex(reach), objective, start, held);
  Point refined = withOtherCounts(objective, near, reach, held);
  Point at_start{start, objective(start)};
  return refined.discrepancy < at_start.discrepancy ? refined : at_start;
}

Point walkedFrom(const Objective& objective, Point start, double first_step, int trials) {
  constexpr int kWalks = 3, kMostWalks = 12;
  constexpr double kFar = 0.05;                        // of what is left: who gains so much has not arrived
  constexpr double kLeadsOn = 0.5, kLeastStep = 5e-5;  // nats, of the unit cube
  constexpr double kOfWhatIsLeft = 0.002;  // where much is left that no number explains, half a nat is next to nothing
  constexpr double kLeastGain = 0.1;       // of what leads on: a walk ends
  const std::vector<Held> held = heldInValley(objective, start.unit);
  if (start.unit.size() < held.size() + 2) return start;
  Point place = std::move(start);
  const double leads_on = std::max(kLeadsOn, kOfWhatIsLeft * place.discrepancy);
  double gained = leads_on;
  const auto arrived = [&](int walks) { return walks >= kWalks && gained < kFar * place.discrepancy; };
  for (int walk = 0; walk < kMostWalks && gained >= leads_on && !arrived(walk); ++walk) {
    Point further = searchedBy({NLOPT_LN_NELDERMEAD, first_step, trials, kLeastStep, kLeastGain * leads_on}, objective,
                               place.unit, held);
    gained = place.discrepancy - further.discrepancy;
    if (gained > 0.0) place = std::move(further);
  }
  return place;
}

}  // namespace gap
