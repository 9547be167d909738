#pragma once

#include <limits>
#include <map>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <tuple>
#include <unordered_map>
#include <vector>

#include "gap/replay/cells.h"
#include "gap/replay/geometry_cache.h"
#include "gap/replay/transport.h"
#include "gap/replay/world.h"
#include "model/external/external_runs.h"
#include "model/simulate.h"

namespace gap {

/// A recorded quantity of a sample that is known to within an interval only (`epistemic` of the experiment).
struct Tolerance {
  std::string pointer;
  double low = 0.0;  ///< offset to the recorded value
  double high = 0.0;
  std::vector<float> range_per_unit;  ///< of every surface cell: how its range moves with the quantity [m/unit]
};

/// One sample with its measurement and the cells that pair it with simulations.
struct ReplaySample {
  std::size_t index = 0;  ///< in the experiment
  const model::Sample* sample = nullptr;
  model::Scene scene;  ///< as recorded; a patch may bring or take objects, so numbers of objects hold in a sample only
  core::Detections measured;
  std::vector<std::uint32_t> beam_of;      ///< of each measured detection
  std::vector<CellStatistics> statistics;  ///< of the measurement
  std::vector<CellStatistics> baseline;    ///< of a few frames of the baseline
  std::unique_ptr<CellLayout> layout;
  std::vector<Tolerance> tolerances;
  /// Of every cell: how far the power that it receives may be off, relative to it: as the reference moves within its
  /// epistemic intervals, and by the sub-rays. Large where an edge cuts the beam.
  std::vector<double> power_deviation;
  std::vector<model::Beam> beams;
  std::vector<std::uint32_t> taken;     ///< which beams of the scan these are; empty: all of them
  std::vector<model::Beam> whole_scan;  ///< if only some are taken
  int frames = 1;
  ForeignFrames foreign;  ///< what the model under test reported, if it is not the built-in lidar
};

/// How closely a replay looks.
struct Detail {
  /// Of every sample at most about so many take part, in pairs of neighbouring columns all over the scan.
  std::size_t most_beams = std::numeric_limits<std::size_t>::max();
  /// Per direction, of the denser, sheared grid of partly hit beams: their power is right to one over its square. 0:
  /// every beam on the model's own grid, as `fidelis simulate` traces it.
  int edge_rays = 45;
  bool joined = true;  ///< hits on one object are one, where they are near each other
};

/// Re-simulates the samples of an experiment in any world, with geometry that is traced once and shared. Partly hit
/// beams are traced more densely than the model's own grid, so that they do not differ by the grid alone, and hits on
/// one object are joined (unless the detail says otherwise). Thread-safe. References, model and experiment must outlive
/// it.
///
/// A model that is not the built-in lidar is known by what it reported (`foreign`, one run a sample). `baseline` is
/// then its proxy: the baseline world reports what the foreign model did, and every other world that with the
/// difference that it makes in the proxy (transport.h).
class Replay {
 public:
  Replay(const model::Experiment& experiment, const model::LidarModel& baseline, Detail detail = {},
         std::span<const model::ExternalRun> foreign = {})
      : Replay(experiment, baseline, detail, foreign, {}) {}

  /// The same replay with fewer of its beams.
  [[nodiscard]] Replay thinner(std::size_t most_beams) const;
  /// Another one of these beams alone, whatever the detail says of their number: of every sample numbers among the
  /// beams that it has here, ascending; none: all of the scan.
  [[nodiscard]] Replay only(std::vector<std::vector<std::uint32_t>> beams, Detail detail) const;
  [[nodiscard]] const Detail& detail() const noexcept { return detail_; }

  [[nodiscard]] const model::Experiment& experiment() const noexcept { return experiment_; }
  [[nodiscard]] const World& baseline() const noexcept { return baseline_; }
  [[nodiscard]] const std::vector<ReplaySample>& samples() const noexcept { return samples_; }
  /// Whether some beams were left out.
  [[nodiscard]] bool thinned() const;
  /// Channels that both were measured in every sample and are measurands of the experiment.
  [[nodiscard]] const std::vector<Channel>& channels() const noexcept { return channels_; }
  /// One step of the sensor's output in this channel (experiment.json).
  [[nodiscard]] double resolution(Channel channel) const { return resolution_[channel]; }

