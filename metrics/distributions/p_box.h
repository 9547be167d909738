#pragma once

#include <optional>
#include <span>

#include "metrics/distributions/edf.h"

namespace metrics {

/// Probability box: all distributions whose CDF runs between two step functions.
///
///   p 1 |      _______
///       |   __|   __|          left:  largest CDF, smallest values
///     0 |__|_____|             right: smallest CDF, largest values
///        ------------------ x  [unit of the measurand]
///
/// Scatter within a run is aleatory: it shapes each EDF. Differences between runs are epistemic: they open the box.
/// The width of an envelope includes the sampling noise of its runs: more runs of the same model widen it.
/// Immutable; safe to share. Source: Ferson et al. 2003, SAND2002-4015.
class PBox {
 public:
  /// A single distribution is a box of width 0. Implicit, so that a Comparison takes either.
  PBox(Edf edf);  // NOLINT(google-explicit-constructor)

  /// Tightest box around one EDF per run, of any sample sizes. Exact: no grid of values or percentiles. Throws
  /// InputError if `runs` is empty.
  static PBox envelope(std::span<const Edf> runs);

  /// Between two edges, as published. Throws InputError where the left edge lies right of the right one.
  static PBox fromEdges(Edf left, Edf right);

  /// All that is known is that the value lies in [low, high]. Throws InputError if they are exchanged or not finite.
  static PBox fromInterval(double low, double high);

  [[nodiscard]] const Edf& left() const noexcept { return left_; }
  [[nodiscard]] const Edf& right() const noexcept { return right_ ? *right_ : left_; }

  /// Made from one distribution: no epistemic uncertainty, both edges are the same object.
  [[nodiscard]] bool isSingleDistribution() const noexcept { return !right_; }

  /// Area between the edges: the mean width. 0 for a single distribution. [unit of x]
  [[nodiscard]] double area() const;
  /// Width at level p: right minus left quantile. [unit of x]
  [[nodiscard]] double widthAt(double p) const noexcept { return right().quantile(p) - left().quantile(p); }

  /// The box moved by `offset` along x. [unit of x]
  [[nodiscard]] PBox shifted(double offset) const;

 private:
  PBox(Edf left, std::optional<Edf> right);
  Edf left_;
  std::optional<Edf> right_;  // absent: the same as left_, not stored twice
};

}  // namespace metrics
