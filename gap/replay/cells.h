#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "core/detections.h"
#include "model/geometry/geometry_pass.h"
#include "model/scene/scene.h"
#include "model/signal/signal_chain.h"

namespace gap {

/// The three quantities that a detection carries.
enum Channel : std::size_t { kRange, kEpw, kIntensity, kChannels };
[[nodiscard]] const char* nameOf(Channel channel);
/// The column of a measurement that carries it.
[[nodiscard]] const char* columnOf(Channel channel);

/// Of a beam: which part of it meets a surface is known no better; sub-ray grids of two programs agree no better.
constexpr double kShareError = 0.004;
/// Of a beam: a surface that meets so much of it is cut by no edge.
constexpr double kWholeBeam = 0.999;
/// Of the shots: rarer detections in a beam may come from anywhere, and a cell so rare is no more than its rate.
constexpr double kOftenDetected = 0.3;

/// Where measured and simulated detections are paired: one surface seen by one beam of one sample. The frames of a
/// sample are repetitions of a cell. What the simulation knows of it comes from the baseline's geometry.
struct Cell {
  std::uint32_t beam = 0;
  std::int32_t object = -1;  ///< -1: nothing is there, its detections are unexpected ("extra")
  double anchor_m = 0.0;     ///< range at which the surface is expected
  double incidence_rad = 0.0;
  double power_over_threshold = 0.0;  ///< of the baseline, before noise
  double share = 1.0;  ///< of the beam, that meets the surface; of extra cells, that goes on behind panes or mirrors
  /// Two programs never agree on it. Of a surface: the beam is not wholly on it, or grazes it so flatly that what it
  /// meets lies farther apart than the pulse is long. Of what is unexpected: the beam, or the next one of its layer, is
  /// not wholly on one surface or on none, or what it meets behind a pane or by way of a mirror ends within it.
  bool at_edge = false;
  /// An echo, by another surface that so little of the beam meets that two programs need not agree whether it adds to
  /// the echo.
  double may_be_longer_m = 0.0;
};

/// Count, mean and spread of the detections of a cell over the frames.
struct CellStatistics {
  double count = 0.0;
  std::array<double, kChannels> sum{};
  std::array<double, kChannels> sum_of_squares{};  ///< about `anchor` (range) or zero

  CellStatistics& operator+=(const CellStatistics& more);  ///< of cells with the same anchor
  /// As if every value were larger by so much.
  void moveMean(Channel channel, double by);
  [[nodiscard]] double mean(Channel channel) const { return sum[channel] / count; }
  [[nodiscard]] double variance(Channel channel) const;  ///< n-1; 0 below two detections
};

/// All cells of one sample. Cells with a surface come first, beam by beam; then one extra cell a beam, for what comes
/// from nowhere, from behind a pane, or by way of a mirror. A detection that lies far from its cell's median (six
/// standard deviations, estimated from the median deviation, and farther than the edge of a weak echo walks) was not
/// made by the surface and counts as extra: one false echo would otherwise move the mean of a cell by more than its
/// error. One whose echo pulse width lies far above the median has merged with a false echo: it counts with the median
/// width.
class CellLayout {
 public:
  /// What was recorded of the detections of all samples beside their ranges.
  struct Recorded {
    bool directions, widths;
  };
  CellLayout(const model::BeamHits& hits, const model::Scene& scene, const model::SignalChain& baseline,
             Recorded recorded);

  [[nodiscard]] const std::vector<Cell>& cells() const noexcept { return cells_; }
  [[nodiscard]] std::size_t surfaces() const noexcept { return surfaces_; }
  [[nodiscard]] bool pooled() const noexcept { return !recorded_.directions; }  ///< everything is one cell

  /// What every surface cell would be in other geometry: mean range (NaN where its object is not met) and received
  /// power, in any unit, which falls with r⁻² and the share of the beam that the object leaves.
  struct Seen {
    double range_m;
    double power;
  };
  [[nodiscard]] std::vector<Seen> seenIn(const model::BeamHits& hits) const;

  [[nodiscard]] std::vector<CellStatistics> statisticsOf(const std::vector<model::Shot>& shots) const;
  /// The cell of each shot; outliers belong to the extra cell of their beam.
  [[nodiscard]] std::vector<std::size_t> cellsOf(const std::vector<model::Shot>& shots) const;
  /// `beam_of[i]` is the beam of detection i.
  [[nodiscard]] std::vector<std::size_t> cellsOf(const core::Detections& detections,
                                                 const std::vector<std::uint32_t>& beam_of) const;
  [[nodiscard]] std::vector<CellStatistics> statisticsOf(const core::Detections& detections,
                                                         const std::vector<std::uint32_t>& beam_of) const;

 private:
  struct Value {
    std::uint32_t beam;
    std::array<double, kChannels> of;
  };
  [[nodiscard]] std::size_t cellOf(std::uint32_t beam, double range_m) const;
  [[nodiscard]] std::vector<Value> valuesOf(const std::vector<model::Shot>& shots) const;
  [[nodiscard]] std::vector<Value> valuesOf(const core::Detections& detections,
                                            const std::vector<std::uint32_t>& beam_of) const;
  /// The cell of each detection, and the usual echo pulse width of the cell for those with which another echo merged.
  struct Assigned {
    std::vector<std::size_t> cell_of;
    std::vector<std::pair<std::size_t, double>> usual_width_m;  ///< by detection
  };
  [[nodiscard]] Assigned assigned(const std::vector<Value>& values) const;
  [[nodiscard]] std::vector<CellStatistics> statisticsOf(std::vector<Value> values) const;
  void add(std::vector<CellStatistics>& statistics, std::size_t cell,
           const std::array<double, kChannels>& values) const;

  std::vector<Cell> cells_;
  std::vector<std::uint32_t> first_;  ///< surface cells of beam b: first_[b] … first_[b + 1]
  std::size_t surfaces_ = 0;
  std::vector<double> second_m_;             ///< ranges of what beams meet by second ways, beam by beam
  std::vector<std::uint32_t> first_second_;  ///< like `first_`
  double separation_m_ = 0.0;                ///< nearer to each other two echoes are one
  double reach_m_ = 0.0;                     ///< farther from every anchor a detection is extra
  /// Nearer to the medians of its cell a detection is no outlier.
  struct Tolerance {
    double range_m, width_m;
  };
  std::vector<Tolerance> tolerances_;  ///< of surfaces
  Recorded recorded_;
};

/// The beam of every detection: the nearest of its layer in azimuth. Throws InputError if a layer does not exist in
/// the profile or a direction is farther from every beam than one step.
[[nodiscard]] std::vector<std::uint32_t> beamsOfDetections(const core::Detections& detections,
                                                           const std::vector<model::Beam>& beams,
                                                           const std::filesystem::path& file);

}  // namespace gap
