#include "gap/causes/fit.h"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <limits>
#include <memory>
#include <nlopt.h>
#include <optional>

#include "gap/causes/scale.h"
#include "gap/distance/settle.h"

namespace gap {

namespace {

constexpr int kRefinements = 70;      // evaluations of the refinement with several parameters
constexpr int kFineRefinements = 40;  // of values that are nearly right, with more frames
constexpr int kRoughTrials = 24;      // of a fit that is only to show whether a better one is worth it
constexpr int kBrentBits = 13;        // 1e-4 of the scaled range: coarser, and refits would end where they began
constexpr unsigned kPlacesOfOne = 7;  // all over the range of a cause with one number
constexpr unsigned kPlacesOfSeveral = 10;
constexpr std::size_t kCoarseSamples = 4;
constexpr int kCoarseFrames = 3;
constexpr int kHalvings = 3;                                       // of the steps of a search along a line
constexpr double kSharesOfMost[] = {0.003, 0.01, 0.03, 0.1, 0.3};  // at which one number of several is tried alone
constexpr double kFirstStep = 0.06;                                // of the scaled range
constexpr double kFirstStep_deg = 1.5;
constexpr double kReach = 0.12;      // of the scaled range, to both sides of the coarse optimum
constexpr double kFineReach = 0.04;  // of values that are nearly right
constexpr double kFineStep = 0.02;

/// n-th element of the van der Corput sequence in a base: together a Halton sequence, even and deterministic.
double vanDerCorput(unsigned n, unsigned base) {
  double value = 0.0, part = 1.0;
  for (; n > 0; n /= base) {
    part /= base;
    value += part * (n % base);
  }
  return value;
}

std::vector<std::vector<double>> coarsePoints(std::size_t dimensions, unsigned count) {
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

unsigned coarseCount(std::size_t dimensions) { return dimensions == 1 ? 14 : dimensions == 2 ? 24 : 40; }

/// The objective on the unit cube.
class Objective {
 public:
  Objective(const Replay& replay, const Hypothesis& hypothesis, const Evidence& evidence,
            const core::Progress& progress)
      : replay_(replay),
        hypothesis_(hypothesis),
        evidence_(evidence),
        progress_(progress),
        cube_(hypothesis.parameters) {}

  [[nodiscard]] std::vector<double> valuesAt(const std::vector<double>& unit) const { return cube_.valuesAt(unit); }
  [[nodiscard]] std::vector<double> unitOf(const std::vector<double>& values) const { return cube_.unitOf(values); }
  [[nodiscard]] double operator()(const std::vector<double>& unit) const {
    core::stopIfCancelled(progress_);
    return discrepancyOf(replay_, worldOf(replay_, hypothesis_, valuesAt(unit)), evidence_);
  }
  /// In the unit cube. Ends of a sector are searched within a few degrees of their start: beyond, nothing leads back.
  [[nodiscard]] std::vector<double> firstSteps(double step) const {
    std::vector<double> steps;
    for (const FreeParameter& p : hypothesis_.parameters) {
      steps.push_back(isAzimuth(p) ? kFirstStep_deg * step / kFirstStep / (p.high - p.low) : step);
    }
    return steps;
  }
  [[nodiscard]] std::size_t dimensions() const { return hypothesis_.parameters.size(); }

 private:
  const Replay& replay_;
  const Hypothesis& hypothesis_;
  Evidence evidence_;
  const core::Progress& progress_;
  UnitCube cube_;
};

/// A few samples are enough to find the neighbourhood.
Evidence fewOf(const Evidence& evidence) {
  return spreadOver(evidence, kCoarseSamples, std::min(evidence.most_frames, kCoarseFrames));
}

struct Point {
  std::vector<double> unit;
  double discrepancy = std::numeric_limits<double>::infinity();
};

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
                                                                         high, kBrentBits, most_trials);
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

Point coarseSearch(const Objective& objective, const std::vector<std::vector<double>>& starts) {
  std::vector<std::vector<double>> points = coarsePoints(objective.dimensions(), coarseCount(objective.dimensions()));
  for (const auto& start : starts) points.push_back(objective.unitOf(start));
  std::vector<Point> looked_at;
  for (const auto& point : points) looked_at.push_back({point, objective(point)});
  if (objective.dimensions() == 1) {
    for (const double end : {0.0, 1.0}) looked_at.push_back({{end}, objective({end})});
    std::vector<Point> even = looked_at;
    std::sort(even.begin(), even.end(), [](const Point& a, const Point& b) { return a.unit < b.unit; });
    lookBetween(objective, looked_at);
    return withDips(objective, even, middleOfBest(looked_at));
  }
  return *std::min_element(looked_at.begin(), looked_at.end(),
                           [](const Point& a, const Point& b) { return a.discrepancy < b.discrepancy; });
}

/// Nearer to the start again where a wide search leads away from a dip that was known.
std::vector<double> refineOne(const Objective& objective, double start, double reach) {
  constexpr std::uintmax_t kTrials = 24;
  constexpr double kNearer = 0.15;
  constexpr int kSearches = 3;
  const double known = objective({start});
  for (int search = 0; search < kSearches; ++search, reach *= kNearer) {
    Point found = lowestBetween(objective, std::max(0.0, start - reach), std::min(1.0, start + reach), kTrials);
    if (found.discrepancy < known) return std::move(found.unit);
  }
  return {start};
}

struct SubplexCall {
  const Objective* objective;
  std::exception_ptr error;
  nlopt_opt optimiser;
};

double onSubplex(unsigned n, const double* x, double*, void* data) {
  auto& call = *static_cast<SubplexCall*>(data);
  try {
    return (*call.objective)(std::vector<double>(x, x + n));
  } catch (...) {
    call.error = std::current_exception();  // must not pass through C
    nlopt_force_stop(call.optimiser);
    return std::numeric_limits<double>::max();
  }
}

std::vector<double> refineSeveral(const Objective& objective, std::vector<double> start, double first_step,
                                  int most_trials) {
  const auto n = static_cast<unsigned>(start.size());
  const std::unique_ptr<nlopt_opt_s, void (*)(nlopt_opt)> optimiser(nlopt_create(NLOPT_LN_SBPLX, n), nlopt_destroy);
  SubplexCall call{&objective, nullptr, optimiser.get()};
  nlopt_set_min_objective(optimiser.get(), onSubplex, &call);
  nlopt_set_lower_bounds1(optimiser.get(), 0.0);
  nlopt_set_upper_bounds1(optimiser.get(), 1.0);
  nlopt_set_initial_step(optimiser.get(), objective.firstSteps(first_step).data());
  nlopt_set_xtol_abs1(optimiser.get(), 5e-4);
  nlopt_set_ftol_rel(optimiser.get(), 1e-4);
  nlopt_set_maxeval(optimiser.get(), most_trials);
  for (double& x : start) x = std::clamp(x, 1e-3, 1.0 - 1e-3);
  double best = 0.0;
  nlopt_optimize(optimiser.get(), start.data(), &best);
  if (call.error) std::rethrow_exception(call.error);
  return start;
}

/// The values that a bounded search around a point of the unit cube ends with.
std::vector<double> searched(const Objective& objective, const std::vector<double>& start, double reach, double step,
                             int most_trials = kRefinements) {
  if (start.size() == 1) return objective.valuesAt(refineOne(objective, start[0], reach));
  const std::vector<double> refined = refineSeveral(objective, start, step, most_trials);
  // A rugged objective may lead the refinement astray.
  return objective.valuesAt(objective(refined) < objective(start) ? refined : start);
}

/// The offset of one set-up alone, as a hypothesis with one number.
Hypothesis alone(const Hypothesis& hypothesis, std::size_t setup) {
  Hypothesis single = hypothesis;
  single.per_setup = false;
  single.parameters = {hypothesis.parameters[setup]};
  single.apply = [&hypothesis, setup](World& world, const std::vector<double>& value) {
    std::vector<double> all(hypothesis.parameters.size(), 0.0);
    all[setup] = value[0];
    hypothesis.apply(world, all);
  };
  return single;
}

Evidence onSetup(const Replay& replay, const Evidence& evidence, const std::string& setup) {
  Evidence own = evidence;
  std::erase_if(own.samples, [&](std::size_t s) { return replay.samples()[s].sample->setup != setup; });
  return own;
}

/// How many frames are simulated of a sample.
int simulatedFrames(const Evidence& evidence, const ReplaySample& sample) {
  const auto affordable = static_cast<int>(evidence.most_shots / std::max<std::size_t>(1, sample.beams.size()));
  return std::min({evidence.most_frames, std::max(3, sample.frames), std::max(3, affordable)});
}

std::vector<Comparison> comparisonsOf(const Replay& replay, const World& world, const Evidence& evidence) {
  std::vector<Comparison> comparisons;
  for (const std::size_t s : evidence.samples) {
    const ReplaySample& sample = replay.samples()[s];
    const int frames = simulatedFrames(evidence, sample);
    comparisons.push_back(
        {s, sample.statistics, sample.frames, replay.simulate(world, s, frames, evidence.seed), frames});
  }
  return comparisons;
}

double total(const Replay& replay, const World& world, std::vector<Comparison>& comparisons, Part part) {
  const double settling = settle(replay, world, comparisons, part);
  return settling + discrepancy(replay, comparisons, part);
}

/// One number of several alone, the others off: an effect may have several mechanisms, of which only one is at work,
/// and an even search of the whole range never meets that. Empty if some number has no "off".
std::vector<std::vector<double>> oneByOne(const Hypothesis& hypothesis) {
  const auto& parameters = hypothesis.parameters;
  const auto hasOff = [](const FreeParameter& p) {
    return !isAzimuth(p) && (p.low <= 0.0 || (p.logarithmic && p.low < 0.001 * p.high));
  };
  if (parameters.size() < 2 || !std::all_of(parameters.begin(), parameters.end(), hasOff)) return {};
  std::vector<double> off;
  for (const FreeParameter& p : parameters) off.push_back(std::max(0.0, p.low));
  std::vector<std::vector<double>> points;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    for (const double share : kSharesOfMost) {
      for (const double most : {parameters[i].high, parameters[i].low}) {
        if (most == parameters[i].low && most >= 0.0) continue;
        points.push_back(off);
        points.back()[i] = std::clamp(share * most, parameters[i].low, parameters[i].high);
      }
    }
  }
  return points;
}

Scouted scoutSetups(const Replay& replay, const Hypothesis& hypothesis, const Evidence& evidence,
                    const core::Progress& progress) {
  Scouted scouted;
  double before = 0.0, gone = 0.0;
  for (std::size_t i = 0; i < hypothesis.parameters.size(); ++i) {
    const Evidence own = onSetup(replay, evidence, hypothesis.parameters[i].name);
    if (own.samples.empty()) {
      scouted.values.push_back(0.0);
      continue;
    }
    const Scouted scouted_setup = scout(replay, alone(hypothesis, i), own, {}, progress);
    const double at_first = discrepancyOf(replay, replay.baseline(), fewOf(own));
    before += at_first;
    gone += scouted_setup.gain * at_first;
    scouted.values.push_back(scouted_setup.values[0]);
  }
  scouted.gain = before > 0.0 ? gone / before : 0.0;
  return scouted;
}

std::vector<double> fitSetups(const Replay& replay, const Hypothesis& hypothesis, const Evidence& evidence,
                              std::vector<double> values, const core::Progress& progress) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    const Evidence own = onSetup(replay, evidence, hypothesis.parameters[i].name);
    if (!own.samples.empty()) values[i] = fitFrom(replay, alone(hypothesis, i), own, {values[i]}, progress)[0];
  }
  return values;
}

}  // namespace

