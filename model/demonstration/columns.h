#pragma once

#include <string>
#include <vector>

#include "core/detections.h"

namespace model {

/// What a picture can show of a detection: columns of a measurement, and what follows from them.
[[nodiscard]] const std::vector<std::string>& shownColumns();

/// One value a detection. Throws InputError if the detections lack what it takes.
[[nodiscard]] std::vector<double> shownColumn(const core::Detections& detections, const std::string& name);

}  // namespace model
