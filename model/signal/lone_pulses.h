#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "model/effects/effect.h"
#include "model/signal/shot_noise.h"

namespace model {

/// Beams whose received signal is one pulse: most of them. Their echoes have a closed form (formats.md section 3), so
/// many are worked out at once, column by column; the same numbers come out as from a waveform.
///
///   half width  h = FWHM/2 · sqrt(log2(P/level)),  level = (P_th - n) / gain (P_th - n as saturation_knee.h has it)
///   range       r, or r - h at the leading edge;   EPW = 4 h on the one-way axis
class LonePulses {
 public:
  void clear() {
    beam_.clear();
    pulse_range_m_.clear();
    power_w_.clear();
    noise_w_.clear();
  }
  /// `noise_w`: standard deviation of this beam's receiver.
  void add(std::uint32_t beam, const Pulse& pulse, double noise_w) {
    beam_.push_back(beam);
    noise_w_.push_back(noise_w);
    pulse_range_m_.push_back(pulse.range_m);
    power_w_.push_back(pulse.power_w);
  }
  [[nodiscard]] std::size_t size() const noexcept { return beam_.size(); }
  [[nodiscard]] std::uint32_t beam(std::size_t i) const { return beam_[i]; }

  /// Fires all of them in one frame. `gain(i)` is the fluctuation of a shot. The echoes are raw: neither time base nor
  /// range noise are in them.
  void fire(const ChainSettings& settings, const core::Random::Key& frame, const std::vector<double>& gain);
  /// Whether the last shot of beam i was above the threshold, and its echo.
  [[nodiscard]] bool detected(std::size_t i) const { return ratio_[i] > 1.0; }
  [[nodiscard]] Echo echo(std::size_t i) const {
    return {range_m_[i], epw_m_[i], peak_w_[i], Fate::kDetected, power_noise_w_[i]};
  }
  /// One that is no longer detected is forgotten.
  void setEcho(std::size_t i, const Echo& echo) {
    range_m_[i] = echo.range_m;
    epw_m_[i] = echo.epw_m;
    peak_w_[i] = echo.peak_w;
    if (echo.fate != Fate::kDetected) ratio_[i] = 0.0;
  }
  /// Time base, offset and the noise of the measured quantities.
  void blur(const ChainSettings& settings);
  /// Counts all echoes, and rounds them as the sensor's outputs are.
  void count(const ChainSettings& settings);
  [[nodiscard]] ShotNoise noise(std::size_t i) const { return {noise_[0][i], noise_[1][i], noise_[2][i]}; }

 private:
  /// To multiples of these steps [m, m, nW]; 0: as they are. Intensities are nW meanwhile.
  void roundTo(double range_m, double epw_m, double intensity_nw);

  std::vector<std::uint32_t> beam_;
  std::vector<double> pulse_range_m_, power_w_, noise_w_;
  std::vector<double> power_noise_w_, level_w_, ratio_, log_, range_m_, epw_m_, peak_w_;
  std::vector<float> noise_[4];
};

/// The same for one echo, to the last bit.
void blur(Echo& echo, const ChainSettings& settings, const ShotNoise& noise);

/// One of them, to the last bit as `LonePulses` does it: its raw echo, nothing if it stays below the threshold.
[[nodiscard]] std::optional<Echo> loneEcho(const Pulse& pulse, const Receiver& receiver, const ChainSettings& settings,
                                           double gain, const ShotNoise& noise);

/// To the nearest step, halves upwards; a step of 0 leaves the value as it is.
[[nodiscard]] double toStep(double value, double step);

inline constexpr double kWattToNanowatt = 1e9;
/// The noise lowers the level by at most this share of the threshold (formats.md section 3, step 4).
inline constexpr double kLargestNoise = 0.9;

}  // namespace model
