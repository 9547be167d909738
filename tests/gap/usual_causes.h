#pragma once

#include <vector>

#include "gap/which/candidates.h"

namespace test_support {

/// Every cause that the library offers for this measurement, each at its usual values; not judged.
inline std::vector<gap::Candidate> usualCauses(const gap::Replay& replay) {
  std::vector<gap::Candidate> causes;
  for (const gap::Hypothesis& hypothesis : gap::hypothesesFor(replay, {})) {
    std::vector<double> values;
    for (const gap::FreeParameter& parameter : hypothesis.parameters) values.push_back(parameter.start);
    causes.push_back({.hypothesis = hypothesis, .values = values});
  }
  return causes;
}

}  // namespace test_support
