#pragma once

#include <string>

#include "gap/diagnosis.h"

namespace gap {

/// The diagnosis as a self-contained page: the verdict, where (rows and maps), which (ranked causes with intervals),
/// how far (before and after), the next experiment, and what was held out.
[[nodiscard]] std::string reportHtml(const Diagnosis& diagnosis);

}  // namespace gap
