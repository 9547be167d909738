#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/progress.h"
#include "gap/twice_judged_test.h"
#include "model/experiment.h"
#include "model/lidar_model.h"
#include "specs/project_store.h"

namespace acceptance {

/// The same simulation twice: as it is, and as a diagnosis proposes it.
struct ModelPair {
  model::LidarModel before;
  model::LidarModel after;
};

/// The acceptance tests of a project that are bound to an experiment: they name its folder, or a package of the same
/// id. Rejected tests are not.
[[nodiscard]] std::vector<specs::AcceptanceTest> testsOf(const specs::ProjectStore& store,
                                                         const model::Experiment& experiment);

/// Judges each of them with both models, whatever model they name. Stores nothing. A test that cannot be decided has
/// the verdict "error" and says why. Throws Cancelled.
[[nodiscard]] std::vector<gap::TwiceJudgedTest> judgeTwice(const specs::ProjectStore& store,
                                                           const model::Experiment& experiment, const ModelPair& models,
                                                           std::optional<std::uint64_t> seed, core::Progress& progress);

}  // namespace acceptance