Evidence spreadOver(const Evidence& evidence, std::size_t most_samples, int most_frames) {
  Evidence few = evidence;
  few.most_frames = most_frames;
  if (evidence.samples.size() <= most_samples) return few;
  few.samples.clear();
  for (std::size_t i = 0; i < most_samples; ++i) {
    few.samples.push_back(evidence.samples[i * (evidence.samples.size() - 1) / (most_samples - 1)]);
  }
  return few;
}

World worldOf(const Replay& replay, const Hypothesis& hypothesis, const std::vector<double>& values) {
  World world = replay.baseline();
  hypothesis.apply(world, values);
  return world;
}

double discrepancyOf(const Replay& replay, const World& world, const Evidence& evidence) {
  std::vector<Comparison> comparisons = comparisonsOf(replay, world, evidence);
  return total(replay, world, comparisons, evidence.part);
}

double discrepancyTo(const Replay& replay, const World& world, const Evidence& evidence,
                     std::span<const std::vector<CellStatistics>> measured) {
  std::vector<Comparison> comparisons = comparisonsOf(replay, world, evidence);
  for (std::size_t i = 0; i < comparisons.size(); ++i) comparisons[i].measured = measured[i];
  return total(replay, world, comparisons, evidence.part);
}

double discrepancyIn(const Replay& replay, const World& truth, const World& world, const Evidence& evidence,
                     std::uint64_t seed) {
  std::vector<Comparison> measured;
  for (const std::size_t s : evidence.samples) {
    const int frames = replay.samples()[s].frames;
    measured.push_back({s, {}, frames, replay.simulate(truth, s, frames, seed), frames});
  }
  scatter(replay, truth, measured, seed);
  std::vector<Comparison> comparisons = comparisonsOf(replay, world, evidence);
  for (std::size_t i = 0; i < comparisons.size(); ++i) comparisons[i].measured = measured[i].simulated;
  return total(replay, world, comparisons, evidence.part);
}

