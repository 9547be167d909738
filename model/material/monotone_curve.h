#pragma once

#include <vector>

namespace model {

/// Smooth curve through points that never overshoots them: between two neighbours it is monotone, so a table that
/// falls gives a curve that falls. Cubic Hermite pieces with limited slopes; straight lines are reproduced exactly.
/// Source: Fritsch & Butland 1984, doi:10.1137/0905021 (slopes, with the weights for uneven steps).
class MonotoneCurve {
 public:
  /// `x` strictly ascending, as long as `y`, at least one point.
  MonotoneCurve(std::vector<double> x, std::vector<double> y);

  [[nodiscard]] double first() const noexcept { return x_.front(); }
  [[nodiscard]] double last() const noexcept { return x_.back(); }
  /// Beyond the ends the value there.
  [[nodiscard]] double at(double x) const;

 private:
  std::vector<double> x_;
  std::vector<double> y_;
  std::vector<double> slope_;
};

}  // namespace model
