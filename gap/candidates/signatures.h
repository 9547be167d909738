#pragma once

#include <cstdint>
#include <vector>

#include "gap/distance/comparison.h"
#include "gap/replay/replay.h"

namespace gap {

/// What a change of the world does to the data: shifts of cell means, of detections per frame and of spreads, each in
/// its standard error, from those of the baseline. The shifts of small changes add up, so that signatures of single
/// causes tell which two of them together may look like the measurement.
using Signature = std::vector<float>;

/// The cells and scales in which signatures are taken: a few samples, a thousand cells, errors that the measurement and
/// the baseline have. A shift of more than `most_errors` counts as that: ten, or more where large shifts of two causes
/// are to leave next to nothing together.
class SignatureSpace {
 public:
  static constexpr double kFar = 10.0;

  SignatureSpace(const Replay& replay, std::vector<std::size_t> samples, int frames, std::uint64_t seed,
                 double most_errors = kFar);

  [[nodiscard]] std::size_t size() const noexcept { return measured_.size(); }
  /// Measured less baseline, the reference settled within its tolerance.
  [[nodiscard]] const Signature& ofMeasurement() const noexcept { return measured_; }
  /// World less baseline, under the same random numbers.
  [[nodiscard]] Signature of(const World& world) const;

 private:
  [[nodiscard]] Signature shifts(std::size_t part, const std::vector<CellStatistics>& of, int frames,
                                 const std::vector<CellStatistics>& from) const;

  const Replay& replay_;
  int frames_;
  std::uint64_t seed_;
  double most_errors_;
  std::vector<std::size_t> samples_;
  std::vector<std::vector<CellStatistics>> baseline_;  ///< of each sample
  std::vector<std::vector<std::size_t>> cells_;        ///< taken of each sample, surfaces in order of power
  Signature measured_;
};

}  // namespace gap
