#pragma once

#include <filesystem>
#include <functional>
#include <optional>

#include "core/detection_files/lidar_view.h"
#include "core/progress.h"
#include "model/experiment.h"
#include "model/lidar_model.h"
#include "model/reflections.h"
#include "model/signal/signal_chain.h"

namespace model {

/// The beams that a sample fires: its own list, or the scan of the model's profile (of the experiment's, if the model
/// is not the built-in lidar).
[[nodiscard]] std::vector<Beam> beamsOfSample(const Experiment& experiment, const LidarModel& model,
                                              const Sample& sample);

/// Geometry of one sample and epistemic corner: everything that the signal pass needs.
struct TracedSample {
  Situation situation;
  BeamHits hits;  ///< directions as aimed by the model's effects
};
[[nodiscard]] TracedSample traceSample(const Experiment& experiment, const LidarModel& model, const Sample& sample,
                                       const EpistemicOffsets& offsets = {});

/// The scene as seen from the sensor at the moments of its beams.
[[nodiscard]] RayTracer tracerOf(const Scene& scene, const ChainSettings& settings, std::span<const Beam> beams);

/// The same for beams and sub-rays of one's own.
[[nodiscard]] BeamHits traceWith(const SignalChain& chain, const Scene& scene, std::vector<Beam> beams,
                                 const SubRays& rays);

/// Simulates one sample at one corner of its epistemic box. `seed` overrides the model's. Reported directions are
/// those of the scan (the sensor does not know that it is misaligned). A model that is not ours is asked for this one
/// run (external/external_runs.h asks it for many at once).
[[nodiscard]] core::Detections simulate(const Experiment& experiment, const LidarModel& model, std::size_t sample,
                                        const EpistemicOffsets& offsets = {},
                                        std::optional<std::uint64_t> seed = std::nullopt);

// --- the two halves of a simulation, with reflections between them (reflections.h)
/// What the sub-rays of a sample at its nominal values bring back: one view, the same for every frame.
[[nodiscard]] core::LidarSensorView simulateReflections(const Experiment& experiment, const LidarModel& model,
                                                        const Sample& sample);
/// The receiver's half on reflections from elsewhere; with those of simulateReflections the result is that of
/// `simulate`. A trace of one message holds for every frame of the sample, otherwise it has one for each.
[[nodiscard]] core::Detections receive(const ReflectionTrace& trace, const Experiment& experiment,
                                       const LidarModel& model, std::size_t sample,
                                       std::optional<std::uint64_t> seed = std::nullopt);
/// The same without an experiment: every message is a frame, nothing is known of surroundings. `sensor` is one of the
/// model's, "" if there is one.
[[nodiscard]] core::Detections receive(const ReflectionTrace& trace, const LidarModel& model, const std::string& sensor,
                                       std::optional<std::uint64_t> seed = std::nullopt);

/// What simulatePackage does with reflections.
struct PackageReflections {
  bool write = false;          ///< reflections/ID.osi beside the measurements
  std::filesystem::path from;  ///< taken in place of the own ones: a trace for the only sample, a folder with ID.osi
                               ///< for each, or a package that was written with them; "": none
};

/// Simulates every sample at its nominal values into a new experiment package: same experiment.json (source says
/// "synthetic"), same measurement file names. All or nothing: the folder appears when all is written; an existing
/// non-empty folder is refused. `finish` may complete the package, given its folder, before it appears.
void simulatePackage(const Experiment& experiment, const LidarModel& model, const std::filesystem::path& folder,
                     std::optional<std::uint64_t> seed, core::Progress& progress,
                     const std::function<void(const std::filesystem::path&)>& finish = {},
                     const PackageReflections& reflections = {});

}  // namespace model
