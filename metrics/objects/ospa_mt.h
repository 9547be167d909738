#pragma once

#include <cstddef>

#include "metrics/objects/object_list.h"
#include "metrics/objects/tracks.h"

namespace metrics {

/// Most assignments of whole tracks that ospaMt tries. Only tracks that come nearer than c are alternatives.
inline constexpr std::size_t kMostAssignmentsOfOspaMt = 2'000'000;

struct MultiTrackOptions {
  SetOptions set;
  double piece_m = 2.5;  ///< Delta in [0, c]: what each step of a further piece of a broken track costs; ours
};

struct MultiTrackOspa {
  double distance = 0.0;   ///< [m], in [0, c]
  std::size_t pieces = 0;  ///< tracks that are further pieces of one that has a track already
};

/// OSPA of whole tracks in which several tracks may be assigned to one: pieces of a broken track. [m]
///
///   measured   ------------------------      one track
///   simulated  ---------     ----------      two pieces: the longer is right, each step of the other costs Delta
///
///   D^p = sum_k ( sum over matched min(c, d)^p + Delta^p [further piece] + c^p (max(n_k, m_k) - matched_k) )
///         / sum_k max(n_k, m_k)
///
///   At step k, n_k simulated and m_k measured tracks exist; a measured track is matched by the nearest of the tracks
///   that are assigned to it for the whole time. Pieces that exist side by side count as one matched and others too
///   many. D is the least over all assignments, many simulated to one measured or the other way round, whichever is
///   less.
///
/// One step: OSPA. Exact: every assignment of tracks that come nearer than c is tried, or bounded.
/// This is our reading of the OSPA metric for multiple tracks, of which only the abstract was to be had: it extends
/// OSPA to sets of whole tracks, with false tracks, missed tracks and many tracks assigned to one. It need not give the
/// published numbers, and no axiom beyond symmetry and identity is claimed.
/// Throws InputError if a number is invalid, Delta is not in [0, c] or there are too many assignments.
/// Source: after Vu & Evans 2018, arXiv:1808.02242 (abstract).
[[nodiscard]] MultiTrackOspa ospaMt(const TrackSets& sets, const MultiTrackOptions& options = {});

}  // namespace metrics
