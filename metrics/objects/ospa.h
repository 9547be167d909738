#pragma once

#include "metrics/objects/object_list.h"

namespace metrics {

/// A distance of two sets and its parts: distance^p = localisation^p + cardinality^p.
struct Ospa {
  double distance = 0.0;      ///< in [0, c]
  double localisation = 0.0;  ///< of the pairs
  double cardinality = 0.0;   ///< of the objects that one list has too many
};

/// Optimal sub-pattern assignment: how far apart two sets are, per object of the larger one. [m]
///
///   OSPA = ( 1/n ( min over pairings sum_i min(c, d(x_i, y_i))^p + c^p (n - m) ) )^(1/p),   m <= n objects
///
///   c   what an object too many costs, and the most that a pair can cost
///   p   the larger, the more outliers count
///
/// A metric on finite sets, at most c. It cannot tell missed from false objects (GOSPA can), and the more objects there
/// are, the less one of them counts. Two empty sets: 0. One empty set: c, whatever the other.
/// Throws InputError if a number is invalid.
/// Source: Schuhmacher, Vo & Vo 2008, doi:10.1109/TSP.2008.920469.
[[nodiscard]] Ospa ospa(const ObjectLists& lists, const SetOptions& options = {});

/// The same with any base distance; a metric if that is one.
[[nodiscard]] Ospa ospa(const CostTable& distances, const SetOptions& options);

}  // namespace metrics
