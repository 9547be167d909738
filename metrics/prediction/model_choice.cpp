#include "metrics/prediction/model_choice.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <map>

#include "core/error.h"
#include "metrics/prediction/regression.h"

namespace metrics {

namespace {

constexpr std::size_t kMostLeftOutAlone = 50;

/// Rows to learn from and rows to predict.
struct Fold {
  ErrorSamples seen;
  ErrorSamples unseen;
};

/// Number of each row's set-up, in order of first appearance.
std::vector<std::size_t> setupOfRow(const ErrorSamples& samples) {
  std::vector<std::size_t> of_row;
  std::map<std::string, std::size_t> known;
  std::size_t next = 0;
  for (std::size_t row = 0; row < samples.size(); ++row) {
    if (samples.setups.empty() || samples.setups[row].empty()) {  // on its own
      of_row.push_back(next++);
      continue;
    }
    const auto [entry, is_new] = known.try_emplace(samples.setups[row], next);
    if (is_new) ++next;
    of_row.push_back(entry->second);
  }
  return of_row;
}

std::vector<Fold> foldsOf(const ErrorSamples& samples, std::size_t wanted) {
  const std::vector<std::size_t> setups = setupOfRow(samples);
  const std::size_t count = 1 + *std::max_element(setups.begin(), setups.end());
  if (count < 2) {
    throw core::InputError({.item = samples.target}, "there is only one row or set-up; no family can be tried out.",
                           "Add results of other set-ups, or name the family.");
  }
  if (wanted == 1 || wanted > count) {
    throw core::InputError({.item = "folds"}, fmt::format("{} are asked for; 2 to {} are possible.", wanted, count),
                           "Give 0 to leave out one set-up at a time.");
  }
  const std::size_t usual = count > kMostLeftOutAlone ? 10 : count;
  const std::size_t folds = wanted == 0 ? usual : wanted;
  std::vector<Fold> all;
  for (std::size_t fold = 0; fold < folds; ++fold) {
    std::vector<std::size_t> seen;
    std::vector<std::size_t> unseen;
    for (std::size_t row = 0; row < samples.size(); ++row) {
      (setups[row] % folds == fold ? unseen : seen).push_back(row);
    }
    all.push_back({.seen = rowsOf(samples, seen), .unseen = rowsOf(samples, unseen)});
  }
  return all;
}

struct Sums {
  double squares = 0.0;
  double weights = 0.0;
};

void addMisses(const Fold& fold, Family family, bool never_negative, Sums& sums) {
  const Regression regression = regress(fold.seen, family);
  for (std::size_t row = 0; row < fold.unseen.size(); ++row) {
    double value = fittedValue(regression, fold.unseen.point(row)).value;
    if (never_negative) value = std::max(0.0, value);
    const double miss = fold.unseen.errors[row] - value;
    sums.squares += fold.unseen.weight(row) * miss * miss;
    sums.weights += fold.unseen.weight(row);
  }
}

Candidate tried(Family family, const std::vector<Fold>& folds, bool never_negative) {
  Candidate candidate{.family = family, .score = {}, .reason = {}};
  Sums sums;
  for (std::size_t k = 0; k < folds.size(); ++k) {
    try {
      addMisses(folds[k], family, never_negative, sums);
    } catch (const core::InputError& error) {
      candidate.reason =
          fmt::format("without fold {} of {}: {}: {}", k + 1, folds.size(), error.place().item, error.problem());
      return candidate;
    }
  }
  const double score = std::sqrt(sums.squares / sums.weights);
  if (std::isfinite(score)) {
    candidate.score = score;
  } else {
    candidate.reason = "it predicts no finite number for a sample left out.";
  }
  return candidate;
}

/// Scores closer than this are equal: far below what matters, far above rounding.
double tieOf(const ErrorSamples& samples) {
  const auto [least, most] = std::minmax_element(samples.errors.begin(), samples.errors.end());
  return 1e-6 * (*most - *least) + 1e-12 * std::max(std::abs(*least), std::abs(*most));
}

}  // namespace

ModelChoice chooseFamily(const ErrorSamples& samples, const ChoiceOptions& options) {
  check(samples);
  const std::vector<Fold> folds = foldsOf(samples, options.folds);
  ModelChoice choice{.family = Family::Constant, .candidates = {}, .folds = folds.size()};
  std::vector<Family> families(options.families.begin(), options.families.end());
  std::sort(families.begin(), families.end());
  for (const Family family : families) choice.candidates.push_back(tried(family, folds, options.never_negative));
  const double tie = tieOf(samples);
  const Candidate* best = nullptr;
  for (const Candidate& candidate : choice.candidates) {
    if (candidate.score && (!best || *candidate.score < *best->score - tie)) best = &candidate;
  }
  if (!best) {
    throw core::InputError({.item = samples.target},
                           "no family can be tried out; " +
                               (choice.candidates.empty() ? "none is given." : choice.candidates.front().reason),
                           "Add validation results at other values of the parameters.");
  }
  choice.family = best->family;
  return choice;
}

}  // namespace metrics
