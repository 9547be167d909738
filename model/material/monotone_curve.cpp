#include "model/material/monotone_curve.h"

#include <algorithm>
#include <cmath>

namespace model {

namespace {

/// Slope at a point between two pieces of lengths h0, h1 and slopes d0, d1: zero at an extremum, else the weighted
/// harmonic mean.
double innerSlope(double h0, double h1, double d0, double d1) {
  if (d0 * d1 <= 0.0) return 0.0;
  const double w0 = 2.0 * h1 + h0, w1 = h1 + 2.0 * h0;
  return (w0 + w1) / (w0 / d0 + w1 / d1);
}

/// Slope at an end from the parabola through three points, limited so that the piece stays monotone.
double endSlope(double h0, double h1, double d0, double d1) {
  const double slope = ((2.0 * h0 + h1) * d0 - h0 * d1) / (h0 + h1);
  if (slope * d0 <= 0.0) return 0.0;
  if (d0 * d1 <= 0.0 && std::abs(slope) > 3.0 * std::abs(d0)) return 3.0 * d0;
  return slope;
}

}  // namespace

MonotoneCurve::MonotoneCurve(std::vector<double> x, std::vector<double> y)
    : x_(std::move(x)), y_(std::move(y)), slope_(x_.size(), 0.0) {
  const std::size_t n = x_.size();
  if (n < 2) return;
  std::vector<double> step(n - 1), rise(n - 1);
  for (std::size_t i = 0; i + 1 < n; ++i) {
    step[i] = x_[i + 1] - x_[i];
    rise[i] = (y_[i + 1] - y_[i]) / step[i];
  }
  if (n == 2) {
    slope_[0] = slope_[1] = rise[0];
    return;
  }
  for (std::size_t i = 1; i + 1 < n; ++i) slope_[i] = innerSlope(step[i - 1], step[i], rise[i - 1], rise[i]);
  slope_[0] = endSlope(step[0], step[1], rise[0], rise[1]);
  slope_[n - 1] = endSlope(step[n - 2], step[n - 3], rise[n - 2], rise[n - 3]);
}

double MonotoneCurve::at(double x) const {
  if (x <= x_.front()) return y_.front();
  if (x >= x_.back()) return y_.back();
  const auto i = static_cast<std::size_t>(std::upper_bound(x_.begin(), x_.end(), x) - x_.begin()) - 1;
  const double h = x_[i + 1] - x_[i], t = (x - x_[i]) / h;
  const double u = 1.0 - t;
  return y_[i] * u * u * (1.0 + 2.0 * t) + y_[i + 1] * t * t * (3.0 - 2.0 * t) +
         h * t * u * (slope_[i] * u - slope_[i + 1] * t);
}

}  // namespace model
