#pragma once

#include <cstdint>
#include <vector>

#include "core/random.h"
#include "metrics/points/point_cloud.h"

namespace metrics_test {

using Cloud = std::vector<metrics::Position>;

/// Random clouds; a seed makes the same ones on every machine.
class RandomClouds {
 public:
  explicit RandomClouds(std::uint64_t seed) : random_({.seed = seed, .purpose = core::purposeOf("clouds_test")}) {}

  std::uint32_t below(std::uint32_t n) { return random_.below(n); }
  double uniform(double low, double high) { return low + (high - low) * random_.uniform(); }
  metrics::Position position(double spread = 3.0) {
    return {spread * random_.normal(), spread * random_.normal(), spread * random_.normal()};
  }
  Cloud cloud(std::size_t n, double spread = 3.0) {
    Cloud points;
    while (points.size() < n) points.push_back(position(spread));
    return points;
  }
  Cloud anySize(std::uint32_t most) { return cloud(1 + below(most)); }

 private:
  core::Random random_;
};

inline Cloud shifted(Cloud cloud, const metrics::Position& by) {
  for (metrics::Position& p : cloud) p = {p.x_m + by.x_m, p.y_m + by.y_m, p.z_m + by.z_m};
  return cloud;
}

/// Every point as often as told.
inline Cloud repeated(const Cloud& cloud, int times) {
  Cloud all;
  for (int k = 0; k < times; ++k) all.insert(all.end(), cloud.begin(), cloud.end());
  return all;
}

}  // namespace metrics_test
