#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <tuple>
#include <unordered_map>
#include <vector>

#include "gap/replay/comb.h"
#include "gap/replay/geometry_cache.h"
#include "gap/replay/replay_sample.h"
#include "gap/replay/world.h"
#include "model/external/external_runs.h"
#include "model/simulate.h"

namespace gap {

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
  /// Whether a world sends any ray of any sample another way than the baseline does, or to another place.
  [[nodiscard]] bool movesRays(const World& world) const;
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
  /// Cells of a sample that was read, and what the baseline says of them.
  void pairWithBaseline(std::size_t sample);
  /// What steps of the measured ranges, of which the baseline's profiles know nothing, make of the tolerances.
  void addJumps();
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

/// The comb of all ranges that these sensors measured (none named: all), if it is coarser than the steps of their own
/// profiles. [m]
[[nodiscard]] std::optional<Comb> rangeComb(const Replay& replay, const std::vector<std::string>& sensors = {});

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
