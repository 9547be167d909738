#include "gap/statistics.h"

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <cmath>

namespace gap {

double medianOf(std::vector<double>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

double upperTail(double z) {
  constexpr double kFarthest = 37.0;
  return boost::math::cdf(boost::math::complement(boost::math::normal(), std::clamp(z, -kFarthest, kFarthest)));
}

Distribution::Distribution(const std::vector<double>& values) {
  for (const double value : values) mean += value / static_cast<double>(values.size());
  double squares = 0.0;
  for (const double value : values) squares += (value - mean) * (value - mean);
  stddev = std::sqrt(squares / static_cast<double>(values.size() - 1));
}

double Distribution::z(double value) const { return (value - mean) / std::max(1e-9, stddev); }

}  // namespace gap
