#pragma once

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#include "gap/causes/hypotheses.h"

namespace test_support {

/// The one of that name in its usual form, or in another. Throws if there is none.
inline gap::Hypothesis hypothesisNamed(const std::vector<gap::Hypothesis>& all, const std::string& name,
                                       const std::string& form = "") {
  const auto found = std::find_if(all.begin(), all.end(), [&](const gap::Hypothesis& hypothesis) {
    return hypothesis.name == name && hypothesis.variant == form;
  });
  if (found == all.end()) throw std::runtime_error("no hypothesis " + name + " " + form);
  return *found;
}

}  // namespace test_support