  /// Cell statistics of `frames` simulated frames of a sample.
  [[nodiscard]] std::vector<CellStatistics> simulate(const World& world, std::size_t sample, int frames,
                                                     std::uint64_t seed) const;
  /// Whether any sub-ray of a sample meets something by way of a mirror.
  [[nodiscard]] bool mirrors(const World& world, std::size_t sample) const;
  /// All frames of a sample as the sensor would report them.
  [[nodiscard]] core::Detections detections(const World& world, std::size_t sample, std::uint64_t seed) const;
  /// The same of the built-in lidar, whatever the model under test is.
  [[nodiscard]] core::Detections builtInDetections(const World& world, std::size_t sample, std::uint64_t seed) const;
  /// The seed under which the baseline world is what a foreign model reported, frame by frame; others give other noise.
  [[nodiscard]] std::uint64_t seed() const noexcept { return baseline_.model.seed; }

 private:
  using Geometry = GeometryCache::Geometry;
  /// `chosen`: numbers of beams in the whole scan, for each sample; empty: as the detail says.
  Replay(const model::Experiment& experiment, const model::LidarModel& baseline, Detail detail,
         std::span<const model::ExternalRun> foreign, const std::vector<std::vector<std::uint32_t>>& chosen);
  /// Where several sensors stand side by side: whether this one sees nothing of what the world changes.
  [[nodiscard]] bool untouched(const World& world, const std::string& sensor) const;
  [[nodiscard]] Geometry geometryOf(const World& world, std::size_t sample) const;
  [[nodiscard]] Geometry trace(const World& world, std::size_t sample) const;
  void addTolerance(ReplaySample& sample, std::size_t index, const model::Epistemic& epistemic) const;
  [[nodiscard]] std::vector<model::Shot> fire(const World& world, std::size_t sample, int frames,
                                              std::uint64_t seed) const;
  [[nodiscard]] std::vector<model::Shot> fireBuiltIn(const World& world, std::size_t sample, int frames,
                                                     std::uint64_t seed) const;
  [[nodiscard]] core::Detections reported(const std::vector<model::Shot>& shots, const World& world,
                                          std::size_t sample) const;
  using Shots = std::shared_ptr<const std::vector<model::Shot>>;
  [[nodiscard]] Shots proxyShots(std::size_t sample, int frames, std::uint64_t seed) const;

  const model::Experiment& experiment_;
  Detail detail_;
  World baseline_;
  std::vector<ReplaySample> samples_;
  std::vector<Channel> channels_;
  std::array<double, kChannels> resolution_{};
  mutable GeometryCache traced_;
  mutable std::mutex mutex_;
  mutable std::map<std::tuple<std::size_t, int, std::uint64_t>, std::vector<CellStatistics>> untouched_;
  mutable std::size_t remembered_cells_ = 0;
  std::span<const model::ExternalRun> foreign_;
  mutable std::unordered_map<std::string, Shots> fired_;  ///< of the proxy's baseline
  mutable std::size_t remembered_shots_ = 0;
};

/// Samples of one set-up: they share the errors of its reference.
struct SetUp {
  std::string name;
  std::vector<std::size_t> samples;
};
/// The set-ups of some samples, or of all, each once, in the order of the samples.
[[nodiscard]] std::vector<SetUp> setupsOf(const Replay& replay, const std::vector<std::size_t>& samples);
[[nodiscard]] std::vector<SetUp> setupsOf(const Replay& replay);

/// The ids of all objects of all samples, each once, in the order of the scenes.
[[nodiscard]] std::vector<std::string> objectsOf(const Replay& replay);

/// Smallest distance of two neighbouring beams of a layer in azimuth, over the first sample; 1 if there is none.
[[nodiscard]] double azimuthStep_deg(const Replay& replay);

}  // namespace gap
