#pragma once

#include <string>

namespace gap {

/// One acceptance test, judged with the model as it is and with the model that the diagnosis proposes. Whoever knows
/// acceptance tests fills it (acceptance/flips.h); the reports print it.
struct TwiceJudgedTest {
  std::string id;
  std::string title;
  std::string measurand;
  std::string before;  ///< verdict: "passed", "failed", "error", "skipped"
  std::string after;
  std::string text_before;  ///< one sentence: why
  std::string text_after;

  [[nodiscard]] bool flips() const { return before != after; }
};

}  // namespace gap
