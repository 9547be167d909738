#include "gap/which/pairs.h"

#include <algorithm>
#include <atomic>
#include <iterator>
#include <set>
#include <string>
#include <utility>

#include "core/parallel.h"
#include "gap/which/pair_guesses.h"

namespace gap {

namespace {

constexpr std::size_t kPartnered = 2;  // single causes that partners are looked for
constexpr int kExchanges = 2;
constexpr std::size_t kWellFitted = 4;  // of a batch of pairs: the others are fitted roughly

class PairSearch {
 public:
  PairSearch(const Judge& judge, const std::vector<Candidate>& singles, core::Progress& progress)
      : judge_(judge), singles_(singles), progress_(progress), guesses_(judge, singles, progress) {}

  [[nodiscard]] std::vector<Candidate> run() {
    std::vector<Guess> guesses;
    for (const std::size_t i : partnered()) append(guesses, guesses_.partnersOf(i, singles_[i].values));
    append(guesses, guesses_.nearestSums());
    append(guesses, guesses_.besideRecalibration());
    fit(std::move(guesses));
    for (int round = 0; round < kExchanges && !pairs_.empty(); ++round) {
      const Fitted best = pairs_.front();
      const auto middle = best.candidate.values.begin() + static_cast<std::ptrdiff_t>(guesses_.numbersOf(best.first));
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
    double discrepancy = 0.0;  ///< on the samples that were fitted, after a rough fit
  };

  /// The cause that is best alone; the one that brings the fitted samples nearest, for where it acts there may be no
  /// sample that is held out; and then by merit. Of different names.
  [[nodiscard]] std::vector<std::size_t> partnered() const {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < singles_.size(); ++i)
      if (!singles_[i].hypothesis.per_setup) order.push_back(i);
    if (order.empty()) return order;
    std::vector<double> left(singles_.size());
    core::parallelFor(order.size(), 1, [&](std::size_t o, std::size_t) {
      core::stopIfCancelled(progress_);
      const Candidate& single = singles_[order[o]];
      left[order[o]] =
          discrepancyOf(judge_.replay, worldOf(judge_.replay, single.hypothesis, single.values), judge_.split.fitted);
    });
    const auto nearest =
        std::min_element(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return left[a] < left[b]; });
    if (nearest != order.begin()) std::rotate(order.begin() + 1, nearest, nearest + 1);
    std::vector<std::size_t> chosen;
    for (const std::size_t i : order) {
      const bool same = std::any_of(chosen.begin(), chosen.end(), [&](std::size_t c) {
        return singles_[c].hypothesis.name == singles_[i].hypothesis.name;
      });
      if (!same && chosen.size() < kPartnered) chosen.push_back(i);
    }
    return chosen;
  }

  /// Whether these two causes were fitted together already, and came as near to the data as this guess.
  [[nodiscard]] bool known(const Guess& guess) const {
    return std::any_of(pairs_.begin(), pairs_.end(), [&](const Fitted& pair) {
      if (std::minmax(pair.first, pair.second) != std::minmax(guess.first, guess.second)) return false;
      const Candidate& fitted = pair.candidate;
      return guesses_.distanceOf(fitted.hypothesis, fitted.values) <= guess.distance;
    });
  }

  /// Joint fits of the guesses that are new; `pairs_` stays in order of merit.
  void fit(std::vector<Guess> guesses) {
    guesses = guesses_.improved(std::move(guesses));
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
      candidate.hypothesis = guesses_.hypothesisOf(guess);
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
  const std::vector<Candidate>& singles_;
  core::Progress& progress_;
  const PairGuesses guesses_;
  std::vector<Fitted> pairs_;
};

}  // namespace

std::vector<Candidate> rankPairs(const Judge& judge, const std::vector<Candidate>& singles, core::Progress& progress) {
  return PairSearch(judge, singles, progress).run();
}

}  // namespace gap
