#include "gap/causes/sector_edges.h"

#include <algorithm>
#include <cmath>

namespace gap {

SectorEdges::SectorEdges(const std::vector<FreeParameter>& parameters) {
  for (std::size_t m = 0; m < parameters.size(); ++m) {
    if (parameters[m].name != "azimuth_deg") continue;
    const auto width = std::find_if(parameters.begin() + static_cast<std::ptrdiff_t>(m), parameters.end(),
                                    [](const FreeParameter& p) { return p.name == "width_deg"; });
    if (width == parameters.end()) continue;
    sectors_.push_back({m, static_cast<std::size_t>(width - parameters.begin()), parameters[m].high - parameters[m].low,
                        Scale(*width)});
  }
}

std::vector<double> SectorEdges::edgesOf(std::vector<double> unit) const {
  for (const Sector& sector : sectors_) {
    const double middle = unit[sector.middle];
    const double half = 0.5 * sector.scale.toValue(unit[sector.width]) / sector.range_deg;
    unit[sector.middle] = middle - half;
    unit[sector.width] = middle + half;
  }
  return unit;
}

std::vector<double> SectorEdges::unitOf(std::vector<double> edges) const {
  for (const Sector& sector : sectors_) {
    const double from = edges[sector.middle], to = edges[sector.width];
    edges[sector.middle] = std::clamp(0.5 * (from + to), 0.0, 1.0);
    edges[sector.width] = sector.scale.toUnit(std::abs(to - from) * sector.range_deg);
  }
  return edges;
}

bool SectorEdges::isEdge(std::size_t number) const {
  return std::any_of(sectors_.begin(), sectors_.end(),
                     [&](const Sector& sector) { return number == sector.middle || number == sector.width; });
}

}  // namespace gap
