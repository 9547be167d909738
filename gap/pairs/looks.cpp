#include "gap/pairs/looks.h"

#include "core/parallel.h"
#include "gap/causes/search.h"
#include "gap/causes/starts.h"
#include "gap/pairs/partners.h"

namespace gap {

namespace {

constexpr std::size_t kScoutSamples = 4;
constexpr int kScoutFrames = 4;
constexpr std::size_t kScoutBeams = 120;
constexpr double kMostErrors = 100.0;  // of a shift

}  // namespace

std::vector<Guess> nearestOf(std::vector<Guess> guesses, std::size_t count) {
  std::stable_sort(guesses.begin(), guesses.end(),
                   [](const Guess& a, const Guess& b) { return a.distance < b.distance; });
  if (guesses.size() > count) guesses.erase(guesses.begin() + static_cast<std::ptrdiff_t>(count), guesses.end());
  return guesses;
}

Eigen::VectorXf columnOf(const Signature& signature) {
  return Eigen::Map<const Eigen::VectorXf>(signature.data(), static_cast<Eigen::Index>(signature.size()));
}

Looks::Looks(const Judge& judge, const std::vector<Candidate>& singles, const core::Progress& progress)
    : judge_(judge),
      singles_(singles),
      progress_(progress),
      scout_(judge.replay.thinner(kScoutBeams)),
      scouted_(spreadOver(judge.split.fitted, kScoutSamples, kScoutFrames)),
      space_(scout_, scouted_.samples, kScoutFrames, scouted_.seed, kMostErrors) {
  lookAtAtoms();
}

std::size_t Looks::numbersOf(std::size_t single) const { return singles_[single].hypothesis.parameters.size(); }

double Looks::distanceOf(const Hypothesis& hypothesis, const std::vector<double>& values) const {
  return discrepancyOf(scout_, worldOf(scout_, hypothesis, values), scouted_);
}

void Looks::lookAtAtoms() {
  const WhereResult where = whereIn(scout_, scout_.baseline(), scouted_.seed);
  for (std::size_t i = 0; i < singles_.size(); ++i) {
    const Hypothesis& hypothesis = singles_[i].hypothesis;
    if (hypothesis.per_setup) continue;
    atoms_.push_back({i, singles_[i].values});
    for (auto& values : valuesAllOver(hypothesis)) atoms_.push_back({i, std::move(values)});
    append(atoms_, suggestedFor(i, where));
  }
  shifts_.resize(static_cast<Eigen::Index>(space_.size()), static_cast<Eigen::Index>(atoms_.size()));
  core::parallelFor(atoms_.size(), 1, [&](std::size_t a, std::size_t) {
    core::stopIfCancelled(progress_);
    const World world = worldOf(scout_, singles_[atoms_[a].single].hypothesis, atoms_[a].values);
    shifts_.col(static_cast<Eigen::Index>(a)) = columnOf(space_.of(world));
  });
}

std::vector<Looks::Atom> Looks::suggestedFor(std::size_t single, const WhereResult& where) const {
  std::vector<Atom> atoms;
  for (auto& values : startsFrom(judge_.replay, singles_[single].hypothesis, where))
    atoms.push_back({single, std::move(values)});
  return atoms;
}

std::vector<Guess> Looks::lookedAt(std::vector<Guess> guesses) const {
  core::parallelFor(guesses.size(), 1, [&](std::size_t g, std::size_t) {
    Guess& guess = guesses[g];
    guess.distance = distanceOf(hypothesisOf(guess), guess.values);
  });
  return guesses;
}

Hypothesis Looks::hypothesisOf(const Guess& guess) const {
  return together(singles_[guess.first].hypothesis, singles_[guess.second].hypothesis);
}

}  // namespace gap
