#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/progress.h"
#include "gap/candidates/candidates.h"

namespace gap {

/// One hypothesis that was tried, for a reader who asks what else was weighed, and what two judges that do not think
/// would say of it, to be compared with what was decided.
struct Tried {
  std::string kind;      ///< "none" (the model as it is), "effect", "parameter", "reference" or "pair"
  std::size_t rank = 0;  ///< among the single causes or among the pairs, 1 is best; 0 of "none"
  std::string name;
  std::string variant;
  std::vector<std::string> sensors;
  std::vector<std::pair<std::string, double>> values;  ///< of its free numbers
  double explained = 0.0;                              ///< Candidate::explained, by which it was judged
  double discrepancy = 0.0;          ///< on held-out data, of all hypotheses on the same few hundred beams
  double bic = 0.0;                  ///< smaller is better (bicOf)
  std::optional<double> similarity;  ///< largest cosine of its signature with the measurement's; not of none and pairs
};

/// How far the cell means of a world are from fitted data. Σ z² is about n where the world is right:
///
///   z  difference of a cell's mean over its standard error (comparableError), of every channel, and of the share of
///      shots detected; a surface that only one side detects counts as far off in every channel
///   n  number of terms
///
/// That they are not independent (set-ups, tolerances of the reference) is what this judge does not know.
struct MeansApart {
  double sum = 0.0;       ///< Σ z²
  std::size_t terms = 0;  ///< n

  void add(double z) {
    sum += z * z;
    ++terms;
  }
};
[[nodiscard]] MeansApart meansApart(const Replay& replay, const World& world, const Evidence& fitted);

/// Bayesian information criterion, Σ z² + k ln n with k free numbers, were all means independent and normal.
/// Source: Schwarz 1978, Ann. Stat. 6, 461.
[[nodiscard]] double bicOf(const MeansApart& means, std::size_t free_numbers);

/// All that was tried, "none" first, then single causes and pairs in the order in which they were ranked.
[[nodiscard]] std::vector<Tried> triedOf(const Judge& judge, const std::vector<Candidate>& singles,
                                         const std::vector<Candidate>& pairs, const core::Progress& progress);

/// As CSV (docs/formats.md).
[[nodiscard]] std::string toCsv(const std::vector<Tried>& tried);

}  // namespace gap
