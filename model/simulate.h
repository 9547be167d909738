#pragma once

#include <filesystem>
#include <functional>
#include <optional>

#include "core/progress.h"
#include "model/experiment.h"
#include "model/lidar_model.h"
#include "model/signal/signal_chain.h"

namespace model {

/// The beams that a sample fires: its own list, or the scan of the model's profile.
[[nodiscard]] std::vector<Beam> beamsOfSample(const Experiment& experiment, const LidarModel& model,
                                              const Sample& sample);

/// Geometry of one sample and epistemic corner: everything that the signal pass needs.
struct TracedSample {
  Situation situation;
  BeamHits hits;  ///< directions as aimed by the model's effects
};
[[nodiscard]] TracedSample traceSample(const Experiment& experiment, const LidarModel& model, const Sample& sample,
                                       const EpistemicOffsets& offsets = {});

/// The same for beams and sub-rays of one's own.
[[nodiscard]] BeamHits traceWith(const SignalChain& chain, const Scene& scene, std::vector<Beam> beams,
                                 const SubRays& rays);

/// Simulates one sample at one corner of its epistemic box. `seed` overrides the model's. Reported directions are
/// those of the scan (the sensor does not know that it is misaligned).
[[nodiscard]] core::Detections simulate(const Experiment& experiment, const LidarModel& model, std::size_t sample,
                                        const EpistemicOffsets& offsets = {},
                                        std::optional<std::uint64_t> seed = std::nullopt);

/// Simulates every sample at its nominal values into a new experiment package: same experiment.json (source says
/// "synthetic"), same measurement file names. All or nothing: the folder appears when all is written; an existing
/// non-empty folder is refused. `finish` may complete the package, given its folder, before it appears.
void simulatePackage(const Experiment& experiment, const LidarModel& model, const std::filesystem::path& folder,
                     std::optional<std::uint64_t> seed, core::Progress& progress,
                     const std::function<void(const std::filesystem::path&)>& finish = {});

}  // namespace model
