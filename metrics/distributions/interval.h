#pragma once

namespace metrics {

/// All that is known of a number: it lies between two ends, both included. Epistemic: no end is likelier than the
/// middle.
struct Interval {
  double low;
  double high;

  [[nodiscard]] double width() const noexcept { return high - low; }
  [[nodiscard]] bool contains(double x) const noexcept { return low <= x && x <= high; }

  bool operator==(const Interval&) const = default;
};

}  // namespace metrics
