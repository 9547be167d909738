#pragma once

#include <limits>
#include <vector>

#include "core/progress.h"
#include "gap/causes/evidence.h"
#include "gap/causes/scale.h"
#include "gap/causes/sector_edges.h"

namespace gap {

/// Whether small steps of a number jump: the ends of sectors and counts do.
[[nodiscard]] bool jumps(const FreeParameter& number);
/// Whether small steps of its numbers change little.
[[nodiscard]] bool smooth(const Hypothesis& hypothesis);

/// What a search makes small: the discrepancy of a hypothesis on some evidence, over the unit cube of its free numbers.
/// Refers to all its arguments but the evidence.
class Objective {
 public:
  Objective(const Replay& replay, const Hypothesis& hypothesis, Evidence evidence, const core::Progress& progress);

  [[nodiscard]] std::vector<double> valuesAt(const std::vector<double>& unit) const { return cube_.valuesAt(unit); }
  [[nodiscard]] std::vector<double> unitOf(const std::vector<double>& values) const { return cube_.unitOf(values); }
  [[nodiscard]] double operator()(const std::vector<double>& unit) const;
  /// How sectors are searched.
  [[nodiscard]] const SectorEdges& edges() const { return edges_; }
  /// In the unit cube, of edges in place of middles and widths. Ends of a sector are searched within a few degrees of
  /// their start: beyond, nothing leads back.
  [[nodiscard]] std::vector<double> firstSteps(double step) const;
  /// Which of its numbers are whole.
  [[nodiscard]] std::vector<std::size_t> counts() const;
  /// Of which of its numbers small steps jump: counts, and the ends of sectors.
  [[nodiscard]] std::vector<std::size_t> thatJump() const;
  /// Which of its numbers send the rays other ways: then every look takes long.
  [[nodiscard]] std::vector<std::size_t> thatTraceAnew(const std::vector<double>& unit) const;
  [[nodiscard]] bool tracesAnew(const std::vector<double>& unit) const { return !thatTraceAnew(unit).empty(); }
  [[nodiscard]] std::size_t dimensions() const { return hypothesis_.parameters.size(); }

 private:
  const Replay& replay_;
  const Hypothesis& hypothesis_;
  Evidence evidence_;
  const core::Progress& progress_;
  UnitCube cube_;
  SectorEdges edges_;
};

/// A place in the unit cube.
struct Point {
  std::vector<double> unit;
  double discrepancy = std::numeric_limits<double>::infinity();
};

/// So many places spread evenly over the unit cube; deterministic (Halton; on a line the middles of equal parts).
[[nodiscard]] std::vector<std::vector<double>> evenPoints(std::size_t dimensions, unsigned count);

/// The best place of a search over the whole cube and at the starts given (in the hypothesis's units); on a line, dips
/// included that are narrower than the steps. Of several numbers that come equally near the first start is kept. There
/// is one dimension at least.
[[nodiscard]] Point coarseSearch(const Objective& objective, const std::vector<std::vector<double>>& starts);

/// How far a search goes from its start, in the unit cube, and how long.
struct Reach {
  double line;              ///< to both sides, where there is one number
  double step;              ///< the first, where there are several,
  int trials;               ///< and how many
  bool holds_rays = false;  ///< numbers that send the rays other ways stay where they are, if there are others
};

/// A line is searched to 2^-kLineBits of its length, 1e-4: coarser, and refits would end where they began.
inline constexpr int kLineBits = 13;

/// Where a bounded search around a place ends (Brent on a line, else Subplex of NLopt, which a rugged objective does
/// not lead astray; counts one by one beyond it), never worse than the start.
[[nodiscard]] Point searched(const Objective& objective, const std::vector<double>& start, const Reach& reach);

/// Where the narrow valley leads that several numbers of like effect make (how wet a surface is, and how flat the
/// film): a simplex follows it (Nelder & Mead 1965, Comput. J. 7, 308), again and again while it leads on; never worse
/// than the start, whose discrepancy is known. Numbers of which small steps jump, and those that take tracing anew,
/// stay where they are. `trials`: of each walk.
[[nodiscard]] Point walkedFrom(const Objective& objective, Point start, double first_step, int trials);

}  // namespace gap
