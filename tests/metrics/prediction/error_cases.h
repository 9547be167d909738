#pragma once

#include <vector>

#include "core/random.h"
#include "metrics/prediction/error_samples.h"

namespace metrics_test {

/// Errors that follow a function of the range.
template <typename Function>
metrics::ErrorSamples overRange(const std::vector<double>& ranges_m, Function error) {
  metrics::ErrorSamples samples{.target = "d_bias", .parameters = {"range_m"}, .points = ranges_m, .errors = {}};
  for (const double x : ranges_m) samples.errors.push_back(error(x));
  return samples;
}

/// n points scattered over 0 to 100 m and 0 to 60 deg, the same on every machine.
template <typename Function>
metrics::ErrorSamples overTwo(int n, Function error) {
  core::Random random({.seed = 7, .purpose = core::purposeOf("overTwo")});
  metrics::ErrorSamples samples{.target = "d_bias", .parameters = {"range_m", "angle_deg"}, .points = {}, .errors = {}};
  for (int i = 0; i < n; ++i) {
    const double x = 100.0 * random.uniform();
    const double y = 60.0 * random.uniform();
    samples.points.insert(samples.points.end(), {x, y});
    samples.errors.push_back(error(x, y));
  }
  return samples;
}

}  // namespace metrics_test
