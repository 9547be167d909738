#pragma once

#include <vector>

#include "model/effects/effect.h"

namespace model::effects {

/// Extinction over backscatter of water droplets. [sr] Source: O'Connor, Illingworth, Hogan 2004,
/// J. Atmos. Oceanic Technol. 21, 777 (18.8 ± 0.8 sr at 905 nm, any cloud of liquid drops).
inline constexpr double kLidarRatioOfDroplets_sr = 18.8;

/// Air that scatters a little everywhere between two ranges, sensor frame, one way.
struct SoftTarget {
  double from_m = 0.0;
  double to_m = 0.0;
  double backscatter_1_m_sr = 0.0;
  double extinction_1_m = 0.0;
  double extinction_from_m = 0.0;  ///< where the extinction begins; at most `from_m`
};

/// Adds what a soft target sends back:
///
///   P(r) dr = η A_r P_t · β χ(r) · exp(-2 α (r - r_α)) · open(r) / r² · dr
///
/// as a comb of pulses spaced half a pulse width at most: Gaussians at that spacing sum to a smooth curve to
/// 2 exp(-π² / ln 2) ≈ 1e-6. Each stands for a cell of air, with the integral and the mean place of its 1/r²; near the
/// sensor cells are 0.15 of their range long at most, where that is an eighth of a pulse, and a stretch has eight cells
/// at least. What is lost is the spread within a cell of length s, s²/24 of the signal's curvature: 0.006 of the
/// signal. open(r) is the share of the beam that has met no surface yet. The comb ends at `to_m`, or where a level of a
/// thousandth of the threshold is not reached any more. Nothing is heard from before the nearest range of the detection
/// window: there the receiver is not listening yet; nor from before 0.1 m. Source: lidar equation of a distributed
/// target, Rasshofer et al. 2011, doi:10.5194/ars-9-49-2011, sec. 2.
void addSoftTarget(const BeamView& view, SoftTarget target, std::vector<Pulse>& pulses);

/// Share of the beam's power that has met no surface before `range_m`. A pane counts as a surface.
[[nodiscard]] double openShare(const BeamView& view, double range_m);

/// Width of a pulse on the range axis, c/2 · FWHM. [m]
[[nodiscard]] double pulseLength_m(const Emitter& emitter);

/// Where a ray passes a sphere: ranges of entry and exit, not before 0; equal if it misses.
struct Passage {
  double enter_m = 0.0;
  double leave_m = 0.0;
  [[nodiscard]] double length_m() const { return leave_m - enter_m; }
  /// How much of it lies before a range.
  [[nodiscard]] double lengthBefore_m(double range_m) const;
};
[[nodiscard]] Passage passageThroughSphere(const Vector3& origin, const Vector3& direction, const Vector3& centre,
                                           double radius_m);

}  // namespace model::effects
