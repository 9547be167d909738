#include "gap/pairs/pair_guesses.h"

#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include "core/parallel.h"
#include "gap/candidates/signature_fit.h"
#include "gap/causes/search.h"
#include "gap/pairs/partners.h"

namespace gap {

namespace {

constexpr std::size_t kSumsFitted = 6;      // nearest sums of two signatures
constexpr std::size_t kGlancesKept = 60;    // of every two effects, seen in one frame
constexpr std::size_t kPartnersTried = 12;  // nearest partners of a cause, alone,
constexpr std::size_t kPartnersFitted = 4;  // and then the nearest together with it
constexpr std::size_t kPartnersOfAll = 2;   // and nearest to all data that are fitted

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

}  // namespace

PairGuesses::PairGuesses(const Looks& looks) : looks_(looks), counted_(counted(looks.shifts())) {}

bool PairGuesses::mayPair(std::size_t a, std::size_t b) const {
  return pairable(looks_.singles()[a].hypothesis, looks_.singles()[b].hypothesis);
}

std::vector<Guess> PairGuesses::nearestSums() const {
  const Eigen::MatrixXf products = counted_.transpose() * counted_;
  const Eigen::VectorXf along = counted_.transpose() * counted(columnOf(looks_.space().ofMeasurement()));
  std::map<std::pair<std::size_t, std::size_t>, Guess> nearest;
  for (std::size_t a = 0; a < looks_.atoms().size(); ++a) {
    for (std::size_t b = a + 1; b < looks_.atoms().size(); ++b) {
      if (!mayPair(looks_.atoms()[a].single, looks_.atoms()[b].single)) continue;
      const auto x = static_cast<Eigen::Index>(a), y = static_cast<Eigen::Index>(b);
      const double distance =
          static_cast<double>(products(x, x) + products(y, y) + 2.0F * products(x, y) - 2.0F * (along(x) + along(y)));
      const auto [known, added] = nearest.try_emplace({looks_.atoms()[a].single, looks_.atoms()[b].single});
      if (!added && distance >= known->second.distance) continue;
      known->second = {looks_.atoms()[a].single, looks_.atoms()[b].single,
                       joined(looks_.atoms()[a].values, looks_.atoms()[b].values), distance};
    }
  }
  std::vector<Guess> guesses;
  for (auto& [pair, guess] : nearest) guesses.push_back(std::move(guess));
  return looks_.lookedAt(nearestOf(std::move(guesses), kSumsFitted));
}

/// A look at every two effects, at few places each: of two that do nothing but together (a pane that lets light
/// through, and echoes that merge with those from behind it) neither leads to the other.
std::vector<Guess> PairGuesses::nearestOfEveryTwo() const {
  std::vector<Looks::Atom> places;
  for (std::size_t i = 0; i < looks_.singles().size(); ++i) {
    const Hypothesis& hypothesis = looks_.singles()[i].hypothesis;
    if (hypothesis.kind != CauseKind::kEffect || !hypothesis.variant.empty() || !hypothesis.sensors.empty()) continue;
    for (auto& values : fewPlaces(hypothesis)) places.push_back({i, std::move(values)});
  }
  const Evidence at_a_glance = spreadOver(looks_.scouted(), looks_.scouted().samples.size(), 1);
  std::vector<std::vector<Guess>> beside(places.size());
  core::parallelFor(places.size(), 1, [&](std::size_t a, std::size_t) {
    for (std::size_t b = a + 1; b < places.size(); ++b) {
      core::stopIfCancelled(looks_.progress());
      if (!mayPair(places[a].single, places[b].single)) continue;
      Guess guess{places[a].single, places[b].single, joined(places[a].values, places[b].values)};
      const Hypothesis both = looks_.hypothesisOf(guess);
      guess.distance = discrepancyOf(looks_.scout(), worldOf(looks_.scout(), both, guess.values), at_a_glance);
      beside[a].push_back(std::move(guess));
    }
    beside[a] = nearestOf(std::move(beside[a]), kSumsFitted);
  });
  std::vector<Guess> guesses;
  for (auto& some : beside) append(guesses, std::move(some));
  return nearestOf(looks_.lookedAt(nearestOf(std::move(guesses), kGlancesKept)), kSumsFitted);
}

/// Every cause that may be a pair with this one is looked at beside it, wherever it was looked at alone: what two do
/// together may be in neither's signature (fog blinds a receiver that does not look past its near field). What the
/// first one leaves says where: of all beams, for a hundred do not show in which sector a receiver is noisier.
std::vector<Guess> PairGuesses::partnersOf(std::size_t first, const std::vector<double>& values) const {
  std::vector<Looks::Atom> atoms = looks_.atoms();
  std::erase_if(atoms, [&](const Looks::Atom& atom) {
    return !worthPairing(looks_.singles(), atom.single) || !mayPair(first, atom.single);
  });
  const World world = worldOf(looks_.judge().replay, looks_.singles()[first].hypothesis, values);
  const WhereResult where = whereIn(looks_.judge().replay, world, looks_.scouted().seed);
  for (std::size_t i = 0; i < looks_.singles().size(); ++i)
    if (mayPair(first, i)) append(atoms, looks_.suggestedFor(i, where));
  const std::vector<Guess> nearest = nearestPartners(first, values, atoms);
  std::vector<Guess> guesses = nearestOf(withFittedPartners(nearestOf(nearest, kPartnersTried)), kPartnersFitted);
  append(guesses, looks_.lookedAt(nearestByAll(first, values, nearest)));
  return guesses;
}

/// What goes best with a cause by all that is fitted, as it is nearest to the few data or as it is alone, where it
/// brings enough to be believed.
std::vector<Guess> PairGuesses::nearestByAll(std::size_t first, const std::vector<double>& values,
                                             std::vector<Guess> guesses) const {
  const auto distanceByAll = [&](const Guess& guess) {
    return looks_.judge().leftOfFitted(looks_.hypothesisOf(guess), guess.values);
  };
  core::parallelFor(guesses.size(), 1, [&](std::size_t g, std::size_t) {
    core::stopIfCancelled(looks_.progress());
    Guess& guess = guesses[g];
    guess.distance = distanceByAll(guess);
    Guess alone{first, guess.second, joined(values, looks_.singles()[guess.second].values)};
    alone.distance = distanceByAll(alone);
    if (alone.distance < guess.distance) guess = std::move(alone);
  });
  const double most = looks_.judge().leftOfFitted(looks_.singles()[first].hypothesis, values) - Judge::kNatsPerNumber;
  std::erase_if(guesses, [&](const Guess& guess) { return guess.distance > most; });
  return nearestOf(std::move(guesses), kPartnersOfAll);
}

std::vector<Guess> PairGuesses::nearestPartners(std::size_t first, const std::vector<double>& values,
                                                const std::vector<Looks::Atom>& atoms) const {
  const Hypothesis& hypothesis = looks_.singles()[first].hypothesis;
  std::vector<double> distances(atoms.size());
  core::parallelFor(atoms.size(), 1, [&](std::size_t a, std::size_t) {
    core::stopIfCancelled(looks_.progress());
    const Hypothesis both = together(hypothesis, looks_.singles()[atoms[a].single].hypothesis);
    distances[a] = looks_.distanceOf(both, joined(values, atoms[a].values));
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
  const auto middle = guess.values.begin() + static_cast<std::ptrdiff_t>(looks_.numbersOf(guess.first));
  const std::vector<double> fixed(guess.values.begin(), middle), start(middle, guess.values.end());
  const Hypothesis added =
      beside(looks_.singles()[guess.first].hypothesis, fixed, looks_.singles()[guess.second].hypothesis);
  const Objective objective(looks_.scout(), added, looks_.scouted(), looks_.progress());
  if (objective.tracesAnew(objective.unitOf(start))) return guess;
  const std::vector<double> found = roughFitFrom(looks_.scout(), added, looks_.scouted(), start, looks_.progress());
  const double distance = looks_.distanceOf(added, found);
  return distance < guess.distance ? Guess{guess.first, guess.second, joined(fixed, found), distance} : guess;
}

/// A cause of several numbers is seldom right at any place that was looked at.
std::vector<Guess> PairGuesses::withFittedPartners(std::vector<Guess> guesses) const {
  core::parallelFor(guesses.size(), 1, [&](std::size_t g, std::size_t) { guesses[g] = fitted(guesses[g]); });
  return guesses;
}

std::vector<Guess> PairGuesses::improved(std::vector<Guess> guesses) const {
  core::parallelFor(guesses.size(), 1, [&](std::size_t g, std::size_t) {
    Guess& guess = guesses[g];
    const Hypothesis both = looks_.hypothesisOf(guess);
    const Objective objective(looks_.scout(), both, looks_.scouted(), looks_.progress());
    if (objective.tracesAnew(objective.unitOf(guess.values))) return;
    const std::vector<double> fitted =
        signatureFitFrom(looks_.scout(), looks_.space(), both, guess.values, looks_.progress());
    const double distance = looks_.distanceOf(both, fitted);
    if (distance < guess.distance) guess = {guess.first, guess.second, fitted, distance};
  });
  return nearestOf(std::move(guesses), guesses.size());
}

}  // namespace gap
