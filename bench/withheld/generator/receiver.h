#pragma once

#include "bench/withheld/generator/air.h"
#include "bench/withheld/generator/effects.h"
#include "bench/withheld/generator/profile.h"

namespace withheld {

/// Window, optics, detector and comparator: how much of the light counts, how noisy it is, from where on it is an echo.
///
/// - cover: the dirty sector has soft edges (0.25°), because the aperture looks past its border;
/// - uneven gain: log-normal over the layers;
/// - aperture offset: two overlapping circles, beam and field of view (Stelmaszczyk et al. 2005,
/// doi:10.1364/AO.44.001323);
/// - thermal noise: dark current of a silicon junction, T^1.5 exp(-Eg/2kT) (Sze & Ng 2007, ch. 2), whose root is the
/// noise;
/// - background: shot noise of the light that the surface in view sends through a filter of 12 nm, excess noise factor
/// 3
///   (Gagliardi & Karp 1995, ch. 4); near the sun its aureole adds;
/// - blinding: the gain falls with the foreign light, and its shot noise adds;
/// - with x-noise-echoes, noise that was raised crosses the threshold at Rice's rate B/√3 exp(-thr²/2σ²) (Rice 1945,
///   sec. 3.6); without it, as in the reference signal chain, noise alone is never an echo.
class Receiver {
 public:
  Receiver(const Profile& profile, const Effects& effects, const Environment& environment, std::uint64_t seed);

  /// Factor on all received power of a beam.
  [[nodiscard]] double gain(const Beam& beam) const;
  /// Overlap of beam and field of view at a range, 1 without the effect.
  [[nodiscard]] double overlap(double range_m) const;
  /// Standard deviation of the noise; `reflectivity` of what the beam's axis meets. [W]
  [[nodiscard]] double noise_w(const Beam& beam, double reflectivity) const;
  [[nodiscard]] double threshold_w(double range_m, double noise_w) const;
  /// Mean number of echoes a shot that noise beyond the profile's brings.
  [[nodiscard]] double noiseEchoes(double noise_w) const;

 private:
  [[nodiscard]] double shotVariance(double light_w) const;
  [[nodiscard]] double backgroundLight_w(const Beam& beam, double reflectivity) const;
  /// 0 … 1: how far the beam lies in the sector of the foreign light.
  [[nodiscard]] double blinded(const Beam& beam) const;

  const Profile& profile_;
  const Effects& effects_;
  const Environment& environment_;
  std::vector<double> layer_gain_;
};

/// Generation current of silicon over that at 20 °C.
[[nodiscard]] double darkCurrentRatio(double temperature_degC);

/// Share of a circle of radius `a` that a circle of radius `b` covers, `d` between the centres.
[[nodiscard]] double circleOverlap(double a, double b, double d);

}  // namespace withheld
