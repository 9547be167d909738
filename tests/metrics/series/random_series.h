#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "core/random.h"
#include "metrics/series/series_pair.h"

namespace metrics_test {

/// Two series that a metric may meet: noise about a drift, sometimes with the steps of a counter (ties).
struct TwoSeries {
  std::vector<double> simulated;
  std::vector<double> measured;

  [[nodiscard]] metrics::SeriesPair pair() const { return {.simulated = simulated, .measured = measured}; }
  [[nodiscard]] metrics::SeriesPair exchanged() const { return {.simulated = measured, .measured = simulated}; }
};

class RandomSeries {
 public:
  explicit RandomSeries(std::uint64_t seed) : random_({.seed = seed, .purpose = core::purposeOf("series_test")}) {}

  std::size_t length(std::uint32_t smallest, std::uint32_t largest) {
    return smallest + random_.below(largest - smallest + 1);
  }
  double uniform(double low, double high) { return low + (high - low) * random_.uniform(); }

  std::vector<double> series(std::size_t n) {
    const double drift = uniform(-0.5, 0.5);
    const bool counter = random_.below(2) == 0;
    std::vector<double> values(n);
    for (std::size_t i = 0; i < n; ++i) {
      values[i] = drift * static_cast<double>(i) + random_.normal();
      if (counter) values[i] = 0.5 * std::round(2.0 * values[i]);
    }
    return values;
  }
  TwoSeries two(std::size_t n) { return two(n, n); }
  TwoSeries two(std::size_t n, std::size_t m) {
    TwoSeries both;
    both.simulated = series(n);
    both.measured = series(m);
    return both;
  }

 private:
  core::Random random_;
};

}  // namespace metrics_test
