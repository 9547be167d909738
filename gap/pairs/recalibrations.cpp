#include "gap/pairs/recalibrations.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include "core/parallel.h"

namespace gap {

namespace {

constexpr std::size_t kHiddenFitted = 8;   // effects that a recalibration may hide,
constexpr std::size_t kHiddenInMeans = 6;  // and such that few outlying cells hide as well,
constexpr std::size_t kHiddenByAll = 3;    // and such that all data show, of which
constexpr std::size_t kAskedAlong = 5;     // places are asked, all along the values of the parameter
constexpr double kAlikeAlong = 30.0;       // nats: so alike are they by what few data and sums of shifts say

/// Of what is recorded of a parameter; between two of them shifts are interpolated.
constexpr double kRecalibrations[] = {1.02, 1.05, 1.1, 1.2, 1.4, 1.7, 2.2};
constexpr int kPartsOfAStep = 4;

double squaredDistance(const Eigen::VectorXf& shifts) { return counted(shifts).squaredNorm(); }

/// How far shifts are from none, as a Cauchy distribution sees it (Holland, Welsch 1977, Robust regression using
/// iteratively reweighted least-squares, Communications in Statistics A6, 813-827: 2.385 errors). A few cells with one
/// echo or none differ by ten errors by chance: squared, they hide what a thousand others say.
double robustDistance(const Eigen::VectorXf& shifts) {
  constexpr float kScale = 2.385F;
  return static_cast<double>((1.0F + (shifts.array() / kScale).square()).log().sum());
}

/// A value of a parameter so far on the way from one to another.
double between(const FreeParameter& parameter, double from, double to, float part) {
  const auto share = static_cast<double>(part);
  return parameter.logarithmic ? from * std::pow(to / from, share) : std::lerp(from, to, share);
}

/// Of the guesses with one first cause the nearer one stays.
void keepNearer(Guess guess, std::map<std::size_t, Guess>& nearest) {
  const auto [known, added] = nearest.try_emplace(guess.first, guess);
  if (!added && guess.distance < known->second.distance) known->second = std::move(guess);
}

/// Guesses, nearest first: with every first cause the nearest one, and all others.
struct Parted {
  std::vector<Guess> nearest, others;
};
Parted partedByFirst(std::vector<Guess> guesses) {
  std::set<std::size_t> taken;
  Parted parted;
  for (Guess& guess : nearestOf(std::move(guesses), guesses.size()))
    (taken.insert(guess.first).second ? parted.nearest : parted.others).push_back(std::move(guess));
  return parted;
}

}  // namespace

Recalibrations::Recalibrations(const Looks& looks) : looks_(looks) { findSpans(); }

const Hypothesis& Recalibrations::hypothesisOf(const Looks::Atom& atom) const {
  return looks_.singles()[atom.single].hypothesis;
}

Recalibrations::Hidden Recalibrations::hidden() const {
  std::vector<std::size_t> parameters;
  for (std::size_t i = 0; i < looks_.singles().size(); ++i)
    if (looks_.singles()[i].hypothesis.kind == CauseKind::kParameter) parameters.push_back(i);
  std::vector<std::vector<Guess>> squared(parameters.size()), robust(parameters.size());
  core::parallelFor(parameters.size(), 1, [&](std::size_t p, std::size_t) {
    const std::vector<Step> steps = stepsOf(parameters[p]);
    squared[p] = hiddenBy(parameters[p], steps, {squaredDistance, false});
    robust[p] = hiddenBy(parameters[p], steps, {robustDistance, true});
  });
  // Spreads are few entries, which say most of what scatters; means of cells are many.
  std::vector<Guess> by_spreads, by_means;
  for (auto& some : squared) append(by_spreads, std::move(some));
  by_spreads = looks_.lookedAt(nearestOf(partedByFirst(std::move(by_spreads)).nearest, kHiddenFitted));
  for (auto& some : robust) append(by_means, std::move(some));
  Parted means = partedByFirst(looks_.lookedAt(std::move(by_means)));
  return {std::move(by_spreads), nearestOf(std::move(means.nearest), kHiddenInMeans),
          nearestOf(partedByFirst(std::move(means.others)).nearest, kHiddenInMeans)};
}

void Recalibrations::findSpans() {
  std::map<std::size_t, std::map<double, std::size_t>> by_value;
  for (std::size_t a = 0; a < looks_.atoms().size(); ++a) {
    const Looks::Atom& atom = looks_.atoms()[a];
    const Hypothesis& hypothesis = hypothesisOf(atom);
    const bool one_number = hypothesis.parameters.size() == 1 && !hypothesis.parameters.front().whole;
    if (hypothesis.kind == CauseKind::kEffect && one_number) by_value[atom.single].emplace(atom.values[0], a);
  }
  for (const auto& [single, places] : by_value) {
    for (auto to = std::next(places.begin()); to != places.end(); ++to)
      spans_.push_back({std::prev(to)->second, to->second});
  }
}

/// Of every effect the place that was looked at whose shifts come nearest to the measurement beside those of the
/// parameter.
Recalibrations::Nearest Recalibrations::nearestBeside(std::size_t parameter, const Step& step, Farness farness) const {
  const Eigen::VectorXf left = columnOf(looks_.space().ofMeasurement()) - step.shifts;
  Nearest nearest;
  for (std::size_t a = 0; a < looks_.atoms().size(); ++a) {
    const Looks::Atom& atom = looks_.atoms()[a];
    if (hypothesisOf(atom).kind != CauseKind::kEffect) continue;
    const double distance = farness(left - looks_.shifts().col(static_cast<Eigen::Index>(a)));
    keepNearer({atom.single, parameter, joined(atom.values, {step.value}), distance}, nearest);
  }
  return nearest;
}

/// The same between the places: what a recalibration makes up for lies in a valley narrower than they are apart.
void Recalibrations::lookBetween(std::size_t parameter, const Step& step, Farness farness, Nearest& nearest) const {
  const Eigen::VectorXf left = columnOf(looks_.space().ofMeasurement()) - step.shifts;
  const auto shiftsOf = [&](std::size_t atom) { return looks_.shifts().col(static_cast<Eigen::Index>(atom)); };
  for (const auto& [from, to] : spans_) {
    const Eigen::VectorXf rest = left - shiftsOf(from), way = shiftsOf(to) - shiftsOf(from);
    const float part = counted(rest).dot(way) / way.squaredNorm();
    if (!(part > 0.0F && part < 1.0F)) continue;
    const Looks::Atom &a = looks_.atoms()[from], &b = looks_.atoms()[to];
    const double value = between(hypothesisOf(a).parameters.front(), a.values.front(), b.values.front(), part);
    keepNearer({a.single, parameter, {value, step.value}, farness(rest - part * way)}, nearest);
  }
}

/// Of every effect the place and the value of the parameter that come nearest together.
std::vector<Guess> Recalibrations::hiddenBy(std::size_t parameter, const std::vector<Step>& steps,
                                            const Look& look) const {
  Nearest nearest;
  for (const Step& step : steps) {
    core::stopIfCancelled(looks_.progress());
    for (auto& [effect, guess] : nearestBeside(parameter, step, look.farness)) keepNearer(std::move(guess), nearest);
    if (look.between) lookBetween(parameter, step, look.farness, nearest);
  }
  std::vector<Guess> guesses;
  for (auto& [effect, guess] : nearest) guesses.push_back(std::move(guess));
  return guesses;
}

/// Of an effect's guesses beside many values of a parameter the one that all data like best, if it is below `least`:
/// some of those between which the few data do not tell are asked.
std::optional<Guess> Recalibrations::nearestByAll(const std::vector<Guess>& along, double least) const {
  double floor = std::numeric_limits<double>::infinity();
  for (const Guess& guess : along) floor = std::min(floor, guess.distance);
  std::vector<Guess> low;
  for (const Guess& guess : along)
    if (guess.distance < floor + kAlikeAlong) low.push_back(guess);
  std::optional<Guess> nearest;
  const std::size_t asked = std::min(kAskedAlong, low.size());
  for (std::size_t k = 0; k < asked; ++k) {
    core::stopIfCancelled(looks_.progress());
    const Guess& guess = low[asked == 1 ? 0 : k * (low.size() - 1) / (asked - 1)];
    const double left = looks_.judge().leftOfFitted(looks_.hypothesisOf(guess), guess.values);
    if (left >= least) continue;
    least = left;
    nearest = guess;
    nearest->distance = left;
  }
  return nearest;
}

/// Of every effect what is nearest beside each value of the parameter, in their order.
std::vector<std::vector<Guess>> Recalibrations::placesBeside(std::size_t parameter) const {
  std::vector<Step> steps = stepsOf(parameter);
  std::sort(steps.begin(), steps.end(), [](const Step& a, const Step& b) { return a.value < b.value; });
  std::vector<Nearest> beside(steps.size());
  core::parallelFor(steps.size(), 1, [&](std::size_t s, std::size_t) {
    core::stopIfCancelled(looks_.progress());
    beside[s] = nearestBeside(parameter, steps[s], robustDistance);
    lookBetween(parameter, steps[s], robustDistance, beside[s]);
  });
  std::map<std::size_t, std::vector<Guess>> of_effect;
  for (const Nearest& nearest : beside)
    for (const auto& [effect, guess] : nearest) of_effect[effect].push_back(guess);
  std::vector<std::vector<Guess>> places;
  for (auto& [effect, guesses] : of_effect) places.push_back(std::move(guesses));
  return places;
}

std::vector<Guess> Recalibrations::hiddenFromFewData(std::size_t parameter, double left_alone) const {
  const double least = left_alone - Judge::kNatsPerNumber;
  const std::vector<std::vector<Guess>> places = placesBeside(parameter);
  std::vector<std::optional<Guess>> nearest(places.size());
  core::parallelFor(places.size(), 1, [&](std::size_t e, std::size_t) { nearest[e] = nearestByAll(places[e], least); });
  std::vector<Guess> guesses;
  for (std::optional<Guess>& guess : nearest)
    if (guess) guesses.push_back(std::move(*guess));
  return nearestOf(std::move(guesses), kHiddenByAll);
}

/// Values of a parameter to both sides of what is recorded, and what they do: some by simulation, those between them
/// by interpolation.
std::vector<Recalibrations::Step> Recalibrations::stepsOf(std::size_t parameter) const {
  const Hypothesis& hypothesis = looks_.singles()[parameter].hypothesis;
  const FreeParameter& p = hypothesis.parameters[0];
  std::vector<Step> steps;
  for (const bool up : {false, true}) {
    double last = p.start;
    Eigen::VectorXf before = Eigen::VectorXf::Zero(static_cast<Eigen::Index>(looks_.space().size()));
    for (const double factor : kRecalibrations) {
      const double value = std::clamp(up ? p.start * factor : p.start / factor, p.low, p.high);
      if (value == last) break;
      const Eigen::VectorXf shifts = columnOf(looks_.space().of(worldOf(looks_.scout(), hypothesis, {value})));
      for (int part = 1; part <= kPartsOfAStep; ++part) {
        const float share = static_cast<float>(part) / kPartsOfAStep;
        steps.push_back({last + static_cast<double>(share) * (value - last), before + share * (shifts - before)});
      }
      last = value;
      before = shifts;
    }
  }
  return steps;
}

}  // namespace gap
