#include "metrics/prediction/held_out.h"

#include <boost/math/distributions/binomial.hpp>
#include <cmath>
#include <limits>

#include "core/error.h"
#include "core/text.h"

namespace metrics {

namespace {

void checkParameters(const Prediction& prediction, const ErrorSamples& held_out) {
  check(held_out);
  if (held_out.parameters != prediction.regression.parameters) {
    throw core::InputError({.item = "held-out samples"},
                           "have the parameters " + core::join(held_out.parameters) + "; the prediction is over " +
                               core::join(prediction.regression.parameters) + ".",
                           "Give the same parameters in the same order.");
  }
}

Interval clopperPearson(std::size_t covered, std::size_t n, double level) {
  using Binomial = boost::math::binomial_distribution<>;
  const double each_side = 0.5 * (1.0 - level);
  const auto trials = static_cast<double>(n);
  const auto successes = static_cast<double>(covered);
  return {.low = Binomial::find_lower_bound_on_p(trials, successes, each_side),
          .high = Binomial::find_upper_bound_on_p(trials, successes, each_side)};
}

double skill(double misses, double misses_of_other) {
  return misses_of_other > 0.0 ? 1.0 - misses / misses_of_other : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

HeldOutCheck checkHeldOut(const Prediction& prediction, const ErrorSamples& held_out) {
  checkParameters(prediction, held_out);
  HeldOutCheck result{.n = held_out.size()};
  double squares = 0.0;
  double squares_of_none = 0.0;
  double squares_of_mean = 0.0;
  for (std::size_t row = 0; row < held_out.size(); ++row) {
    const double error = held_out.errors[row];
    const PredictedError predicted = prediction.at(held_out.point(row));
    const double miss = error - predicted.value;
    if (predicted.observation.contains(error)) ++result.covered;
    if (predicted.extrapolated()) ++result.extrapolated;
    result.mean_miss += miss / static_cast<double>(result.n);
    result.mean_absolute_miss += std::abs(miss) / static_cast<double>(result.n);
    if (row == 0 || std::abs(miss) > std::abs(result.largest_miss)) {
      result.largest_miss = miss;
      result.largest_miss_row = row;
    }
    squares += miss * miss;
    squares_of_none += error * error;
    squares_of_mean += (error - prediction.mean_error) * (error - prediction.mean_error);
  }
  result.coverage = clopperPearson(result.covered, result.n, prediction.level);
  result.skill_over_none = skill(squares, squares_of_none);
  result.skill_over_mean = skill(squares, squares_of_mean);
  return result;
}

}  // namespace metrics
