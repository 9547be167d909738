#include "gap/which/pairs.h"

#include <Eigen/Dense>
#include <algorithm>
#include <atomic>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "core/parallel.h"
#include "gap/causes/starts.h"
#include "gap/which/signature_fit.h"
#include "gap/which/signatures.h"

namespace gap {

namespace {

constexpr std::size_t kScoutSamples = 4;
constexpr int kScoutFrames = 4;
constexpr std::size_t kSumsFitted = 6;      // nearest sums of two signatures
constexpr std::size_t kPartnersTried = 12;  // nearest partners of a cause, alone,
constexpr std::size_t kPartnersFitted = 4;  // and then the nearest together with it
constexpr std::size_t kPartnersOfAll = 2;   // and nearest to all data that are fitted
constexpr std::size_t kHiddenFitted = 8;    // effects that a recalibration may hide
constexpr std::size_t kPartnered = 2;       // single causes that partners are looked for
constexpr double kRecalibrations[] = {1.02, 1.05, 1.1, 1.2, 1.4, 1.7, 2.2};  // of what is recorded of a parameter
constexpr int kPartsOfAStep = 4;       // between two of them shifts are interpolated
constexpr double kMostErrors = 100.0;  // of a shift
constexpr int kExchanges = 2;
constexpr std::size_t kWellFitted = 4;  // of a batch of pairs: the others are fitted roughly
constexpr std::size_t kScoutBeams = 120;
constexpr std::size_t kLookedAt = 16;      // causes whose sums come nearest, and as many that are best alone
constexpr std::size_t kAtomsOfACause = 3;  // whose sums come nearest, of causes that are not best alone

/// Of shifts, as much as counts in a distance.
Eigen::MatrixXf near(const Eigen::MatrixXf& shifts) {
  constexpr auto kFar = static_cast<float>(SignatureSpace::kFar);
  return shifts.cwiseMax(-kFar).cwiseMin(kFar);
}

/// A cause at certain values.
struct Atom {
  std::size_t single = 0;
  std::vector<double> values;
};

/// A pair of causes to begin a joint fit with.
struct Guess {
  std::size_t first = 0, second = 0;  ///< singles
  std::vector<double> values;         ///< of both
  double distance = 0.0;
};

class PairSearch {
 public:
  PairSearch(const Judge& judge, const std::vector<Candidate>& singles, core::Progress& progress)
      : judge_(judge),
        scout_(judge.replay.thinner(kScoutBeams)),
        scouted_(spreadOver(judge.split.fitted, kScoutSamples, kScoutFrames)),
        space_(scout_, scouted_.samples, kScoutFrames, scouted_.seed, kMostErrors),
        singles_(singles),
        progress_(progress) {
    lookAtAtoms();
  }

  [[nodiscard]] std::vector<Candidate> run() {
    std::vector<Guess> guesses;
    std::vector<std::string> partnered;
    for (std::size_t i = 0; i < singles_.size() && partnered.size() < kPartnered; ++i) {
      const std::string& name = singles_[i].hypothesis.name;
      if (singles_[i].hypothesis.per_setup || std::count(partnered.begin(), partnered.end(), name) > 0) continue;
      partnered.push_back(name);
      append(guesses, partnersOf(i, singles_[i].values));
    }
    append(guesses, lookedAt(nearestSums()));
    append(guesses, lookedAt(besideRecalibration()));
    fit(std::move(guesses));
    for (int round = 0; round < kExchanges && !pairs_.empty(); ++round) {
      const Fitted best = pairs_.front();
      const auto middle = best.candidate.values.begin() + static_cast<std::ptrdiff_t>(numbersOf(best.first));
      guesses = partnersOf(best.first, {best.candidate.values.begin(), middle});
      append(guesses, partnersOf(best.second, {middle, best.candidate.values.end()}));
      fit(std::move(guesses));
      if (pairs_.front().first == best.first && pairs_.front().second == best.second) break;
    }
    std::vector<Candidate> result;
    for (Fitted& pair : pairs_) result.push_back(std::move(pair.candidate));
    return result;
  }

