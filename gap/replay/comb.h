#pragma once

#include <optional>
#include <vector>

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

/// Mean square of what the move of a target makes of the mean of its counted values, wherever within a step q it
/// stands: without noise a move of δ takes it to the next step, q farther, with probability |δ|/q. Under normal noise σ
/// it is q times the integral over x of (Φ((x + δ)/σ) - Φ(x/σ))², which is an energy distance (Székely & Rizzo 2013, J.
/// Stat. Plan. Inference 143, 1249, section 2), and of a normal move of standard deviation `moved`
///
///   q sqrt(2/π) (sqrt(moved² + 2 σ²) - sqrt(2) σ),
///
/// as long as the noise is a fraction of a step. All in the unit of the values.
[[nodiscard]] double jumpVariance(double step, double moved, double noise);

}  // namespace gap
