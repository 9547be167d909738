#pragma once

#include <optional>
#include <string>
#include <vector>

#include "specs/results.h"

namespace desktop {

/// One relation of one sample: what the table of a result shows.
struct ShownRelation {
  std::size_t sample;  ///< index into the samples
  std::string text;    ///< "abs(d_bias) <= 0.005 * range_m"
  std::string value;   ///< empty: not a number
  std::string limit;
  std::string margin;  ///< > 0: inside the limit
  bool holds;
  double room = 0.0;  ///< margin as a share of the limit: the least decides
};

struct ShownSample {
  std::string id;
  specs::Verdict verdict = specs::Verdict::Skipped;
  std::string text;
  std::string figure;  ///< SVG; empty if there was nothing to draw
};

struct ShownResult {
  std::string experiment;  ///< title
  std::string unit;        ///< of the measurand
  bool synthetic = false;  ///< no sensor measured this
  std::vector<ShownSample> samples;
  std::vector<ShownRelation> relations;

  /// Index of the relation with the least room; 0 if there is none.
  [[nodiscard]] std::size_t decisive() const;
};

/// Reads what acceptance stored with a verdict (acceptance/result_json.h). A verdict without evaluation, or with one
/// that a later program wrote otherwise, gives its samples with value and limit only.
[[nodiscard]] ShownResult shownResult(const specs::TestVerdict& verdict);

}  // namespace desktop
