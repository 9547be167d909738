#pragma once

#include "gap/causes/evidence.h"

namespace gap {

/// Discrepancies that candidates are measured against.
struct Yardstick {
  static constexpr double kClear_z = 5.0;         ///< standard deviations of noise: a gap beyond doubt
  static constexpr std::size_t kSimulations = 4;  ///< of every world that is measured against them

  double baseline = 0.0;        ///< of the model as it was brought, held-out
  double perfect = 0.0;         ///< of a model that is right but for noise
  double perfect_spread = 0.0;  ///< of one simulation: programs differ, too, and more runs would make that a gap

  /// What there is to explain; no less than its noise, so that shares of next to nothing stay numbers.
  [[nodiscard]] double whole() const;

  /// Share of what there is to explain; `self` is the discrepancy that a world has to itself under other noise: one
  /// that loses detections at random cannot come closer than that.
  [[nodiscard]] double explained(double discrepancy, double self) const;
  /// Noise of that share.
  [[nodiscard]] double noiseOfShare() const;
  /// How far the baseline stands above noise, in standard deviations of noise.
  [[nodiscard]] double z() const;
  /// Of so large a distance by chance.
  [[nodiscard]] double p_value() const;
};

[[nodiscard]] Yardstick yardstickOf(const Replay& replay, const Evidence& held_out);

}  // namespace gap