Scouted scout(const Replay& replay, const Hypothesis& hypothesis, const Evidence& evidence,
              const std::vector<std::vector<double>>& starts, const core::Progress& progress) {
  if (hypothesis.per_setup) return scoutSetups(replay, hypothesis, evidence, progress);
  const Evidence few = fewOf(evidence);
  const double before = discrepancyOf(replay, replay.baseline(), few);
  const auto gain = [&](double after) { return before > 0.0 ? 1.0 - after / before : 0.0; };
  const Objective objective(replay, hypothesis, few, progress);
  if (objective.dimensions() == 0) return {{}, gain(objective({}))};
  std::vector<std::vector<double>> all = oneByOne(hypothesis);
  all.insert(all.end(), starts.begin(), starts.end());
  std::vector<double> typical;
  for (const FreeParameter& parameter : hypothesis.parameters) typical.push_back(parameter.start);
  all.push_back(typical);
  const Point best = coarseSearch(objective, all);
  return {objective.valuesAt(best.unit), gain(best.discrepancy)};
}

std::vector<double> refine(const Replay& replay, const Hypothesis& hypothesis, const Evidence& evidence,
                           const std::vector<double>& values, const core::Progress& progress) {
  if (hypothesis.per_setup || values.empty()) return values;
  const Objective objective(replay, hypothesis, evidence, progress);
  return searched(objective, objective.unitOf(values), kFineReach, kFineStep, kFineRefinements);
}

