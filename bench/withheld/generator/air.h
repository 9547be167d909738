#pragma once

#include <optional>
#include <vector>

#include "bench/withheld/generator/arrival.h"
#include "bench/withheld/generator/dice.h"
#include "bench/withheld/generator/effects.h"
#include "bench/withheld/generator/profile.h"
#include "bench/withheld/generator/scene.h"

namespace withheld {

/// What the experiment's environment says; absent: nobody recorded it.
struct Environment {
  std::optional<double> temperature_degC, visibility_m, rain_rate_mm_h, irradiance_w_m2_nm;
};

/// Kim's law: 3.912/V (λ/550 nm)^-q, q by steps of V, none below 500 m. Kim, McArthur & Korevaar 2001,
/// doi:10.1117/12.417512. [1/m]
[[nodiscard]] double fogExtinction(double visibility_m, double wavelength_nm);

/// Drops of Marshall & Palmer 1948 (N0 = 8000 /m³/mm, Λ = 4.1 R^-0.21 /mm), each taking twice its cross-section out of
/// the beam (van de Hulst 1957, sec. 8.22): π N0/Λ³ = 1.58 dB/km R^0.63. [1/m]
[[nodiscard]] double rainExtinction(double rate_mm_h);

/// The air between sensor and target: what it takes away, and what it sends back.
///
/// Unlike the usual: fog's soft target is summed in steps of range with a lidar ratio of 20 sr (near the 18.8 sr of
/// water clouds, O'Connor et al. 2004); the exhaust cloud is densest in its middle (parabola, same optical depth along
/// a diameter) and scatters forward with Henyey & Greenstein 1941, g = 0.6; spray clusters and drops are single
/// spheres, drawn anew each frame.
class Air {
 public:
  Air(const Effects& effects, const Profile& profile, const Environment& environment);

  /// Share of the power that is left after the way out to `range_m` and back along the ray.
  [[nodiscard]] double left(const Ray& ray, double range_m) const;
  /// Impulses of fog and cloud on the way to `end_m`; `constant` is P·A·η of the beam. [W m²]
  [[nodiscard]] std::vector<Arrival> sentBack(const Ray& ray, double end_m, double constant) const;

 private:
  [[nodiscard]] double cloudDepth(const Ray& ray, double to_m) const;

  double extinction_1_m_ = 0.0;
  double fog_extinction_1_m_ = 0.0, fog_backscatter_1_m_sr_ = 0.0;
  double nearest_m_;
  double cloud_extinction_1_m_ = 0.0, cloud_radius_m_ = 0.5, cloud_albedo_ = 0.9;
  Vec cloud_centre_{10, 0, 0};
};

/// A grain of water or snow in one beam of one frame, or a spray cluster: what it sends back, what it hides.
struct Grain {
  double range_m;
  double power_w;    ///< as Arrival
  double remaining;  ///< share of the power that gets past it, both ways
};

/// Single drops and flakes in the beam, sorted by range. Drops: Marshall & Palmer; flakes: Gunn & Marshall 1958
/// (N0 = 3800 R^-0.87, Λ = 2.55 R^-0.48, melted diameters).
[[nodiscard]] std::vector<Grain> dropsInBeam(const Effects& effects, const Profile& profile,
                                             const Environment& environment, double constant, double end_m, Dice& dice);

/// Spray clusters of one frame behind every vehicle that is fast enough.
struct Spray {
  std::vector<Vec> centres;
  double radius_m = 0.25, extinction_1_m = 0.0;
};
[[nodiscard]] Spray sprayOfFrame(const Effects& effects, const Scene& scene, Dice dice);
[[nodiscard]] std::vector<Grain> sprayInBeam(const Spray& spray, const Ray& ray, double constant, double end_m);

}  // namespace withheld
