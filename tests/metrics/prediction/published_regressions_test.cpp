#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "metrics/prediction/prediction.h"

// Regressions printed in Rosenberger 2023, ch. 10: a line over the reference range, in brackets the 95 %
// bound of largest magnitude. The inputs are printed in millimetres, so each may be half a millimetre off, and with one
// or two degrees of freedom that moves bounds far.
namespace {

using metrics::ErrorSamples;
using metrics::Family;
using metrics::predict;
using metrics::PredictedError;

constexpr double kRounding = 0.0005;  // [m]

struct Row {
  const char* name;
  std::vector<double> ranges_m;
  std::vector<double> errors_m;
  bool never_negative;
  double at_m;
  double value;  ///< printed
  double bound;  ///< printed, without sign
};

const std::vector<double> kThree{9.984, 14.995, 19.865};
const std::vector<double> kFour{0.974, 2.014, 2.997, 4.988};

/// The least and the largest |bound| and value that inputs could give that round to the printed ones.
struct Reach {
  double value_low = INFINITY, value_high = -INFINITY;
  double bound_low = INFINITY, bound_high = -INFINITY;

  void add(const PredictedError& error) {
    value_low = std::min(value_low, error.value);
    value_high = std::max(value_high, error.value);
    const double bound = std::abs(error.largest());
    bound_low = std::min(bound_low, bound);
    bound_high = std::max(bound_high, bound);
  }
};

/// Every combination of five shifts between -0.5 mm and 0.5 mm of each error. Shifts of the ranges matter less by the
/// slope (0.3 at most for EPW at the shortest ranges).
Reach reachOf(const Row& row) {
  Reach reach;
  ErrorSamples samples{.target = "d", .parameters = {"range_m"}, .points = row.ranges_m, .errors = row.errors_m};
  const int combinations = static_cast<int>(std::pow(5, row.errors_m.size()));
  for (int code = 0; code < combinations; ++code) {
    int rest = code;
    for (std::size_t i = 0; i < samples.size(); ++i, rest /= 5) {
      samples.errors[i] = row.errors_m[i] + 0.5 * kRounding * (rest % 5 - 2);
      if (row.never_negative) samples.errors[i] = std::max(0.0, samples.errors[i]);
    }
    reach.add(
        predict(samples, {.family = Family::Linear, .never_negative = row.never_negative}).at(std::array{row.at_m}));
  }
  return reach;
}

void expectWithinReach(const Row& row) {
  SCOPED_TRACE(testing::Message() << row.name << " at " << row.at_m << " m");
  const Reach reach = reachOf(row);
  EXPECT_GE(row.value, reach.value_low - kRounding);
  EXPECT_LE(row.value, reach.value_high + kRounding);
  EXPECT_GE(row.bound, reach.bound_low - kRounding);
  EXPECT_LE(row.bound, reach.bound_high + kRounding);
}

TEST(PublishedRegressions, AreReachedWithinTheRoundingOfTheirInputs) {
  const std::vector<double> r_bias{-0.027, 0.006, 0.036};
  const std::vector<double> epw_bias{0.027, 0.028, 0.038};
  const std::vector<double> epw_cavm{0.022, 0.019, 0.005};
  const std::vector<double> x_bias{-0.003, 0.003, 0.0, 0.0};
  const std::vector<double> x_cavm{0.008, 0.004, 0.003, 0.003};
  const std::vector<double> near_epw_cavm{0.119, 0.160, 0.111, 0.095};
  for (const Row& row : std::vector<Row>{
           {"r d_bias", kThree, r_bias, false, 12.436, -0.011, 0.023},
           {"r d_bias", kThree, r_bias, false, 17.410, 0.020, 0.032},
           {"EPW d_bias", kThree, epw_bias, false, 12.436, 0.028, 0.061},
           {"EPW d_bias", kThree, epw_bias, false, 17.410, 0.034, 0.066},
           {"EPW d_CAVM", kThree, epw_cavm, true, 12.436, 0.020, 0.055},
           {"EPW d_CAVM", kThree, epw_cavm, true, 17.410, 0.011, 0.046},
           {"x d_bias", kFour, x_bias, false, 1.478, 0.000, 0.008},
           {"x d_bias", kFour, x_bias, false, 8.938, 0.001, 0.029},
           {"x d_CAVM", kFour, x_cavm, true, 1.478, 0.006, 0.012},
           {"x d_CAVM", kFour, x_cavm, true, 8.938, 0.000, 0.018},
           {"EPW d_CAVM", kFour, near_epw_cavm, true, 1.478, 0.134, 0.210},
           {"EPW d_CAVM", kFour, near_epw_cavm, true, 8.938, 0.061, 0.310},
       }) {
    expectWithinReach(row);
  }
}

// Tab. 10-6 as printed: EPW d_bias .160 (.613) and -2.290 (-3.763). From the printed inputs .158 (.591) and -2.294
// (-3.711): bounds 4 % wider are printed than any inputs that round to the printed ones give. The regression was
// presumably made from other than the printed numbers; nothing else in the tables needs another formula.
TEST(PublishedRegressions, EpwBiasAtShortRangeIsTheExceptionWithBoundsFourPercentWider) {
  const std::vector<double> epw_bias{0.456, -0.127, -0.446, -0.915};
  for (const Row& row : {Row{"EPW d_bias", kFour, epw_bias, false, 1.478, 0.160, 0.613},
                         Row{"EPW d_bias", kFour, epw_bias, false, 8.938, -2.290, 3.763}}) {
    const Reach reach = reachOf(row);
    EXPECT_GT(row.bound, reach.bound_high + kRounding);
    const PredictedError ours = predict({.target = "d", .parameters = {"range_m"}, .points = kFour, .errors = epw_bias})
                                    .at(std::array{row.at_m});
    EXPECT_NEAR(ours.value, row.value, 0.005);
    const double half_width = ours.confidence.high - ours.value;
    EXPECT_NEAR((row.bound - std::abs(row.value)) / half_width, 1.04, 0.01);
  }
}

// The published bounds are those of the mean, not of one more sample: with these the rows above would print .086, .091
// and .946.
TEST(PublishedRegressions, ObservationBoundsAreExcluded) {
  const auto largest = [](const std::vector<double>& ranges, const std::vector<double>& errors, double at) {
    const PredictedError error =
        predict({.target = "d", .parameters = {"range_m"}, .points = ranges, .errors = errors}).at(std::array{at});
    return std::max(std::abs(error.observation.low), std::abs(error.observation.high));
  };
  EXPECT_NEAR(largest(kThree, {0.027, 0.028, 0.038}, 12.436), 0.086, 0.001);
  EXPECT_NEAR(largest(kThree, {0.027, 0.028, 0.038}, 17.410), 0.091, 0.001);
  EXPECT_NEAR(largest(kFour, {0.456, -0.127, -0.446, -0.915}, 1.478), 0.946, 0.001);
}

}  // namespace
