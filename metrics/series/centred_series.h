#pragma once

#include <cmath>
#include <span>
#include <vector>

#include "metrics/distributions/summation.h"

namespace metrics {

/// A series less its mean, and the sum of its squares.
struct CentredSeries {
  explicit CentredSeries(std::span<const double> series) : values(series.begin(), series.end()) {
    Summation sum;
    for (const double value : values) sum.add(value);
    const double mean = sum.value() / static_cast<double>(values.size());
    Summation squares;
    for (double& value : values) {
      value -= mean;
      squares.add(value * value);
    }
    square_sum = squares.value();
  }

  [[nodiscard]] double norm() const noexcept { return std::sqrt(square_sum); }

  std::vector<double> values;
  double square_sum = 0.0;
};

}  // namespace metrics
