#pragma once

#include <QColor>
#include <QString>
#include <span>
#include <vector>

#include "app/desktop/cloud/point_cloud.h"

namespace desktop {

/// Dark to bright, evenly: blue, teal, green, yellow. Brightness rises all the way, so that the order can be read with
/// any colour vision and in print; the dark end still stands out from the canvas. `share` is cut to [0, 1].
[[nodiscard]] QColor rampColour(double share);

/// Blue for -1, pale grey for 0, orange for +1: the sign can be told with any colour vision.
[[nodiscard]] QColor differenceColour(double share);

/// Which colour a number gets.
struct ColourScale {
  ColourBy by = ColourBy::Source;
  double low = 0.0;
  double high = 1.0;
  bool logarithmic = false;  ///< intensities span decades
  bool known = false;        ///< there are values at all

  [[nodiscard]] double shareOf(double value) const noexcept;
  /// Of a share of the bar, 0 at its lower end.
  [[nodiscard]] QColor at(double share) const;
  [[nodiscard]] QRgb operator()(double value) const;  ///< a dark grey for what is not a number
  /// Round values inside [low, high] for the legend; whole numbers for layers and echoes.
  [[nodiscard]] std::vector<double> ticks() const;
};

/// From the smallest to the largest of all values; one scale for both sources, so that the same colour means the same.
/// Differences get a scale that is symmetric about zero and holds 98 of 100 of them: a few wild ones do not flatten the
/// rest. What is not a number does not count.
[[nodiscard]] ColourScale scaleFor(ColourBy by, std::span<const std::vector<double>> values);

[[nodiscard]] QString titleOf(ColourBy by);  ///< "Range [m]", for legends
[[nodiscard]] QString wordFor(ColourBy by);  ///< "Range", for menus

/// 1, 2 or 5 times a power of ten, at least `value`.
[[nodiscard]] double roundStep(double value);

}  // namespace desktop
