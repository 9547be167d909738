#pragma once

#include <string>
#include <vector>

#include "gap/causes/fit.h"

namespace gap {

/// A possible cause as the world that it makes.
struct NamedWorld {
  std::string name;
  World world;
};

/// How alike causes are for the samples at hand:
///
///   alike(A, B) = 1 - (D(A, B) - D₀) / (max(D(A, baseline), D(B, baseline)) - D₀)
///
/// with D the discrepancy between two simulated worlds and D₀ that of a world to itself under other noise, clamped to
/// [0, 1]. 1: these samples cannot tell them apart. 0: they differ as much as either differs from the model as it is.
/// Symmetric, 1 on the diagonal.
struct Confusion {
  std::vector<std::string> names;
  std::vector<std::vector<double>> alike;
};

[[nodiscard]] Confusion confusionOf(const Replay& replay, const std::vector<NamedWorld>& causes,
                                    const Evidence& evidence);

/// What worlds predict of one measurand in one sample, over those beams in which the last two clearly differ.
struct Prediction {
  std::string measurand;  ///< a measurand's name, or "existence": echoes per shot
  std::string unit;
  double beams = 0.0;          ///< share of the beams that meet a surface
  std::vector<double> values;  ///< mean, one a world
  double noise = 0.0;          ///< standard error of one beam's difference
};

/// Most telling measurand first; those in which the last two worlds are alike are left out.
[[nodiscard]] std::vector<Prediction> predictionsOf(const Replay& replay, const std::vector<World>& worlds,
                                                    std::size_t sample, std::uint64_t seed);

}  // namespace gap
