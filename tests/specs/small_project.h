#pragma once

#include "specs/project_store.h"

namespace test_specs {

inline const specs::Signature kEve{.who = "eve", .when = "2026-01-02T03:04:05Z"};

/// phenomenon 0 <- effect 1 <- causes 2 (design), 3 (system independent); 0 <- 3. Texts with everything that hurts.
[[nodiscard]] percollect::Graph smallGraph();

/// A row scored by two experts, its requirement, a test, experiment and reference data, all linked:
///   row -> RangeError_Fog_1 (general) -> RangeError_Fog_2 (detection model) -> test _3 -> experiment _4, reference _5
void fill(specs::ProjectStore& store);

}  // namespace test_specs
