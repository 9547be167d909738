#pragma once

#include <string>
#include <vector>

namespace report {

/// Range of values that an axis shows, in the axis' unit. low < high.
struct Range {
  double low = 0.0;
  double high = 1.0;
};

/// Where an axis has its marks, and what is written there.
struct Ticks {
  std::vector<double> at;           ///< ascending, all within the range
  std::vector<std::string> labels;  ///< one each, all with the same number of decimals
};

/// Marks at multiples of 1, 2 or 5 times a power of ten, about `count` of them.
///
///   [9.93, 10.11], 5  ->  9.95  10.00  10.05  10.10
///
/// A range that is empty, reversed or not finite gives no marks.
[[nodiscard]] Ticks niceTicks(Range range, int count);

/// The range widened by `fraction` of its length on both sides; a single value gets a neighbourhood that ticks can
/// resolve.
[[nodiscard]] Range widened(Range range, double fraction);

/// Straight map from values to pixels; `high` may lie left of or above `low` on the screen.
class Scale {
 public:
  Scale(Range values, double pixel_low, double pixel_high)
      : values_(values), pixel_low_(pixel_low), pixel_high_(pixel_high) {}

  [[nodiscard]] double pixel(double value) const;
  [[nodiscard]] double value(double pixel) const;
  /// As pixel(), but values outside the range end at its border (how this house clips: SVG Tiny has no clip paths).
  [[nodiscard]] double pixelWithin(double value) const;
  [[nodiscard]] const Range& values() const noexcept { return values_; }

 private:
  Range values_;
  double pixel_low_;
  double pixel_high_;
};

}  // namespace report
