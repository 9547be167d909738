#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "gap/candidates/candidates.h"

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

/// The one of that name that comes first among some causes, which there is, with these values.
inline gap::Candidate causeNamed(const std::vector<gap::Candidate>& causes, const std::string& name,
                                 const std::vector<double>& values) {
  gap::Candidate cause =
      *std::find_if(causes.begin(), causes.end(), [&](const gap::Candidate& c) { return c.hypothesis.name == name; });
  cause.values = values;
  return cause;
}

}  // namespace test_support
