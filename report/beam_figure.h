#pragma once

#include <string>
#include <vector>

namespace report {

/// Where the beams of a sensor point, as the sensor sees it (azimuth grows to the left):
///
///   el |  ─────────────      the whole frame: a dot a beam, a line a layer if there are many; the weaker the beam,
///      |  ─────────────      the paler
///      |_______________
///   el |  ▯    ▯    ▯         a window of it, both axes to one scale: the beams with their true widths
///      |__▯____▯____▯__
///             azimuth
struct BeamFigure {
  struct Beam {
    double azimuth_deg;
    double elevation_deg;
    double gain = 1.0;  ///< share of the peak power, 0 … 1
  };
  std::string title;
  std::string note;                     ///< one line under the title
  std::vector<std::vector<Beam>> rows;  ///< one a layer, beams in order of azimuth
  double width_deg = 0.0;               ///< of one beam; 0: not known
  double height_deg = 0.0;
  bool elliptic = false;  ///< else rectangular
};

/// SVG Tiny 1.2 (see figure.h).
[[nodiscard]] std::string beamFigure(const BeamFigure& beams);

}  // namespace report
