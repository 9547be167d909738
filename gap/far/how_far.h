#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/progress.h"
#include "gap/causes/fit.h"
#include "gap/distance/total_gap.h"

namespace gap {

struct Interval {
  double low = 0.0;
  double high = 0.0;
};

struct Shrink {
  double fraction = 0.0;  ///< 1 - after/before of the total gap on held-out samples
  Interval interval;      ///< 90 %, of what a repetition of the held-out experiments would show
};

/// The total gap of one held-out sample without and with the verdict's cause.
struct SampleTotals {
  std::string sample;
  std::string setup;
  double before = 0.0;
  double after = 0.0;
};

/// The total gap with a cause added, and how much of it is gone.
struct After {
  TotalGap gap;
  Shrink shrink;  ///< interval from a bootstrap over set-ups, frames and references
  std::vector<SampleTotals> samples;
};

/// The same with the model's own rays, as `fidelis simulate` traces. A diagnosis traces beams more finely that an edge
/// cuts or an oblique surface tears apart, so that a coarse grid is neither taken for a gap nor for a cause.
struct AsRun {
  struct Corrected {
    double after_total = 0.0;
    Shrink shrink;
  };
  double before_total = 0.0;
  std::optional<Corrected> corrected;  ///< if a cause was added
  int rays_horizontal = 1;             ///< of a beam
  int rays_vertical = 1;
};

/// The total gap on the held-out samples, without and with a cause. The model as it was brought is simulated once.
class HeldOutGaps {
 public:
  HeldOutGaps(const Replay& replay, std::vector<std::size_t> samples, std::uint64_t seed);

  /// Mean of the samples, of the model as it was brought.
  [[nodiscard]] const TotalGap& before() const noexcept { return before_; }
  /// Of its d_bias, per measurand.
  [[nodiscard]] std::map<std::string, Interval> biasIntervals() const;
  /// The mean total gap in another world.
  [[nodiscard]] double totalIn(const World& world) const;
  /// What another world leaves of the gap beyond what it would leave if it were right, as a share of what the model as
  /// it was brought leaves beyond that; 1: nothing is gone.
  [[nodiscard]] double leftIn(const World& world) const;
  /// Share of the gap that lies above the noise of the model as it was brought: near 0, `leftIn` is guesswork.
  [[nodiscard]] double aboveNoise() const;
  /// The gap is larger than what a right model would leave, so much so that it is worth a cause.
  [[nodiscard]] bool material() const noexcept;
  /// 1 - after / before.
  [[nodiscard]] double shrinkTo(double after) const;
  [[nodiscard]] After with(const World& world, const core::Progress& progress) const;

 private:
  /// One draw of set-ups and of the frames of their samples, with replacement; references stand elsewhere within what
  /// is recorded of them.
  struct Drawn {
    std::vector<std::size_t> samples;          ///< places in `samples_`
    std::vector<std::vector<int>> frames;      ///< of each
    std::vector<std::vector<double>> offsets;  ///< of each, one a tolerance (ReplaySample::tolerances)
    TotalGap before;
  };
  [[nodiscard]] Drawn drawn(std::size_t number) const;
  /// The measurement of a sample if its references stood so much elsewhere: ranges move to first order. Of all draws at
  /// once they would take gigabytes, so they are made anew for every world.
  [[nodiscard]] core::Detections measuredAt(const std::vector<double>& offsets, std::size_t place) const;
  [[nodiscard]] TotalGap gapOf(const Drawn& drawn, const std::vector<core::Detections>& simulated) const;
  [[nodiscard]] std::vector<core::Detections> simulated(const World& world, std::uint64_t seed) const;
  [[nodiscard]] std::vector<TotalGap> gapsTo(const std::vector<core::Detections>& simulated) const;
  /// Mean total gap between two simulations.
  [[nodiscard]] double between(const std::vector<core::Detections>& one,
                               const std::vector<core::Detections>& other) const;
  /// Mean total gap to the measurement, with what measurands added that can no longer be compared.
  [[nodiscard]] double toMeasurement(const std::vector<core::Detections>& simulated) const;

  const Replay& replay_;
  std::vector<std::size_t> samples_;
  std::vector<std::vector<std::size_t>> of_setup_;  ///< places in `samples_`
  std::uint64_t seed_;
  std::vector<std::vector<std::size_t>> cells_;  ///< of every measured detection, by sample
  std::vector<TotalGap> gaps_before_;
  TotalGap before_;
  double noise_ = 0.0;  ///< of the model as it was brought
  std::vector<Drawn> draws_;
};

}  // namespace gap
