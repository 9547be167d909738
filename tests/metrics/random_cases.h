#pragma once

#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <cstdint>
#include <vector>

#include "core/random.h"
#include "metrics/distributions/edf.h"
#include "metrics/distributions/p_box.h"

namespace metrics_test {

/// Random samples and boxes of all kinds that a metric may meet: few and many values, ties, crossing runs. A seed makes
/// the same cases on every machine.
class RandomCases {
 public:
  explicit RandomCases(std::uint64_t seed) : random_({.seed = seed, .purpose = core::purposeOf("metrics_test")}) {}

  double uniform(double low, double high) { return low + (high - low) * random_.uniform(); }

  std::vector<double> sample(std::uint32_t largest_n = 30) {
    const double centre = uniform(-3.0, 3.0);
    const double spread = uniform(0.0, 2.0);
    const bool counter = random_.below(2) == 0;  // quantised to 0.25: many ties
    std::vector<double> values(1 + random_.below(largest_n));
    for (double& x : values) {
      x = centre + spread * random_.normal();
      if (counter) x = 0.25 * std::round(4.0 * x);
    }
    return values;
  }

  metrics::Edf edf(std::uint32_t largest_n = 30) { return metrics::Edf(sample(largest_n)); }

  std::vector<metrics::Edf> runs(std::uint32_t largest_count = 5, std::uint32_t largest_n = 30) {
    std::vector<metrics::Edf> all;
    for (std::uint32_t left = 1 + random_.below(largest_count); left > 0; --left) all.push_back(edf(largest_n));
    return all;
  }

  metrics::PBox box(std::uint32_t largest_count = 5, std::uint32_t largest_n = 30) {
    return metrics::PBox::envelope(runs(largest_count, largest_n));
  }

 private:
  core::Random random_;
};

/// The sample of n quantiles at (i - 1/2)/n of a normal distribution: noise-free, so that closed forms apply.
inline std::vector<double> normalGrid(double mean, double deviation, int n) {
  const boost::math::normal normal(mean, deviation);
  std::vector<double> values;
  for (int i = 0; i < n; ++i) values.push_back(boost::math::quantile(normal, (i + 0.5) / n));
  return values;
}

inline metrics::PBox widened(const metrics::Edf& edf, double half_width) {
  return metrics::PBox::fromEdges(edf.shifted(-half_width), edf.shifted(half_width));
}

}  // namespace metrics_test
