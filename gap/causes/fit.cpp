#include "gap/causes/fit.h"

#include <algorithm>
#include <cmath>

#include "gap/causes/search.h"

namespace gap {

namespace {

constexpr Reach kNear{.line = 0.12, .step = 0.06, .trials = 70};  // of the coarse optimum
/// Of values that are nearly right: more frames.
constexpr Reach kFine{.line = 0.04, .step = 0.02, .trials = 40};
constexpr int kTrialsInValley = 60;
constexpr Reach kRough{.line = 0.12, .step = 0.06, .trials = 24, .holds_rays = true};  // is a better fit worth it?
constexpr unsigned kPlacesOfOne = 7;  // all over the range of a cause with one number
constexpr unsigned kPlacesOfSeveral = 10;
constexpr int kCoarseFrames = 3;
constexpr double kSharesOfMost[] = {0.003, 0.01, 0.03, 0.1, 0.3};  // at which one number of several is tried alone

Evidence onFewFrames(const Evidence& evidence) {
  return spreadOver(evidence, evidence.samples.size(), std::min(evidence.most_frames, kCoarseFrames));
}

Evidence fewOf(const Evidence& evidence) {
  return onFewFrames(spreadOver(evidence, kScoutedSamples, evidence.most_frames));
}

constexpr Reach holdingRays(Reach reach) {
  reach.holds_rays = true;
  return reach;
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

/// One number of several alone, the others off: an effect may have several mechanisms, of which only one is at work,
/// and an even search of the whole range never meets that. Empty if some number has no "off".
std::vector<std::vector<double>> oneByOne(const Hypothesis& hypothesis) {
  const auto& parameters = hypothesis.parameters;
  const auto hasOff = [](const FreeParameter& p) {
    return !p.azimuth && (p.low <= 0.0 || (p.logarithmic && p.low < 0.001 * p.high));
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
    const Evidence own = fewOf(onSetup(replay, evidence, hypothesis.parameters[i].name));
    if (own.samples.empty()) {
      scouted.values.push_back(0.0);
      continue;
    }
    const Scouted scouted_setup = scout(replay, alone(hypothesis, i), own, {}, progress);
    const double at_first = discrepancyOf(replay, replay.baseline(), own);
    before += at_first;
    gone += scouted_setup.gain * at_first;
    scouted.values.push_back(scouted_setup.values[0]);
  }
  scouted.gain = before > 0.0 ? gone / before : 0.0;
  return scouted;
}

/// The values of every set-up after a search of its own.
template <typename Search>
std::vector<double> setupBySetup(const Replay& replay, const Hypothesis& hypothesis, const Evidence& evidence,
                                 std::vector<double> values, const Search& search) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    const Evidence own = onSetup(replay, evidence, hypothesis.parameters[i].name);
    if (!own.samples.empty()) values[i] = search(alone(hypothesis, i), own, std::vector<double>{values[i]})[0];
  }
  return values;
}

}  // namespace

Scouted scout(const Replay& replay, const Hypothesis& hypothesis, const Evidence& evidence,
              const std::vector<std::vector<double>>& starts, const core::Progress& progress, const World* known) {
  if (hypothesis.per_setup) return scoutSetups(replay, hypothesis, evidence, progress);
  const Evidence few = onFewFrames(evidence);
  const double before = discrepancyOf(replay, known != nullptr ? *known : replay.baseline(), few);
  const auto gain = [&](double after) { return before > 0.0 ? 1.0 - after / before : 0.0; };
  const Objective objective(replay, hypothesis, few, progress);
  if (objective.dimensions() == 0) return {{}, gain(objective({}))};
  // Of values that do nothing on these samples the first is kept: what the map suggests, which has seen others, too.
  std::vector<std::vector<double>> all = starts;
  const auto single_numbers = oneByOne(hypothesis);
  all.insert(all.end(), single_numbers.begin(), single_numbers.end());
  std::vector<double> typical;
  for (const FreeParameter& parameter : hypothesis.parameters) typical.push_back(parameter.start);
  all.push_back(typical);
  const Point best = coarseSearch(objective, all);
  if (objective.dimensions() == 1 && !starts.empty()) {  // a line search takes the middle of what is equally good
    const double at_start = objective(objective.unitOf(starts.front()));
    if (at_start <= best.discrepancy) return {starts.front(), gain(at_start)};
  }
  return {objective.valuesAt(best.unit), gain(best.discrepancy)};
}

