#include "gap/replay/statistics.h"

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
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

double upperTail(double z, std::size_t runs) {
  const auto n = static_cast<double>(runs);
  return boost::math::cdf(boost::math::complement(boost::math::students_t(n - 1.0), z / std::sqrt(1.0 + 1.0 / n)));
}

double meanByChance(const std::vector<double>& values) {
  const Distribution all(values);
  const auto n = static_cast<double>(values.size());
  const double t = std::abs(all.mean) * std::sqrt(n) / std::max(1e-9, all.stddev);
  return 2.0 * boost::math::cdf(boost::math::complement(boost::math::students_t(n - 1.0), t));
}

Distribution::Distribution(const std::vector<double>& values) {
  for (const double value : values) mean += value / static_cast<double>(values.size());
  double squares = 0.0;
  for (const double value : values) squares += (value - mean) * (value - mean);
  stddev = std::sqrt(squares / static_cast<double>(values.size() - 1));
}

double Distribution::z(double value) const { return (value - mean) / std::max(1e-9, stddev); }

}  // namespace gap
