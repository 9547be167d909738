#pragma once

#include <nlohmann/json.hpp>

#include "gap/diagnosis.h"

namespace gap {

/// The report of formats.md section 6. `elapsed_s` is the only value that differs from run to run.
[[nodiscard]] nlohmann::ordered_json reportJson(const Diagnosis& diagnosis);

}  // namespace gap