std::vector<double> refine(const Replay& replay, const Hypothesis& hypothesis, const Evidence& evidence,
                           const std::vector<double>& values, const core::Progress& progress) {
  if (values.size() < 2 || hypothesis.per_setup) return refineBriefly(replay, hypothesis, evidence, values, progress);
  const Objective objective(replay, hypothesis, evidence, progress);
  const Point near = searched(objective, objective.unitOf(values), kFine);
  return objective.valuesAt(walkedFrom(objective, near, kFine.step, kTrialsInValley).unit);
}

std::vector<double> refineBriefly(const Replay& replay, const Hypothesis& hypothesis, const Evidence& evidence,
                                  const std::vector<double>& values, const core::Progress& progress) {
  if (values.empty()) return values;
  if (hypothesis.per_setup)
    return setupBySetup(replay, hypothesis, evidence, values, [&](const auto& one, const auto& own, const auto& start) {
      return refineBriefly(replay, one, own, start, progress);
    });
  const Objective objective(replay, hypothesis, evidence, progress);
  return objective.valuesAt(searched(objective, objective.unitOf(values), kFine).unit);
}

std::vector<double> refineAlongValley(const Replay& replay, const Hypothesis& hypothesis, const Evidence& evidence,
                                      const std::vector<double>& values, const core::Progress& progress) {
  if (values.size() < 2 || hypothesis.per_setup) return values;
  const Objective objective(replay, hypothesis, evidence, progress);
  const std::vector<double> unit = objective.unitOf(values);
  return objective.valuesAt(walkedFrom(objective, {unit, objective(unit)}, kFine.step, kTrialsInValley).unit);
}

std::vector<double> fitFrom(const Replay& replay, const Hypothesis& hypothesis, const Evidence& evidence,
                            const std::vector<double>& start, const core::Progress& progress) {
  if (start.empty()) return start;
  if (hypothesis.per_setup)
    return setupBySetup(replay, hypothesis, evidence, start, [&](const auto& one, const auto& own, const auto& from) {
      return fitFrom(replay, one, own, from, progress);
    });
  const Objective objective(replay, hypothesis, evidence, progress);
  std::vector<double> unit = objective.unitOf(start);
  // Of two causes of which one sends the rays other ways, that one was fitted alone, and the other one follows first.
  const std::size_t tracing = hypothesis.members.empty() ? 0 : objective.thatTraceAnew(unit).size();
  if (tracing > 0 && tracing < unit.size()) unit = searched(objective, unit, holdingRays(kNear)).unit;
  return objective.valuesAt(searched(objective, unit, kNear).unit);
}

std::vector<double> roughFitFrom(const Replay& replay, const Hypothesis& hypothesis, const Evidence& evidence,
                                 const std::vector<double>& start, const core::Progress& progress) {
  if (start.empty()) return start;
  const Objective objective(replay, hypothesis, fewOf(evidence), progress);
  return objective.valuesAt(searched(objective, objective.unitOf(start), kRough).unit);
}

double resolvedAt(const FreeParameter& parameter, double value) {
  if (parameter.whole) return 0.5;
  const Scale scale(parameter);
  const double step = std::ldexp(1.0, -kLineBits), unit = scale.toUnit(value);
  return 0.5 * (scale.toValue(unit + step) - scale.toValue(unit - step));
}

std::vector<std::vector<double>> valuesAllOver(const Hypothesis& hypothesis) {
  const std::size_t dimensions = hypothesis.parameters.size();
  if (dimensions == 0) return {};
  const UnitCube cube(hypothesis.parameters);
  std::vector<std::vector<double>> points = evenPoints(dimensions, dimensions == 1 ? kPlacesOfOne : kPlacesOfSeveral);
  for (auto& point : points) point = cube.valuesAt(point);
  return points;
}

}  // namespace gap
