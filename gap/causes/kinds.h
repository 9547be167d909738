#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "gap/causes/hypotheses.h"

namespace gap {

// The kinds of causes, a file each (<kind>_hypotheses.cpp); hypothesesFor lists them. A new kind is added here.

/// Effects that the model lacks, on all sensors and on every part of them. `only` names those considered (empty: all).
void addEffectHypotheses(const Replay& replay, const std::vector<std::string>& only, std::vector<Hypothesis>& list);

/// Numbers of sensor and active effects, and the reflectivity of the materials of some objects (indices in the scene).
void addParameterHypotheses(const Replay& replay, const std::set<std::int32_t>& objects, std::vector<Hypothesis>& list);

/// Poses of some objects, off by the same everywhere or by something else in every set-up.
void addReferenceHypotheses(const Replay& replay, const std::set<std::int32_t>& objects, std::vector<Hypothesis>& list);

}  // namespace gap
