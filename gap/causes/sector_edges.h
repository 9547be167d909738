#pragma once

#include <cstddef>
#include <vector>

#include "gap/causes/scale.h"

namespace gap {

/// Sectors that are given by their middle and their width, as a search had better see them: by their two edges. One
/// that is where it should be stays there while the other moves; a middle and a width would have to move together.
class SectorEdges {
 public:
  /// Every `azimuth_deg` with the next `width_deg` is a sector.
  explicit SectorEdges(const std::vector<FreeParameter>& parameters);

  /// A place in the unit cube, with the edges of every sector in place of its middle and its width: as shares of the
  /// range of the middle, which a wide sector reaches beyond.
  [[nodiscard]] std::vector<double> edgesOf(std::vector<double> unit) const;
  /// And back; whichever edge comes first.
  [[nodiscard]] std::vector<double> unitOf(std::vector<double> edges) const;
  /// Whether this number of a place is an edge.
  [[nodiscard]] bool isEdge(std::size_t number) const;

 private:
  struct Sector {
    std::size_t middle, width;  ///< numbers among the parameters
    double range_deg;           ///< of the middle
    Scale scale;                ///< of the width
  };
  std::vector<Sector> sectors_;
};

}  // namespace gap