std::vector<double> fitFrom(const Replay& replay, const Hypothesis& hypothesis, const Evidence& evidence,
                            const std::vector<double>& start, const core::Progress& progress) {
  if (start.empty()) return start;
  if (hypothesis.per_setup) return fitSetups(replay, hypothesis, evidence, start, progress);
  const Objective objective(replay, hypothesis, evidence, progress);
  return searched(objective, objective.unitOf(start), kReach, kFirstStep);
}

std::vector<double> roughFitFrom(const Replay& replay, const Hypothesis& hypothesis, const Evidence& evidence,
                                 const std::vector<double>& start, const core::Progress& progress) {
  if (start.empty()) return start;
  const Objective objective(replay, hypothesis, fewOf(evidence), progress);
  return searched(objective, objective.unitOf(start), kReach, kFirstStep, kRoughTrials);
}

double resolvedAt(const FreeParameter& parameter, double value) {
  if (parameter.whole) return 0.5;
  const Scale scale(parameter);
  const double step = std::ldexp(1.0, -kBrentBits), unit = scale.toUnit(value);
  return 0.5 * (scale.toValue(unit + step) - scale.toValue(unit - step));
}

std::vector<std::vector<double>> valuesAllOver(const Hypothesis& hypothesis) {
  const std::size_t dimensions = hypothesis.parameters.size();
  if (dimensions == 0) return {};
  const UnitCube cube(hypothesis.parameters);
  std::vector<std::vector<double>> points = coarsePoints(dimensions, dimensions == 1 ? kPlacesOfOne : kPlacesOfSeveral);
  for (auto& point : points) point = cube.valuesAt(point);
  return points;
}

}  // namespace gap