 private:
  struct Fitted {
    std::size_t first = 0, second = 0;
    Candidate candidate;
    double discrepancy = 0.0;  ///< on the samples that were fitted, after a rough fit
  };

  [[nodiscard]] std::size_t numbersOf(std::size_t single) const {
    return singles_[single].hypothesis.parameters.size();
  }
  template <typename T>
  static void append(std::vector<T>& to, std::vector<T> more) {
    std::move(more.begin(), more.end(), std::back_inserter(to));
  }
  [[nodiscard]] bool pairable(std::size_t a, std::size_t b) const {
    const Hypothesis &x = singles_[a].hypothesis, &y = singles_[b].hypothesis;
    return a != b && !x.per_setup && !y.per_setup && x.name != y.name;
  }

  /// Every cause at its fitted values, at others all over its range, and where the residuals suggest, with what each
  /// does to the data.
  void lookAtAtoms() {
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
  [[nodiscard]] std::vector<Atom> suggestedFor(std::size_t single, const WhereResult& where) const {
    std::vector<Atom> atoms;
    for (auto& values : startsFrom(judge_.replay, singles_[single].hypothesis, where))
      atoms.push_back({single, std::move(values)});
    return atoms;
  }
  [[nodiscard]] static Eigen::VectorXf columnOf(const Signature& signature) {
    return Eigen::Map<const Eigen::VectorXf>(signature.data(), static_cast<Eigen::Index>(signature.size()));
  }

  /// Pairs of causes by the distance of their summed signatures from the measurement.
  [[nodiscard]] std::vector<Guess> nearestSums() const {
    const Eigen::MatrixXf products = signatures_.transpose() * signatures_;
    const Eigen::VectorXf along = signatures_.transpose() * near(columnOf(space_.ofMeasurement()));
    std::map<std::pair<std::size_t, std::size_t>, Guess> nearest;
    for (std::size_t a = 0; a < atoms_.size(); ++a) {
      for (std::size_t b = a + 1; b < atoms_.size(); ++b) {
        if (!pairable(atoms_[a].single, atoms_[b].single)) continue;
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
    return nearestOf(std::move(guesses), kSumsFitted);
  }

  /// Of the causes that, added to what this one does, come nearest to the measurement the nearest atoms; and all of
  /// those that are best alone: echoes from nowhere are in no signature.
  [[nodiscard]] std::vector<Atom> likelyBeside(std::size_t first, const World& world) const {
    const Eigen::VectorXf left = near(columnOf(space_.ofMeasurement())) - near(columnOf(space_.of(world)));
    const Eigen::VectorXf distances = (signatures_.colwise() - left).colwise().squaredNorm();
    std::vector<std::size_t> order;
    for (std::size_t a = 0; a < atoms_.size(); ++a)
      if (pairable(first, atoms_[a].single)) order.push_back(a);
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return distances[static_cast<Eigen::Index>(a)] < distances[static_cast<Eigen::Index>(b)];
    });
    std::vector<Atom> likely;
    std::map<std::size_t, std::size_t> taken;  // atoms of each cause
    for (const std::size_t a : order) {
      const std::size_t single = atoms_[a].single;
      const bool near = taken.contains(single) || taken.size() < kLookedAt;
      const bool enough = single >= kLookedAt && taken.contains(single) && taken.at(single) == kAtomsOfACause;
      if (enough || (!near && single >= kLookedAt)) continue;
      ++taken[single];
      likely.push_back(atoms_[a]);
    }
    return likely;
  }

  /// What goes best with a cause at these values.
  [[nodiscard]] std::vector<Guess> partnersOf(std::size_t first, const std::vector<double>& values) const {
    const World world = worldOf(scout_, singles_[first].hypothesis, values);
    std::vector<Atom> atoms = likelyBeside(first, world);
    const WhereResult where = whereIn(scout_, world, scouted_.seed);
    for (std::size_t i = 0; i < singles_.size(); ++i)
      if (pairable(first, i)) append(atoms, suggestedFor(i, where));
    std::vector<Guess> guesses = nearestOf(nearestPartners(first, values, atoms), kPartnersTried);
    guesses = nearestOf(withFittedPartners(std::move(guesses)), kPartnersFitted);
    append(guesses, lookedAt(partnersByAll(first, values)));
    return guesses;
  }

  /// What goes best with a cause, each as it was fitted alone, by all that is fitted: too few shots are scouted to see
  /// a loss or a false echo that is rare.
  [[nodiscard]] std::vector<Guess> partnersByAll(std::size_t first, const std::vector<double>& values) const {
    std::vector<Guess> guesses;
    for (std::size_t i = 0; i < singles_.size(); ++i)
      if (pairable(first, i)) guesses.push_back({first, i, joined(values, singles_[i].values)});
    const auto distanceOf = [&](const World& world) {
      return discrepancyOf(judge_.replay, world, judge_.split.fitted);
    };
    core::parallelFor(guesses.size(), 1, [&](std::size_t g, std::size_t) {
      core::stopIfCancelled(progress_);
      guesses[g].distance = distanceOf(worldOf(judge_.replay, hypothesisOf(guesses[g]), guesses[g].values));
    });
    const double alone = distanceOf(worldOf(judge_.replay, singles_[first].hypothesis, values));
    std::erase_if(guesses, [&](const Guess& guess) { return alone - guess.distance < Judge::kNatsPerNumber; });
    return nearestOf(std::move(guesses), kPartnersOfAll);
  }

  [[nodiscard]] std::vector<Guess> nearestPartners(std::size_t first, const std::vector<double>& values,
                                                   const std::vector<Atom>& atoms) const {
    const Hypothesis& hypothesis = singles_[first].hypothesis;
    std::vector<double> distances(atoms.size());
    core::parallelFor(atoms.size(), 1, [&](std::size_t a, std::size_t) {
      core::stopIfCancelled(progress_);
      const Hypothesis both = together(hypothesis, singles_[atoms[a].single].hypothesis);
      distances[a] = discrepancyOf(scout_, worldOf(scout_, both, joined(values, atoms[a].values)), scouted_);
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

  /// Whether other numbers of a cause send the rays other ways: then every look at it takes long.
  [[nodiscard]] bool tracesAnew(const Hypothesis& hypothesis, const std::vector<double>& values) const {
    std::vector<double> others;
    for (const FreeParameter& parameter : hypothesis.parameters)
      others.push_back(0.5 * (parameter.low + parameter.high));
    const model::Sample& sample = *scout_.samples()[scouted_.samples.front()].sample;
    return geometryKey(worldOf(scout_, hypothesis, values), sample) !=
           geometryKey(worldOf(scout_, hypothesis, others), sample);
  }

  /// The guesses with the second cause's numbers where they serve the first one best: a cause of several numbers is
  /// seldom right at any place that was looked at.
  [[nodiscard]] std::vector<Guess> withFittedPartners(std::vector<Guess> guesses) const {
    core::parallelFor(guesses.size(), 1, [&](std::size_t g, std::size_t) {
      Guess& guess = guesses[g];
      const auto middle = guess.values.begin() + static_cast<std::ptrdiff_t>(numbersOf(guess.first));
      const std::vector<double> fixed(guess.values.begin(), middle), start(middle, guess.values.end());
      const Hypothesis added = beside(singles_[guess.first].hypothesis, fixed, singles_[guess.second].hypothesis);
      if (tracesAnew(added, start)) return;
      const std::vector<double> fitted = roughFitFrom(scout_, added, scouted_, start, progress_);
      const double distance = discrepancyOf(scout_, worldOf(scout_, added, fitted), scouted_);
      if (distance < guess.distance) guess = {guess.first, guess.second, joined(fixed, fitted), distance};
    });
    return guesses;
  }

  /// What goes best with another value of a parameter: whoever calibrated the model to its means has hidden the cause
  /// in it, and no single hypothesis may look better than none. What is left of the cause shows only where the
  /// parameter is right within a per cent or two, so signatures are summed at many values of it.
  [[nodiscard]] std::vector<Guess> besideRecalibration() const {
    std::vector<std::size_t> parameters;
    for (std::size_t i = 0; i < singles_.size(); ++i)
      if (singles_[i].hypothesis.kind == CauseKind::kParameter) parameters.push_back(i);
    std::vector<std::vector<Guess>> beside(parameters.size());
    core::parallelFor(parameters.size(), 1, [&](std::size_t p, std::size_t) { beside[p] = hiddenBy(parameters[p]); });
    std::vector<Guess> guesses;
    for (auto& some : beside) append(guesses, std::move(some));
    return nearestOf(nearestOfEachFirst(std::move(guesses)), kHiddenFitted);
  }

  /// Of every effect the place and the value of the parameter whose shifts together come nearest to the measurement.
  [[nodiscard]] std::vector<Guess> hiddenBy(std::size_t parameter) const {
    const Eigen::VectorXf measured = columnOf(space_.ofMeasurement());
    std::map<std::size_t, Guess> nearest;
    for (const auto& [value, shifts] : stepsOf(parameter)) {
      core::stopIfCancelled(progress_);
      const Eigen::VectorXf left = measured - shifts;
      for (std::size_t a = 0; a < atoms_.size(); ++a) {
        if (singles_[atoms_[a].single].hypothesis.kind != CauseKind::kEffect) continue;
        const double distance = near(left - whole_.col(static_cast<Eigen::Index>(a))).squaredNorm();
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
  [[nodiscard]] std::vector<std::pair<double, Eigen::VectorXf>> stepsOf(std::size_t parameter) const {
    const Hypothesis& hypothesis = singles_[parameter].hypothesis;
    const FreeParameter& p = hypothesis.parameters[0];
    std::vector<std::pair<double, Eigen::VectorXf>> steps;
    for (const bool up : {false, true}) {
      double last = p.start;
      Eigen::VectorXf before = Eigen::VectorXf::Zero(static_cast<Eigen::Index>(space_.size()));
      for (const double factor : kRecalibrations) {
        const double value = std::clamp(up ? p.start * factor : p.start / factor, p.low, p.high);
        if (value == last) break;
        const Eigen::VectorXf shifts = columnOf(space_.of(worldOf(scout_, hypothesis, {value})));
        for (int part = 1; part <= kPartsOfAStep; ++part) {
          const float share = static_cast<float>(part) / kPartsOfAStep;
          steps.emplace_back(last + static_cast<double>(share) * (value - last), before + share * (shifts - before));
        }
        last = value;
        before = shifts;
      }
    }
    return steps;
  }

  [[nodiscard]] static std::vector<Guess> nearestOf(std::vector<Guess> guesses, std::size_t count) {
    std::stable_sort(guesses.begin(), guesses.end(),
                     [](const Guess& a, const Guess& b) { return a.distance < b.distance; });
    if (guesses.size() > count) guesses.erase(guesses.begin() + static_cast<std::ptrdiff_t>(count), guesses.end());
    return guesses;
  }

  /// Guesses that came from signatures, with their distances from the data.
  [[nodiscard]] std::vector<Guess> lookedAt(std::vector<Guess> guesses) const {
    core::parallelFor(guesses.size(), 1, [&](std::size_t g, std::size_t) {
      Guess& guess = guesses[g];
      guess.distance = discrepancyOf(scout_, worldOf(scout_, hypothesisOf(guess), guess.values), scouted_);
    });
    return guesses;
  }
  [[nodiscard]] Hypothesis hypothesisOf(const Guess& guess) const {
    return together(singles_[guess.first].hypothesis, singles_[guess.second].hypothesis);
  }

  /// The guesses with both causes' numbers where their signatures fit best, nearest first.
  [[nodiscard]] std::vector<Guess> improved(std::vector<Guess> guesses) const {
    core::parallelFor(guesses.size(), 1, [&](std::size_t g, std::size_t) {
      Guess& guess = guesses[g];
      const Hypothesis both = hypothesisOf(guess);
      if (tracesAnew(both, guess.values)) return;
      const std::vector<double> fitted = signatureFitFrom(scout_, space_, both, guess.values, progress_);
      const double distance = discrepancyOf(scout_, worldOf(scout_, both, fitted), scouted_);
      if (distance < guess.distance) guess = {guess.first, guess.second, fitted, distance};
    });
    return nearestOf(std::move(guesses), guesses.size());
  }

  /// With every first cause the nearest guess.
  [[nodiscard]] static std::vector<Guess> nearestOfEachFirst(std::vector<Guess> guesses) {
    std::set<std::size_t> taken;
    guesses = nearestOf(std::move(guesses), guesses.size());
    std::erase_if(guesses, [&](const Guess& guess) { return !taken.insert(guess.first).second; });
    return guesses;
  }

  /// Whether these two causes were fitted together already, and came as near to the data as this guess.
  [[nodiscard]] bool known(const Guess& guess) const {
    return std::any_of(pairs_.begin(), pairs_.end(), [&](const Fitted& pair) {
      if (std::minmax(pair.first, pair.second) != std::minmax(guess.first, guess.second)) return false;
      const Candidate& fitted = pair.candidate;
      return discrepancyOf(scout_, worldOf(scout_, fitted.hypothesis, fitted.values), scouted_) <= guess.distance;
    });
  }

  /// Joint fits of the guesses that are new; `pairs_` stays in order of merit.
  void fit(std::vector<Guess> guesses) {
    guesses = improved(std::move(guesses));
    std::set<std::pair<std::size_t, std::size_t>> taken;
    std::erase_if(guesses, [&](const Guess& guess) {
      return known(guess) || !taken.insert(std::minmax(guess.first, guess.second)).second;
    });
    std::vector<Fitted> fitted(guesses.size());
    std::atomic<std::size_t> done = 0;
    const Evidence& evidence = judge_.split.fitted;
    core::parallelFor(guesses.size(), 1, [&](std::size_t g, std::size_t) {
      const Guess& guess = guesses[g];
      Candidate& candidate = fitted[g].candidate;
      fitted[g].first = guess.first;
      fitted[g].second = guess.second;
      candidate.hypothesis = hypothesisOf(guess);
      candidate.values = roughFitFrom(judge_.replay, candidate.hypothesis, evidence, guess.values, progress_);
      const World world = worldOf(judge_.replay, candidate.hypothesis, candidate.values);
      fitted[g].discrepancy = discrepancyOf(judge_.replay, world, evidence);
      progress_.report(static_cast<double>(++done) / static_cast<double>(guesses.size()),
                       "tried " + candidate.hypothesis.name);
    });
    std::stable_sort(fitted.begin(), fitted.end(),
                     [](const Fitted& a, const Fitted& b) { return a.discrepancy < b.discrepancy; });
    core::parallelFor(fitted.size(), 1, [&](std::size_t f, std::size_t) {
      Candidate& candidate = fitted[f].candidate;
      if (f < kWellFitted)
        candidate.values = fitFrom(judge_.replay, candidate.hypothesis, evidence, candidate.values, progress_);
      judge_.hear(candidate);
    });
    std::move(fitted.begin(), fitted.end(), std::back_inserter(pairs_));
    std::stable_sort(pairs_.begin(), pairs_.end(),
                     [](const Fitted& a, const Fitted& b) { return better(a.candidate, b.candidate); });
    taken.clear();  // of a pair that was fitted again the better fit stays
    std::erase_if(pairs_,
                  [&](const Fitted& pair) { return !taken.insert(std::minmax(pair.first, pair.second)).second; });
  }

  const Judge& judge_;
  const Replay scout_;  ///< fewer beams still: many worlds are looked at before few are fitted
  const Evidence scouted_;
  const SignatureSpace space_;
  std::vector<Atom> atoms_;
  Eigen::MatrixXf whole_, signatures_;  ///< of the atoms, a column each: as they are, and as far as they count
  const std::vector<Candidate>& singles_;
  core::Progress& progress_;
  std::vector<Fitted> pairs_;
};

}  // namespace

std::vector<Candidate> rankPairs(const Judge& judge, const std::vector<Candidate>& singles, core::Progress& progress) {
  return PairSearch(judge, singles, progress).run();
}

}  // namespace gap
