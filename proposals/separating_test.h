#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/progress.h"
#include "model/lidar_model.h"
#include "proposals/gap_report.h"
#include "specs/items.h"

namespace proposals {

/// A test that the model as it was fails, and the model with the cause passes.
struct SeparatingTest {
  specs::AcceptanceTest test;  ///< without id and uid
  double worst_before = 0.0;   ///< of the value that it limits, over its samples; infinite where nothing is simulated
  double worst_after = 0.0;
  bool judged = false;  ///< by re-simulation with both models; else from the means of the report
};

/// Where the test gets its files from.
struct Bound {
  std::filesystem::path folder;            ///< of the project: the paths of the test begin here
  std::string experiment;                  ///< package, relative to it
  std::string model;                       ///< file of the model as it was, relative to it
  std::optional<model::LidarModel> after;  ///< with the cause; nothing: the limit comes from the report's means
};

/// The test that would have caught the gap, on the held-out samples of the report: measurands are tried in the order of
/// what the cause takes away from their gap, and of each the number (d_bias, d_cavm; share of missing or extra echoes)
/// whose worst sample improves most. The limit lies halfway between the worst sample before and after, rounded to two
/// digits. Nothing if no limit separates the two. Throws InputError for files that cannot be used, Cancelled.
[[nodiscard]] std::optional<SeparatingTest> separatingTest(const GapReport& report, const Bound& bound,
                                                           core::Progress& progress);

/// The number with the fewest digits (at least two) between the two, nearest to their middle. a < b.
[[nodiscard]] double roundBetween(double a, double b);

}  // namespace proposals
