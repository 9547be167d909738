#pragma once

#include <optional>
#include <string>
#include <vector>

#include "gap/replay/replay.h"

namespace gap {

/// Steps of a counter: all values are multiples of one number.
struct Comb {
  double step;       ///< [unit of the values]
  double uncertain;  ///< of the step: how far all values stay within their rounding; where noise is in them, an eighth
                     ///< of a turn of the farthest value's phase [unit of the values]
  double by_chance;  ///< that scattered values lie as well on any of the combs that were looked at

  /// Whether the values alone show it; else it is no more than where a search may begin.
  [[nodiscard]] bool shown() const { return by_chance < 1e-3; }
};

/// The comb on which the values lie, but for rounding of so much to either side: sought about the smallest distance of
/// two, where their periodogram is highest (Schuster 1898, Terr. Magn. 3, 13: n scattered values reach a mean cosine a
/// by chance with exp(-n a²)) and neighbours lie one step apart. Nothing if they lie on none that is clearly coarser
/// than the rounding, are very few, or reach too many steps far for it to be told. `values` need not be in order.
[[nodiscard]] std::optional<Comb> combOf(std::vector<double> values, double rounding);

/// Whether values are multiples of a step, but for the rounding of a file that holds few digits; so is anything of a
/// step of 0, and so are no values at all.
[[nodiscard]] bool lieOnSteps(const std::vector<double>& values, double step);

/// The comb of all ranges that these sensors measured (none named: all), if it is coarser than the steps of their own
/// profiles. [m]
[[nodiscard]] std::optional<Comb> rangeComb(const Replay& replay, const std::vector<std::string>& sensors = {});

}  // namespace gap
