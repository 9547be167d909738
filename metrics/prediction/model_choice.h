#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "metrics/prediction/error_samples.h"
#include "metrics/prediction/family.h"

namespace metrics {

/// How well one family predicts samples that it has not seen.
struct Candidate {
  Family family;
  std::optional<double> score;  ///< root of the weighted mean square of all misses; smaller is better. [unit of error]
  std::string reason;           ///< why it was not considered; empty if it was
};

struct ModelChoice {
  Family family;
  std::vector<Candidate> candidates;  ///< every family asked for, simplest first
  std::size_t folds;                  ///< into which the samples were split
};

struct ChoiceOptions {
  std::span<const Family> families = kFamilies;
  std::size_t folds = 0;        ///< 0: leave one set-up (row) out, or 10 folds of more than 50: time grows as n^2
  bool never_negative = false;  ///< predictions are cut at 0, as they will be
};

/// The family with the least score of cross-validation: each fold is predicted by a fit of all others.
///
/// Rows of one set-up stay together, since they share an error: predicted from its neighbours of the same set-up a row
/// would flatter the family. Set-ups go to the folds in turn, in order of their first row: no randomness. Families
/// whose scores differ by less than 1e-6 of the range of the errors tie; the simpler one wins. A family is left out,
/// with its reason, if a fold leaves too few rows for its coefficients or does not determine them. Throws InputError if
/// no family is left (a single row or set-up) or the samples are bad. Source: Stone 1974, J. R. Stat. Soc. B 36, p.
/// 111.
[[nodiscard]] ModelChoice chooseFamily(const ErrorSamples& samples, const ChoiceOptions& options = {});

}  // namespace metrics
