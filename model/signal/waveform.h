#pragma once

#include <span>
#include <utility>
#include <vector>

#include "model/signal/pulse.h"
#include "model/signal/pulse_shape.h"

namespace model {

/// A stretch of the waveform above a level, on the range axis (c/2 · time).
struct Stretch {
  double rise_m = 0.0;
  double fall_m = 0.0;
  double peak_m = 0.0;
  double peak_w = 0.0;  ///< of the noise-free signal
};

/// What every pulse looks like on the range axis.
struct PulseForm {
  double fwhm_m = 0.0;  ///< full width at half maximum, c/2 · time
  PulseShape shape;     ///< Gaussian, or as it was measured
};

/// A part of the received waveform s = Σ P_i g(r − r_i) that stands alone: outside it the signal is below the lowest
/// level that anybody will ask for. g has unit peak.
///
/// The signal is sampled so finely that the parabola through three neighbouring samples of log s, which is exact for
/// one Gaussian, gives its crossings and peak to microns; those of sums to a millimetre where the level touches a
/// saddle, and better elsewhere.
class WaveformPart {
 public:
  WaveformPart(std::span<const Pulse> pulses, const PulseForm& form, double lowest_level_w);

  /// All stretches above `level_w`, in order of range; `level_w` must not be below the lowest level.
  void stretchesAbove(double level_w, std::vector<Stretch>& out) const;
  /// The pulse, if it is the only one.
  [[nodiscard]] const Pulse* lone() const noexcept { return lone_.power_w > 0.0 ? &lone_ : nullptr; }
  [[nodiscard]] double peak_w() const noexcept { return highest_w_; }
  [[nodiscard]] double lowest_level_w() const noexcept { return lowest_level_w_; }

 private:
  void addGaussians(std::span<const Pulse> pulses, double cut_m);
  void addMeasured(std::span<const Pulse> pulses);
  [[nodiscard]] std::size_t highestSample() const;
  [[nodiscard]] double logAt(std::size_t sample) const;
  [[nodiscard]] double crossing(std::size_t below, std::size_t above, double log_level) const;
  [[nodiscard]] Stretch stretchAt(std::size_t begin, std::size_t end, double level_w) const;

  Pulse lone_;  ///< the only pulse, if there is but one: it has a closed form and is not sampled
  PulseForm form_;
  double start_m_ = 0.0;
  double step_m_ = 0.0;
  double lowest_level_w_ = 0.0;
  double highest_w_ = 0.0;
  std::vector<double> signal_;  ///< [W]
  /// Samples [first, second) above the lowest level; a fog's long tail holds none, and every shot listens once more.
  std::vector<std::pair<std::size_t, std::size_t>> audible_;
};

/// Splits the pulses of one beam into parts that do not touch above `lowest_level_w`. Parts that stay below it are
/// left out. `pulses` are sorted by range and merged where they lie closer than a hundredth of the width.
[[nodiscard]] std::vector<WaveformPart> partsOf(std::vector<Pulse>& pulses, const PulseForm& form,
                                                double lowest_level_w);

}  // namespace model
