#pragma once

#include "metrics/objects/object_list.h"
#include "metrics/objects/tracks.h"

namespace metrics {

/// Most shares W (pairs of tracks that are ever nearer than c, times steps) of one group that trajectoryDistance takes:
/// 40 x 40 tracks in one crowd over 125 steps. Its work grows about with the square of this.
inline constexpr std::size_t kMostSharesOfTrackMetric = 200'000;

struct TrajectoryOptions {
  SetOptions set;
  double switch_m = 1.0;  ///< gamma >= 0: what a switch of tracks costs; the default is ours
};

/// A distance of two sets of tracks and its parts:
///
///   distance^p = localisation^p + c^p / 2 (missed + false_objects) + gamma^p switches
struct TrajectoryDistance {
  double distance = 0.0;
  double localisation = 0.0;   ///< (sum over time and pairs d^p)^(1/p) [m]
  double missed = 0.0;         ///< time steps of measured tracks without simulated one
  double false_objects = 0.0;  ///< time steps of simulated tracks without measured one
  double switches = 0.0;       ///< from one track to another: 1; from or to none: 1/2
};

/// Rahmathullah's track metric in its linear programming form (later called trajectory GOSPA). [m]
///
///   min over W of ( sum_k sum_ij D_ij(k) W_ij(k) + gamma^p / 2 sum_k sum_ij |W_ij(k+1) - W_ij(k)| )^(1/p)
///
///   D_ij(k)  min(c, d)^p where both tracks exist, c^p / 2 where one does; i or j may be `none`
///   W_ij(k)  share of track i that belongs to j at step k: each track sums to 1, 0 <= W
///
/// GOSPA at every step, and a price for changing one's mind. With whole W it is a multi-dimensional assignment, which
/// is NP-hard; the relaxation never exceeds it, mostly equals it, and is itself a metric on sets of tracks. Parts may
/// therefore be fractions, and are one choice among equals where several W are optimal. Grows with objects and steps.
///
/// Tracks never nearer than c fall apart into groups, which are solved one by one (simplex method of COIN-OR CLP).
/// Throws InputError if a number is invalid or a group is larger than the limit.
/// Source: Rahmathullah, Garcia-Fernandez & Svensson 2016, arXiv:1605.01177; Garcia-Fernandez, Rahmathullah & Svensson
/// 2020, doi:10.1109/TSP.2020.3005309.
[[nodiscard]] TrajectoryDistance trajectoryDistance(const TrackSets& sets, const TrajectoryOptions& options = {});

}  // namespace metrics
