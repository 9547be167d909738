#pragma once

#include <vector>

#include "metrics/objects/object_list.h"
#include "metrics/objects/ospa.h"
#include "metrics/objects/tracks.h"

namespace metrics {

/// Labels: the measured track that each simulated one is taken for over the whole time; absent: for none.
///
/// One assignment with the least sum over time steps of min(c, |x - y|) where both tracks exist and c where one does.
/// Source: Ristic, Vo, Clark & Farina 2011, doi:10.1109/TSP.2011.2140111.
[[nodiscard]] std::vector<std::optional<std::size_t>> labelsOf(const TrackSets& sets, double cutoff_m);

/// What OSPA-T takes beyond OSPA.
struct LabelledOptions {
  SetOptions set;
  double label_m = 2.5;  ///< alpha in [0, c]: what a wrong label costs; 0: none, c: as much as a missing object
};

/// OSPA-T: OSPA at every time step with a base distance that also sees labels.
///
///   d(x, y) = ( |x - y|^p + (alpha if the labels differ)^p )^(1/p)
///
/// A simulated track that was taken for no measured one has a label of its own. A switch of tracks costs alpha for as
/// long as it lasts. The order of the label's part is the p of the set.
/// The labels come from the pair of sets under comparison, so the triangle inequality holds for given labels only.
struct TrackOspa {
  std::vector<double> per_step;  ///< [m], one a time step
  double mean = 0.0;             ///< over all time steps; the summary over time is ours
};

/// Throws InputError if a number is invalid or alpha is not in [0, c].
/// Source: Ristic, Vo, Clark & Farina 2011, doi:10.1109/TSP.2011.2140111.
[[nodiscard]] TrackOspa ospaT(const TrackSets& sets, const LabelledOptions& options = {});

/// OSPA(2): OSPA of tracks, whose base distance is the mean over the steps at which either of two tracks exists of
/// min(c, |x - y|), or c where one of them is missing. [m]
///
/// A metric on sets of tracks, at most c; a broken track pays for each piece that lacks its other pieces.
/// Throws InputError if a number is invalid.
/// Source: Beard, Vo & Vo 2020, doi:10.1109/TSP.2020.2986136.
[[nodiscard]] Ospa ospaOfTracks(const TrackSets& sets, const SetOptions& options = {});

}  // namespace metrics
