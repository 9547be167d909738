#pragma once

#include "metrics/objects/object_list.h"

namespace metrics {

/// A measured and a simulated object that are taken for the same; indices from 0.
struct ObjectPair {
  std::size_t measured;
  std::size_t simulated;
  bool operator==(const ObjectPair&) const = default;
};

/// A distance of two sets and its parts: distance^p = localisation^p + c^p / 2 (missed + false_objects).
struct Gospa {
  double distance;
  double localisation;  ///< (sum over pairs d^p)^(1/p)
  std::size_t missed;   ///< measured objects without simulated one
  std::size_t false_objects;
  std::vector<ObjectPair> pairs;  ///< nearer than c, in the order of measured objects
};

/// Generalised OSPA with alpha = 2: localisation errors, missed and false objects each have a price. [m]
///
///   GOSPA = ( min over pairings sum_pairs d(x, y)^p + c^p / 2 (missed + false) )^(1/p)
///
/// A pair as far apart as c or farther is a missed and a false object instead. A metric on finite sets; not divided by
/// the number of objects, so it grows with it. The optimal pairing is also the association of the two lists.
/// Throws InputError if a number is invalid.
/// Source: Rahmathullah, Garcia-Fernandez & Svensson 2017, doi:10.23919/ICIF.2017.8009645.
[[nodiscard]] Gospa gospa(const ObjectLists& lists, const SetOptions& options = {});

}  // namespace metrics
