#pragma once

#include <string>
#include <vector>

#include "model/sensor/sensor_profile.h"

namespace model {

/// How bad a finding is: an error contradicts itself and simulates nothing sensible, a warning is unlikely to be meant,
/// a note says what follows from the numbers.
enum class Severity { kError, kWarning, kNote };
[[nodiscard]] std::string toString(Severity severity);

/// What is remarkable about a profile that can be read.
struct Finding {
  Severity severity = Severity::kNote;
  std::string pointer;  ///< JSON Pointer into the profile
  std::string problem;
  std::string reason;  ///< why that matters
  std::string remedy;
};

/// All findings, worst first, otherwise in the order of the profile's blocks. What cannot be right in any profile
/// (negative power, zero threshold, unknown keys, 10⁹ beams) is refused when the profile is read.
/// Eye safety is not looked at.
[[nodiscard]] std::vector<Finding> plausibilityOf(const SensorProfile& sensor);

}  // namespace model
