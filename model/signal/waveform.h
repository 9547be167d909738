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
  double peak_w = 0.0;   ///< of the noise-free signal
  double noise_w = 0.0;  ///< that has been added to it
  // Where every pulse is longer by a small share of its width, divided by that share:
  double rise_per_width_m = 0.0;  ///< how far the rise moves, and
  double fall_per_width_m = 0.0;  ///< the fall
  double peak_per_width = 0.0;    ///< how much of itself the peak gains
};

/// What every pulse looks like on the range axis.
struct PulseForm {
  double fwhm_m = 0.0;  ///< full width at half maximum, c/2 · time
  PulseShape shape;     ///< Gaussian, or as it was measured
};

/// Pulses that make a part of a waveform.
struct PartOfPulses {
  std::span<const Pulse> pulses;    ///< in order of range; some may lie beside the part and reach into it
  double from_m = 0.0, to_m = 0.0;  ///< outside it is silent
  double tail_m = 0.0;              ///< how far a pulse reaches
};

/// A part of the received waveform s = Σ P_i g(r − r_i) that stands alone: outside it the signal is below the lowest
/// level that anybody will ask for. g has unit peak.
///
/// The signal is sampled ten times per width: the cubic of log s through the four samples around a crossing and the
/// quartic through five around a peak are exact for one Gaussian, and good to a thousandth of the width for
/// sums, unless the level touches a saddle.
class WaveformPart {
 public:
  WaveformPart(const PartOfPulses& part, const PulseForm& form, double lowest_level_w);

  /// All stretches above `level_w`, in order of range; `level_w` must not be below the lowest level.
  void stretchesAbove(double level_w, std::vector<Stretch>& out) const;
  /// Whether surfaces sent any of it back, and whether they did so together with air, drops or another emitter.
  [[nodiscard]] bool ofSurface() const noexcept { return of_surface_; }
  [[nodiscard]] bool mixed() const noexcept { return !among_others_.empty(); }
  /// A mixed part in which what surfaces send back is `gain` times as strong. What rises above the lowest level only
  /// then stays silent.
  [[nodiscard]] WaveformPart withSurfacesAt(double gain) const;
  /// The pulse, if it is the only one.
  [[nodiscard]] const Pulse* lone() const noexcept { return lone_.power_w > 0.0 ? &lone_ : nullptr; }
  [[nodiscard]] double peak_w() const noexcept { return highest_w_; }
  [[nodiscard]] double lowest_level_w() const noexcept { return lowest_level_w_; }

 private:
  void add(std::span<const Pulse> pulses);
  void addGaussians(std::span<const Pulse> pulses, double cut_m);
  void addMeasured(std::span<const Pulse> pulses);
  void findHighest();
  [[nodiscard]] std::size_t highestSample() const;
  [[nodiscard]] double logAt(std::size_t sample) const;
  struct Crossing {
    double at_m = 0.0;
    double per_width_m = 0.0;
  };
  [[nodiscard]] Crossing crossing(std::size_t below, std::size_t above, double log_level) const;
  [[nodiscard]] double logPerWidth(double slope, double bend) const;
  struct Summit {
    std::size_t top = static_cast<std::size_t>(-1);  ///< the highest sample
    double steps = 0.0;                              ///< from it
    double log = 0.0;                                ///< of s [ln W]
    double power_w = 0.0;
    double power_per_width = 0.0;  ///< see Stretch
  };
  [[nodiscard]] Summit summitAt(std::size_t top) const;
  [[nodiscard]] const Summit& knownSummitAt(std::size_t top) const;
  [[nodiscard]] Stretch stretchAt(std::size_t begin, std::size_t end, double level_w) const;

  Pulse lone_;  ///< the only pulse, if there is but one: it has a closed form and is not sampled
  bool of_surface_ = false;
  std::vector<Pulse> among_others_;  ///< of surfaces; empty where there is nothing else, or nothing of them
  PulseForm form_;
  double tail_m_ = 0.0;
  double start_m_ = 0.0;
  double step_m_ = 0.0;
  double lowest_level_w_ = 0.0;
  double highest_w_ = 0.0;
  std::vector<double> signal_;  ///< [W]
  /// Samples [first, second) above the lowest level; a fog's long tail holds none, and every shot listens once more.
  std::vector<std::pair<std::size_t, std::size_t>> audible_;
  // Every shot asks for the same few logarithms and mostly for the same summit. One thread listens to a part.
  mutable std::vector<double> log_;  ///< of the samples, NaN where nobody has asked
  mutable Summit summit_;            ///< that was asked for last
};

/// Splits the pulses of one beam into parts that do not touch above `lowest_level_w`. Parts that stay below it are
/// left out. `pulses` are sorted by range and merged where they lie closer than a hundredth of the width.
[[nodiscard]] std::vector<WaveformPart> partsOf(std::vector<Pulse>& pulses, const PulseForm& form,
                                                double lowest_level_w);

}  // namespace model
