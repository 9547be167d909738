#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "gap/replay/cells.h"
#include "gap/replay/transport.h"
#include "model/external/external_runs.h"
#include "model/simulate.h"

namespace gap {

/// A recorded quantity of a sample that is known to within an interval only (`epistemic` of the experiment), or where
/// echoes begin that no surface makes.
struct Tolerance {
  std::string pointer;  ///< of the latter a name with the sensor's, which no pointer is
  double low = 0.0;     ///< offset to the recorded value
  double high = 0.0;
  std::vector<float> range_per_unit;  ///< of every cell that may move: how its range does with the quantity [m/unit]

  /// Of the offset, which lies evenly within its interval. [unit²]
  [[nodiscard]] double variance() const { return (high - low) * (high - low) / 12.0; }
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
  /// Of every cell: how far the mean of its ranges may be off beside what the tolerances move it by, squared: a counter
  /// of coarse steps, seen in the measured ranges, tells another step (jumpVariance).
  std::vector<double> jump_variance_m2;
  std::vector<model::Beam> beams;
  std::vector<std::uint32_t> taken;     ///< which beams of the scan these are; empty: all of them
  std::vector<model::Beam> whole_scan;  ///< if only some are taken
  int frames = 1;
  ForeignFrames foreign;  ///< what the model under test reported, if it is not the built-in lidar

  /// Standard deviation of a cell's range as its tolerances move it.
  [[nodiscard]] double rangeDeviation_m(std::size_t cell) const;
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

/// Which beams of a scan take part: their numbers, ascending; none: all of them.
using BeamChoice = std::function<std::vector<std::uint32_t>(const std::vector<model::Beam>& whole_scan)>;

/// A sample as it is read, with the chosen ones of its beams. Its scene, cells and what comes of them are not filled.
/// `foreign`: what the model under test reported, if it is not the built-in lidar, else null. Throws InputError
/// (data_checks.h; a foreign model that lacks directions).
[[nodiscard]] ReplaySample readSample(const model::Experiment& experiment, std::size_t index,
                                      const model::LidarModel& baseline, const model::ExternalRun* foreign,
                                      const BeamChoice& choice);

/// About so many beams, in pairs of neighbouring columns all over the scan; empty if that is all of them.
[[nodiscard]] std::vector<std::uint32_t> evenlyOf(const std::vector<model::Beam>& beams, std::size_t most);

/// Leaves the shots of the beams taken, numbered among these.
void keepTaken(const std::vector<std::uint32_t>& taken, std::vector<model::Shot>& shots);

/// Which channels all of these detections hold, but for those without any.
class CommonChannels {
 public:
  void add(const core::Detections& detections);
  [[nodiscard]] bool has(Channel channel) const { return everywhere_[channel]; }

 private:
  std::array<bool, kChannels> everywhere_{true, true, true};
};

}  // namespace gap
