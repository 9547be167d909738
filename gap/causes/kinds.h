#pragma once

#include <string>
#include <vector>

#include "gap/causes/hypotheses.h"

namespace gap {

// The kinds of causes, a file each (<kind>_hypotheses.cpp); hypothesesFor lists them. A new kind is added here.

/// Effects that the model lacks, on all sensors and on every part of them. `only` names those considered (empty: all).
void addEffectHypotheses(const Replay& replay, const std::vector<std::string>& only, std::vector<Hypothesis>& list);

/// Numbers of sensor and active effects, and the reflectivity of the materials of some objects (by id).
void addParameterHypotheses(const Replay& replay, const std::vector<std::string>& objects,
                            std::vector<Hypothesis>& list);

/// Poses of some objects (by id), off by the same everywhere or by something else in every set-up. An object that has
/// not the same number in the scenes of all samples that have it has no JSON Pointer, and is left out.
void addReferenceHypotheses(const Replay& replay, const std::vector<std::string>& objects,
                            std::vector<Hypothesis>& list);

/// The number of an effect as it is fitted: what it declares of its plausible range.
[[nodiscard]] FreeParameter declared(const model::ParameterInfo& info);

/// JSON Pointers to the profiles of these sensors (none named: all) in a model file.
[[nodiscard]] std::vector<std::string> profilesIn(const nlohmann::json& model,
                                                  const std::vector<std::string>& sensors = {});

/// Sets a number of the world's model file.
void setNumber(World& world, const std::string& pointer, double value);

}  // namespace gap
