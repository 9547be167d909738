#include "gap/which/pair_guesses.h"

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "core/parallel.h"
#include "gap/causes/search.h"
#include "gap/causes/starts.h"
#include "gap/which/partners.h"
#include "gap/which/signature_fit.h"

namespace gap {

namespace {

constexpr std::size_t kScoutSamples = 4;
constexpr int kScoutFrames = 4;
constexpr std::size_t kScoutBeams = 120;
constexpr std::size_t kSumsFitted = 6;      // nearest sums of two signatures
constexpr std::size_t kGlancesKept = 60;    // of every two effects, seen in one frame
constexpr std::size_t kPartnersTried = 12;  // nearest partners of a cause, alone,
constexpr std::size_t kPartnersFitted = 4;  // and then the nearest together with it
constexpr std::size_t kPartnersOfAll = 2;   // and nearest to all data that are fitted
constexpr std::size_t kHiddenFitted = 8;    // effects that a recalibration may hide,
constexpr std::size_t kHiddenInMeans = 4;   // and such that few outlying cells hide as well
constexpr double kMostErrors = 100.0;       // of a shift

/// Of what is recorded of a parameter; between two of them shifts are interpolated.
constexpr double kRecalibrations[] = {1.02, 1.05, 1.1, 1.2, 1.4, 1.7, 2.2};
constexpr int kPartsOfAStep = 4;

/// Of shifts, as much as counts in a distance; what it is given outlives what it returns.
template <typename Shifts>
auto near(const Eigen::MatrixBase<Shifts>& shifts) {
  constexpr auto kFar = static_cast<float>(SignatureSpace::kFar);
  return shifts.derived().cwiseMax(-kFar).cwiseMin(kFar);
}

double squaredDistance(const Eigen::VectorXf& shifts) { return near(shifts).squaredNorm(); }

/// How far shifts are from none, as a Cauchy distribution sees it (Holland, Welsch 1977, Robust regression using
/// iteratively reweighted least-squares, Communications in Statistics A6, 813-827: 2.385 errors). A few cells with one
/// echo or none differ by ten errors by chance: squared, they hide what a thousand others say.
double robustDistance(const Eigen::VectorXf& shifts) {
  constexpr float kScale = 2.385F;
  return static_cast<double>((1.0F + (shifts.array() / kScale).square()).log().sum());
}

Eigen::VectorXf columnOf(const Signature& signature) {
  return Eigen::Map<const Eigen::VectorXf>(signature.data(), static_cast<Eigen::Index>(signature.size()));
}

std::vector<Guess> nearestOf(std::vector<Guess> guesses, std::size_t count) {
  std::stable_sort(guesses.begin(), guesses.end(),
                   [](const Guess& a, const Guess& b) { return a.distance < b.distance; });
  if (guesses.size() > count) guesses.erase(guesses.begin() + static_cast<std::ptrdiff_t>(count), guesses.end());
  return guesses;
}

/// Few places of a cause that all others are looked at beside: a line at its thirds and at its end, where most causes
/// are strongest.
std::vector<std::vector<double>> fewPlaces(const Hypothesis& hypothesis) {
  const UnitCube cube(hypothesis.parameters);
  std::vector<std::vector<double>> places;
  if (hypothesis.parameters.size() == 1) {
    for (const double unit : {1.0 / 3.0, 2.0 / 3.0, 1.0}) places.push_back(cube.valuesAt({unit}));
  } else if (hypothesis.parameters.empty()) {
    places.push_back({});
  } else {
    for (const auto& point : evenPoints(hypothesis.parameters.size(), 3)) places.push_back(cube.valuesAt(point));
  }
  return places;
}

/// With every first cause the nearest guess.
std::vector<Guess> nearestOfEachFirst(std::vector<Guess> guesses) {
  std::set<std::size_t> taken;
  guesses = nearestOf(std::move(guesses), guesses.size());
  std::erase_if(guesses, [&](const Guess& guess) { return !taken.insert(guess.first).second; });
  return guesses;
}

}  // namespace

PairGuesses::PairGuesses(const Judge& judge, const std::vector<Candidate>& singles, const core::Progress& progress)
    : judge_(judge),
      singles_(singles),
      progress_(progress),
      scout_(judge.replay.thinner(kScoutBeams)),
      scouted_(spreadOver(judge.split.fitted, kScoutSamples, kScoutFrames)),
      space_(scout_, scouted_.samples, kScoutFrames, scouted_.seed, kMostErrors) {
  lookAtAtoms();
}

std::size_t PairGuesses::numbersOf(std::size_t single) const { return singles_[single].hypothesis.parameters.size(); }

double PairGuesses::distanceOf(const Hypothesis& hypothesis, const std::vector<double>& values) const {
  return discrepancyOf(scout_, worldOf(scout_, hypothesis, values), scouted_);
}

bool PairGuesses::mayPair(std::size_t a, std::size_t b) const {
  return pairable(singles_[a].hypothesis, singles_[b].hypothesis);
}

/// Every cause at its fitted values, at others all over its range, and where the residuals suggest, with what each
/// does to the data.
void PairGuesses::lookAtAtoms() {
  const WhereResult where = whereIn(scout_, scout_.baseline(), scouted_.seed);
  for (std::size_t i = 0; i < singles_.size(); ++i) {
    const Hypothesis& hypothesis = singles_[i].hypothesis;
    if (hypothesis.per_setup) continue;
    atoms_.push_back({i, singles_[i].values});
    for (auto& values : valuesAllOver(hypothesis)) atoms_.push_back({i, std::move(values)});
    append(atoms_, suggestedFor(i, where));
  }
  whole_.resize(static_cast<Eigen::Index>(space_.size()), static_cast<Eigen::Index>(atoms_.size()));
  core::parallelFor(atoms_.size(), 1, [&](std::size_t a, std::size_t) {
    core::stopIfCancelled(progress_);
    const World world = worldOf(scout_, singles_[atoms_[a].single].hypothesis, atoms_[a].values);
    whole_.col(static_cast<Eigen::Index>(a)) = columnOf(space_.of(world));
  });
  signatures_ = near(whole_);
}

std::vector<PairGuesses::Atom> PairGuesses::suggestedFor(std::size_t single, const WhereResult& where) const {
  std::vector<Atom> atoms;
  for (auto& values : startsFrom(judge_.replay, singles_[single].hypothesis, where))
    atoms.push_back({single, std::move(values)});
  return atoms;
}

std::vector<Guess> PairGuesses::nearestSums() const {
  const Eigen::MatrixXf products = signatures_.transpose() * signatures_;
  const Eigen::VectorXf along = signatures_.transpose() * near(columnOf(space_.ofMeasurement()));
  std::map<std::pair<std::size_t, std::size_t>, Guess> nearest;
  for (std::size_t a = 0; a < atoms_.size(); ++a) {
    for (std::size_t b = a + 1; b < atoms_.size(); ++b) {
      if (!mayPair(atoms_[a].single, atoms_[b].single)) continue;
      const auto x = static_cast<Eigen::Index>(a), y = static_cast<Eigen::Index>(b);
      const double distance =
          static_cast<double>(products(x, x) + products(y, y) + 2.0F * products(x, y) - 2.0F * (along(x) + along(y)));
      const auto [known, added] = nearest.try_emplace({atoms_[a].single, atoms_[b].single});
      if (!added && distance >= known->second.distance) continue;
      known->second = {atoms_[a].single, atoms_[b].single, joined(atoms_[a].values, atoms_[b].values), distance};
    }
  }
  std::vector<Guess> guesses;
  for (auto& [pair, guess] : nearest) guesses.push_back(std::move(guess));
  return lookedAt(nearestOf(std::move(guesses), kSumsFitted));
}

/// A look at every two effects, at few places each: of two that do nothing but together (a pane that lets light
/// through, and echoes that merge with those from behind it) neither leads to the other.
std::vector<Guess> PairGuesses::nearestOfEveryTwo() const {
  std::vector<Atom> places;
  for (std::size_t i = 0; i < singles_.size(); ++i) {
    const Hypothesis& hypothesis = singles_[i].hypothesis;
    if (hypothesis.kind != CauseKind::kEffect || !hypothesis.variant.empty() || !hypothesis.sensors.empty()) continue;
    for (auto& values : fewPlaces(hypothesis)) places.push_back({i, std::move(values)});
  }
  const Evidence at_a_glance = spreadOver(scouted_, kScoutSamples, 1);
  std::vector<std::vector<Guess>> beside(places.size());
  core::parallelFor(places.size(), 1, [&](std::size_t a, std::size_t) {
    for (std::size_t b = a + 1; b < places.size(); ++b) {
      core::stopIfCancelled(progress_);
      if (!mayPair(places[a].single, places[b].single)) continue;
      Guess guess{places[a].single, places[b].single, joined(places[a].values, places[b].values)};
      const Hypothesis both = hypothesisOf(guess);
      guess.distance = discrepancyOf(scout_, worldOf(scout_, both, guess.values), at_a_glance);
      beside[a].push_back(std::move(guess));
    }
    beside[a] = nearestOf(std::move(beside[a]), kSumsFitted);
  });
  std::vector<Guess> guesses;
  for (auto& some : beside) append(guesses, std::move(some));
  return nearestOf(lookedAt(nearestOf(std::move(guesses), kGlancesKept)), kSumsFitted);
}

/// Every cause that may be a pair with this one is looked at beside it, wherever it was looked at alone: what two do
/// together may be in neither's signature (fog blinds a receiver that does not look past its near field). What the
/// first one leaves says where: of all beams, for a hundred do not show in which sector a receiver is noisier.
std::vector<Guess> PairGuesses::partnersOf(std::size_t first, const std::vector<double>& values) const {
  std::vector<Atom> atoms = atoms_;
  std::erase_if(atoms,
                [&](const Atom& atom) { return !worthPairing(singles_, atom.single) || !mayPair(first, atom.single); });
  const World world = worldOf(judge_.replay, singles_[first].hypothesis, values);
  const WhereResult where = whereIn(judge_.replay, world, scouted_.seed);
  for (std::size_t i = 0; i < singles_.size(); ++i)
    if (mayPair(first, i)) append(atoms, suggestedFor(i, where));
  const std::vector<Guess> nearest = nearestPartners(first, values, atoms);
  std::vector<Guess> guesses = nearestOf(withFittedPartners(nearestOf(nearest, kPartnersTried)), kPartnersFitted);
  append(guesses, lookedAt(nearestByAll(first, values, nearest)));
  return guesses;
}

/// What goes best with a cause by all that is fitted, as it is nearest to the few data or as it is alone, where it
/// brings enough to be believed.
std::vector<Guess> PairGuesses::nearestByAll(std::size_t first, const std::vector<double>& values,
                                             std::vector<Guess> guesses) const {
  const auto distanceByAll = [&](const Guess& guess) { return judge_.leftOfFitted(hypothesisOf(guess), guess.values); };
  core::parallelFor(guesses.size(), 1, [&](std::size_t g, std::size_t) {
    core::stopIfCancelled(progress_);
    Guess& guess = guesses[g];
    guess.distance = distanceByAll(guess);
    Guess alone{first, guess.second, joined(values, singles_[guess.second].values)};
    alone.distance = distanceByAll(alone);
    if (alone.distance < guess.distance) guess = std::move(alone);
  });
  const double most = judge_.leftOfFitted(singles_[first].hypothesis, values) - Judge::kNatsPerNumber;
  std::erase_if(guesses, [&](const Guess& guess) { return guess.distance > most; });
  return nearestOf(std::move(guesses), kPartnersOfAll);
}

std::vector<Guess> PairGuesses::nearestPartners(std::size_t first, const std::vector<double>& values,
                                                const std::vector<Atom>& atoms) const {
  const Hypothesis& hypothesis = singles_[first].hypothesis;
  std::vector<double> distances(atoms.size());
  core::parallelFor(atoms.size(), 1, [&](std::size_t a, std::size_t) {
    core::stopIfCancelled(progress_);
    const Hypothesis both = together(hypothesis, singles_[atoms[a].single].hypothesis);
    distances[a] = distanceOf(both, joined(values, atoms[a].values));
  });
  std::map<std::size_t, Guess> nearest;
  for (std::size_t a = 0; a < atoms.size(); ++a) {
    const auto [known, added] = nearest.try_emplace(atoms[a].single);
    if (!added && distances[a] >= known->second.distance) continue;
    known->second = {first, atoms[a].single, joined(values, atoms[a].values), distances[a]};
  }
  std::vector<Guess> guesses;
  for (auto& [single, guess] : nearest) guesses.push_back(std::move(guess));
  return guesses;
}

/// The guess with the second cause's numbers where they serve the first one best.
Guess PairGuesses::fitted(const Guess& guess) const {
  const auto middle = guess.values.begin() + static_cast<std::ptrdiff_t>(numbersOf(guess.first));
  const std::vector<double> fixed(guess.values.begin(), middle), start(middle, guess.values.end());
  const Hypothesis added = beside(singles_[guess.first].hypothesis, fixed, singles_[guess.second].hypothesis);
  const Objective objective(scout_, added, scouted_, progress_);
  if (objective.tracesAnew(objective.unitOf(start))) return guess;
  const std::vector<double> found = roughFitFrom(scout_, added, scouted_, start, progress_);
  const double distance = distanceOf(added, found);
  return distance < guess.distance ? Guess{guess.first, guess.second, joined(fixed, found), distance} : guess;
}

/// A cause of several numbers is seldom right at any place that was looked at.
std::vector<Guess> PairGuesses::withFittedPartners(std::vector<Guess> guesses) const {
  core::parallelFor(guesses.size(), 1, [&](std::size_t g, std::size_t) { guesses[g] = fitted(guesses[g]); });
  return guesses;
}

std::vector<Guess> PairGuesses::besideRecalibration() const {
  std::vector<std::size_t> parameters;
  for (std::size_t i = 0; i < singles_.size(); ++i)
    if (singles_[i].hypothesis.kind == CauseKind::kParameter) parameters.push_back(i);
  std::vector<std::vector<Guess>> squared(parameters.size()), robust(parameters.size());
  core::parallelFor(parameters.size(), 1, [&](std::size_t p, std::size_t) {
    const std::vector<Step> steps = stepsOf(parameters[p]);
    squared[p] = hiddenBy(parameters[p], steps, squaredDistance);
    robust[p] = hiddenBy(parameters[p], steps, robustDistance);
  });
  // Spreads are few entries, which say most of what scatters; means of cells are many.
  std::vector<Guess> guesses, by_means;
  for (auto& some : squared) append(guesses, std::move(some));
  guesses = lookedAt(nearestOf(nearestOfEachFirst(std::move(guesses)), kHiddenFitted));
  for (auto& some : robust) append(by_means, std::move(some));
  append(guesses, nearestOf(nearestOfEachFirst(lookedAt(std::move(by_means))), kHiddenInMeans));
  return guesses;
}

/// Of every effect the place and the value of the parameter whose shifts together come nearest to the measurement.
std::vector<Guess> PairGuesses::hiddenBy(std::size_t parameter, const std::vector<Step>& steps,
                                         double (*farness)(const Eigen::VectorXf&)) const {
  const Eigen::VectorXf measured = columnOf(space_.ofMeasurement());
  std::map<std::size_t, Guess> nearest;
  for (const auto& [value, shifts] : steps) {
    core::stopIfCancelled(progress_);
    const Eigen::VectorXf left = measured - shifts;
    for (std::size_t a = 0; a < atoms_.size(); ++a) {
      if (singles_[atoms_[a].single].hypothesis.kind != CauseKind::kEffect) continue;
      const double distance = farness(left - whole_.col(static_cast<Eigen::Index>(a)));
      const auto [known, added] = nearest.try_emplace(atoms_[a].single);
      if (!added && distance >= known->second.distance) continue;
      known->second = {atoms_[a].single, parameter, joined(atoms_[a].values, {value}), distance};
    }
  }
  std::vector<Guess> guesses;
  for (auto& [single, guess] : nearest) guesses.push_back(std::move(guess));
  return guesses;
}

/// Values of a parameter to both sides of what is recorded, and what they do: some by simulation, those between them
/// by interpolation.
std::vector<PairGuesses::Step> PairGuesses::stepsOf(std::size_t parameter) const {
  const Hypothesis& hypothesis = singles_[parameter].hypothesis;
  const FreeParameter& p = hypothesis.parameters[0];
  std::vector<Step> steps;
  for (const bool up : {false, true}) {
    double last = p.start;
    Eigen::VectorXf before = Eigen::VectorXf::Zero(static_cast<Eigen::Index>(space_.size()));
    for (const double factor : kRecalibrations) {
      const double value = std::clamp(up ? p.start * factor : p.start / factor, p.low, p.high);
      if (value == last) break;
      const Eigen::VectorXf shifts = columnOf(space_.of(worldOf(scout_, hypothesis, {value})));
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

/// Guesses that came from signatures, with their distances from the data.
std::vector<Guess> PairGuesses::lookedAt(std::vector<Guess> guesses) const {
  core::parallelFor(guesses.size(), 1, [&](std::size_t g, std::size_t) {
    Guess& guess = guesses[g];
    guess.distance = distanceOf(hypothesisOf(guess), guess.values);
  });
  return guesses;
}

Hypothesis PairGuesses::hypothesisOf(const Guess& guess) const {
  return together(singles_[guess.first].hypothesis, singles_[guess.second].hypothesis);
}

std::vector<Guess> PairGuesses::improved(std::vector<Guess> guesses) const {
  core::parallelFor(guesses.size(), 1, [&](std::size_t g, std::size_t) {
    Guess& guess = guesses[g];
    const Hypothesis both = hypothesisOf(guess);
    const Objective objective(scout_, both, scouted_, progress_);
    if (objective.tracesAnew(objective.unitOf(guess.values))) return;
    const std::vector<double> fitted = signatureFitFrom(scout_, space_, both, guess.values, progress_);
    const double distance = distanceOf(both, fitted);
    if (distance < guess.distance) guess = {guess.first, guess.second, fitted, distance};
  });
  return nearestOf(std::move(guesses), guesses.size());
}

}  // namespace gap
