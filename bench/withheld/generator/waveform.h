#pragma once

#include <functional>
#include <span>
#include <vector>

#include "bench/withheld/generator/arrival.h"

namespace withheld {

/// The emitted pulse, unit peak at time 0. Its flanks are halves of two Gaussians, so that both widths at half maximum
/// sum to `fwhm_ns` while the pulse may rise faster than it falls, as laser diodes do.
struct Pulse {
  double fwhm_ns;
  double rise_share = 0.5;  ///< of the full width: 0.5 is the Gaussian

  [[nodiscard]] double riseWidth_ns() const { return 2.0 * rise_share * fwhm_ns; }
  [[nodiscard]] double fallWidth_ns() const { return 2.0 * (1.0 - rise_share) * fwhm_ns; }
  /// From where the front passes 1/ratio of the peak to the peak. [ns]
  [[nodiscard]] double riseFrom(double ratio) const;
  /// Width at 1/ratio of the peak, 0 for a ratio below 1. [ns]
  [[nodiscard]] double widthAt(double ratio) const;
};

/// Received power over time, sampled every sixtieth of the pulse's width where there is any, cubic in between.
class Waveform {
 public:
  /// One run of samples without a hole.
  struct Piece {
    double start_ns;
    std::vector<double> power_w;
  };
  /// A stretch of time above the threshold.
  struct Stretch {
    double rise_ns, fall_ns, peak_ns, peak_w;
  };

  Waveform(std::vector<Arrival> arrivals, const Pulse& pulse, double tail_ns = 0.0);

  /// A receiver that saturates softly (level·(1 + (s/level)^4)^-¼) and then decays with the time constant given.
  void saturate(double level_w, double recovery_ns);

  /// Stretches in which the power plus the noise of its surroundings exceeds the threshold, in order of time.
  /// Surroundings are what lies above a tenth of the threshold; for each, `noise(threshold)` is asked once.
  [[nodiscard]] std::vector<Stretch> above(const std::function<double(double range_m)>& threshold_w,
                                           const std::function<double(double threshold_w)>& noise_w) const;

 private:
  [[nodiscard]] double crossing(const Piece& piece, std::size_t before, double level_w) const;
  [[nodiscard]] Stretch stretch(const Piece& piece, std::size_t first, std::size_t last, double level_w,
                                double noise_w) const;

  double step_ns_;
  std::vector<Piece> pieces_;
};

}  // namespace withheld
