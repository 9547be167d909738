#include "gap/pairs/pairs.h"

#include <algorithm>
#include <atomic>
#include <iterator>
#include <limits>
#include <set>
#include <string>
#include <utility>

#include "core/parallel.h"
#include "gap/pairs/pair_guesses.h"
#include "gap/pairs/recalibrations.h"
#include "gap/pairs/second_search.h"

namespace gap {

namespace {

constexpr std::size_t kPartnered = 2;  // single causes that partners are looked for
constexpr int kExchanges = 2;
constexpr double kLittle = 0.5;         // of the gap: no cause that explains less leads to its partner
constexpr std::size_t kWellFitted = 4;  // of a batch of pairs: the others are fitted roughly

class PairSearch {
 public:
  PairSearch(const Judge& judge, const std::vector<Candidate>& singles, core::Progress& progress)
      : judge_(judge), singles_(singles), progress_(progress), looks_(judge, singles, progress) {}

  [[nodiscard]] std::vector<Candidate> run() {
    std::vector<Guess> guesses;
    const std::vector<double> left = leftBySingles();
    const std::vector<std::size_t> leaders = partnered(left);
    for (const std::size_t i : leaders) {
      append(guesses, i == leaders.front() ? searchedAnewBeside(i) : guesses_.partnersOf(i, singles_[i].values));
    }
    append(guesses, guesses_.nearestSums());
    Recalibrations::Hidden hidden = recalibrations_.hidden();
    append(guesses, std::move(hidden.by_spreads));
    fit(std::move(guesses));
    fit(std::move(hidden.by_means));
    fit(std::move(hidden.by_another));
    fitWhatIsNearer(hiddenFromFewData(left));
    if (littleIsExplained()) fit(guesses_.nearestOfEveryTwo());
    for (int round = 0; round < kExchanges && !pairs_.empty(); ++round) {
      const Fitted best = pairs_.front();
      const auto middle = best.candidate.values.begin() + static_cast<std::ptrdiff_t>(looks_.numbersOf(best.first));
      guesses = guesses_.partnersOf(best.first, {best.candidate.values.begin(), middle});
      append(guesses, guesses_.partnersOf(best.second, {middle, best.candidate.values.end()}));
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
    double discrepancy = 0.0;  ///< on the samples that were fitted
  };

  /// What every single cause leaves of the samples that are fitted; those of every set-up are not asked.
  [[nodiscard]] std::vector<double> leftBySingles() const {
    std::vector<double> left(singles_.size(), std::numeric_limits<double>::infinity());
    core::parallelFor(left.size(), 1, [&](std::size_t i, std::size_t) {
      core::stopIfCancelled(progress_);
      const Candidate& single = singles_[i];
      if (!single.hypothesis.per_setup) left[i] = judge_.leftOfFitted(single.hypothesis, single.values);
    });
    return left;
  }

  /// The cause that is best alone; the one that brings the fitted samples nearest, for where it acts there may be no
  /// sample that is held out; and then by merit. Of different names. `left`: leftBySingles.
  [[nodiscard]] std::vector<std::size_t> partnered(const std::vector<double>& left) const {
    std::vector<std::size_t> by_merit;
    for (std::size_t i = 0; i < singles_.size(); ++i)
      if (!singles_[i].hypothesis.per_setup) by_merit.push_back(i);
    if (by_merit.empty()) return {};
    const auto nearest = static_cast<std::size_t>(std::min_element(left.begin(), left.end()) - left.begin());
    std::vector<std::size_t> wanted{by_merit.front(), nearest};
    append(wanted, by_merit);
    std::set<std::string> names;
    std::erase_if(wanted, [&](std::size_t i) {
      return names.size() == kPartnered || !names.insert(singles_[i].hypothesis.name).second;
    });
    return wanted;
  }

  /// What the parameter hides that alone brings the fitted samples nearest. `left`: leftBySingles.
  [[nodiscard]] std::vector<Guess> hiddenFromFewData(const std::vector<double>& left) const {
    std::size_t nearest = left.size();
    for (std::size_t i = 0; i < left.size(); ++i) {
      const bool parameter = singles_[i].hypothesis.kind == CauseKind::kParameter;
      if (parameter && (nearest == left.size() || left[i] < left[nearest])) nearest = i;
    }
    if (nearest == left.size()) return {};
    return recalibrations_.hiddenFromFewData(nearest, left[nearest]);
  }

  /// What the search for a single cause finds beside this one.
  [[nodiscard]] std::vector<Guess> searchedAnewBeside(std::size_t first) {
    std::vector<Guess> guesses;
    core::PartOfProgress part(progress_, 0.0, 0.5);
    for (const Found& found : searchedBeside(judge_, singles_[first], singles_, part)) {
      Guess guess{first, found.single, joined(singles_[first].values, found.values)};
      guess.distance = looks_.distanceOf(looks_.hypothesisOf(guess), guess.values);
      guesses.push_back(std::move(guess));
    }
    return guesses;
  }

  [[nodiscard]] bool littleIsExplained() const {
    const auto little = [](const Candidate& candidate) { return candidate.explained < kLittle; };
    return std::all_of(singles_.begin(), singles_.end(), little) &&
           std::all_of(pairs_.begin(), pairs_.end(), [&](const Fitted& pair) { return little(pair.candidate); });
  }

  /// Whether both are of the same two causes.
  [[nodiscard]] static bool areOf(const Fitted& pair, const Guess& guess) {
    return std::minmax(pair.first, pair.second) == std::minmax(guess.first, guess.second);
  }

  /// Whether these two causes were fitted together already, and came as near to the data as this guess.
  [[nodiscard]] bool known(const Guess& guess) const {
    return std::any_of(pairs_.begin(), pairs_.end(), [&](const Fitted& pair) {
      if (!areOf(pair, guess)) return false;
      const Candidate& fitted = pair.candidate;
      return looks_.distanceOf(fitted.hypothesis, fitted.values) <= guess.distance;
    });
  }

  /// Joint fits of the guesses that are new.
  void fit(std::vector<Guess> guesses) {
    guesses = guesses_.improved(std::move(guesses));
    std::set<std::pair<std::size_t, std::size_t>> taken;
    std::erase_if(guesses, [&](const Guess& guess) {
      return known(guess) || !taken.insert(std::minmax(guess.first, guess.second)).second;
    });
    fitJointly(guesses);
  }

  /// Joint fits of the guesses whose distance from all that is fitted is less than that of the same two as they were
  /// fitted already: where few data lead them along a valley, none of them leads back.
  void fitWhatIsNearer(std::vector<Guess> guesses) {
    std::erase_if(guesses, [&](const Guess& guess) {
      return std::any_of(pairs_.begin(), pairs_.end(),
                         [&](const Fitted& pair) { return areOf(pair, guess) && pair.discrepancy <= guess.distance; });
    });
    fitJointly(guesses);
  }

  /// `pairs_` stays in order of merit.
  void fitJointly(const std::vector<Guess>& guesses) {
    std::vector<Fitted> fitted(guesses.size());
    std::atomic<std::size_t> done = 0;
    const Evidence& evidence = judge_.split.fitted;
    core::parallelFor(guesses.size(), 1, [&](std::size_t g, std::size_t) {
      const Guess& guess = guesses[g];
      Candidate& candidate = fitted[g].candidate;
      fitted[g].first = guess.first;
      fitted[g].second = guess.second;
      candidate.hypothesis = looks_.hypothesisOf(guess);
      candidate.values = roughFitFrom(judge_.replay, candidate.hypothesis, evidence, guess.values, progress_);
      fitted[g].discrepancy = judge_.leftOfFitted(candidate.hypothesis, candidate.values);
      progress_.report(static_cast<double>(++done) / static_cast<double>(guesses.size()),
                       "tried " + candidate.hypothesis.name);
    });
    std::stable_sort(fitted.begin(), fitted.end(),
                     [](const Fitted& a, const Fitted& b) { return a.discrepancy < b.discrepancy; });
    core::parallelFor(fitted.size(), 1, [&](std::size_t f, std::size_t) {
      Candidate& candidate = fitted[f].candidate;
      if (f < kWellFitted)
        candidate.values = fitFrom(judge_.replay, candidate.hypothesis, evidence, candidate.values, progress_);
      fitted[f].discrepancy = judge_.leftOfFitted(candidate.hypothesis, candidate.values);
      judge_.hear(candidate);
    });
    std::move(fitted.begin(), fitted.end(), std::back_inserter(pairs_));
    std::stable_sort(pairs_.begin(), pairs_.end(),
                     [](const Fitted& a, const Fitted& b) { return better(a.candidate, b.candidate); });
    std::set<std::pair<std::size_t, std::size_t>> taken;  // of a pair that was fitted again the better fit stays
    std::erase_if(pairs_,
                  [&](const Fitted& pair) { return !taken.insert(std::minmax(pair.first, pair.second)).second; });
  }

  const Judge& judge_;
  const std::vector<Candidate>& singles_;
  core::Progress& progress_;
  const Looks looks_;
  const PairGuesses guesses_{looks_};
  const Recalibrations recalibrations_{looks_};
  std::vector<Fitted> pairs_;
};

}  // namespace

std::vector<Candidate> rankPairs(const Judge& judge, const std::vector<Candidate>& singles, core::Progress& progress) {
  return PairSearch(judge, singles, progress).run();
}

}  // namespace gap
