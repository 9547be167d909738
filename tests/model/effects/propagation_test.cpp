#include <cmath>
#include <gtest/gtest.h>

#include "tests/model/effects/effect_bench.h"

namespace model {
namespace {

using nlohmann::json;

double attenuation(double range_m, const json& parameters) {
  return lab::powerRatio(range_m, "atmospheric-attenuation", parameters);
}

TEST(AtmosphericAttenuation, PowerFallsExponentiallyOutAndBack) {
  EXPECT_NEAR(attenuation(50, {{"extinction_1_m", 0.01}}), std::exp(-2 * 0.01 * 50), 1e-9);
  EXPECT_NEAR(attenuation(100, {{"extinction_1_m", 0.01}}), std::pow(attenuation(50, {{"extinction_1_m", 0.01}}), 2),
              1e-9);
}

// Kruse's law with the exponents that Kim et al. 2001 give for the five ranges of visibility.
TEST(AtmosphericAttenuation, VisibilityFollowsKruseAndKim) {
  const std::pair<double, double> exponents[] = {{300, 0.0}, {700, 0.2}, {3000, 0.16 * 3 + 0.34}, {10000, 1.3}};
  for (const auto& [visibility_m, q] : exponents) {
    const double alpha = 3.912 / visibility_m * std::pow(905.0 / 550.0, -q);
    EXPECT_NEAR(attenuation(40, {{"visibility_m", visibility_m}}), std::exp(-2 * alpha * 40), 1e-9) << visibility_m;
  }
}

// 1.076 R^0.67 dB/km one way.
TEST(AtmosphericAttenuation, RainFollowsCarbonneau) {
  const double db = 2 * 0.1 * 1.076 * std::pow(25.0, 0.67);
  EXPECT_NEAR(attenuation(100, {{"rain_rate_mm_h", 25}}), std::pow(10.0, -db / 10), 1e-9);
}

TEST(AtmosphericAttenuation, WithoutParametersTheExperimentsWeatherHolds) {
  lab::Case setup = lab::boardWith(40, "atmospheric-attenuation");
  EXPECT_NEAR(lab::power_w(setup), lab::radarEquation(40), 1e-6 * lab::radarEquation(40));
  setup.environment["visibility_m"] = 200;
  EXPECT_NEAR(lab::power_w(setup) / lab::radarEquation(40), std::exp(-2 * 3.912 / 200 * 40), 1e-6);
}

// Mean number in the listening time 2 Δr / c; a Poisson count, four standard errors. Ranges are uniform: their mean is
// known to Δr / sqrt(12 n).
TEST(Crosstalk, ForeignPulsesArriveAtAnyRange) {
  lab::Case setup = lab::boardWith(20, "crosstalk", {{"rate_1_s", 2e4}});
  setup.scene = json::array();
  setup.sensor["detection"]["max_range_m"] = 150;
  setup.frames = 40000;
  const auto detections = lab::fire(setup);
  const double span = 150 - 0.01, expected = 40000 * 2e4 * 2 * span / 299792458.0;
  EXPECT_NEAR(static_cast<double>(detections.size()), expected, 4 * std::sqrt(expected));
  EXPECT_NEAR(lab::mean(detections.range_m), 75, 4 * span / std::sqrt(12 * expected));
  for (std::size_t i = 0; i < detections.size(); ++i) {
    ASSERT_GT(detections.intensity[i], 1e9 * lab::kThreshold_w);
    ASSERT_NEAR(detections.epw_m[i], lab::epwLaw(1e-9 * detections.intensity[i]), 1e-6);
  }
}

}  // namespace
}  // namespace model
