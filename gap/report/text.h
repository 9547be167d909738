#pragma once

#include <string>

#include "gap/diagnosis.h"

namespace gap {

/// The diagnosis as lines for a terminal: the verdict; of every kind of difference where it lies, three at most; every
/// cause that was weighed, with its numbers; notes; acceptance tests that flip; the next experiment.
[[nodiscard]] std::string reportText(const Diagnosis& diagnosis);

}  // namespace gap
