#include "metrics/sensitivity/fast_indices.h"

#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <complex>
#include <fmt/format.h>
#include <limits>
#include <unsupported/Eigen/FFT>
#include <vector>

#include "core/error.h"
#include "metrics/distributions/edf.h"
#include "metrics/distributions/summation.h"
#include "metrics/sensitivity/sensitivity_plan.h"

namespace metrics {

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

void check(std::span<const double> outputs, std::size_t parameters, std::size_t n, std::size_t curves,
           double confidence) {
  if (!(confidence > 0.0 && confidence < 1.0)) {
    throw core::InputError({.item = "confidence"}, fmt::format("is {}; it must lie between 0 and 1.", confidence),
                           "Give 0.95 for 95 per cent.");
  }
  if (parameters == 0 || curves == 0 || n < 4 * kFastHarmonics * kFastHarmonics + 1 ||
      outputs.size() != n * parameters * curves) {
    throw core::InputError(
        {},
        fmt::format("{} outputs for {} parameters, n = {} and {} curves; a plan of FAST has n k rows "
                    "a curve, n at least 65.",
                    outputs.size(), parameters, n, curves),
        "Give one output for each row of the plan, in its order.");
  }
  mustBeFinite(outputs);
}

struct BlockIndices {
  double first;
  double total;
};

/// Of the outputs along one curve.
BlockIndices blockIndices(std::span<const double> outputs) {
  std::vector<double> y(outputs.begin(), outputs.end());
  const double mean = Edf(y).mean();
  Summation squares;
  for (double& value : y) {
    value -= mean;
    squares.add(value * value);
  }
  const auto n = static_cast<double>(y.size());
  const double variance = squares.value() / n;
  if (variance <= 0.0) return {.first = kNan, .total = kNan};

  std::vector<std::complex<double>> spectrum;
  Eigen::FFT<double>().fwd(spectrum, y);
  const auto power = [&](std::size_t p) { return 2.0 * std::norm(spectrum[p] / n); };
  const std::size_t w = fastFrequency(y.size());
  double of_parameter = 0.0;
  for (std::size_t p = 1; p <= kFastHarmonics; ++p) of_parameter += power(p * w);
  double of_others = 0.0;
  for (std::size_t p = 1; p <= w / 2; ++p) of_others += power(p);
  return {.first = of_parameter / variance, .total = 1.0 - of_others / variance};
}

SensitivityIndex meanOf(const std::vector<double>& curves, double confidence) {
  Summation sum;
  for (const double x : curves) sum.add(x);
  const auto count = static_cast<double>(curves.size());
  const double mean = sum.value() / count;
  if (curves.size() < 2 || !std::isfinite(mean)) return {.value = mean, .low = kNan, .high = kNan};
  const double t = boost::math::quantile(boost::math::students_t(count - 1.0), 0.5 * (1.0 + confidence));
  const double half = t * Edf(curves).standardDeviation() / std::sqrt(count);
  return {.value = mean, .low = mean - half, .high = mean + half};
}

}  // namespace

SensitivityResult fastIndices(std::span<const double> outputs, std::size_t parameters, std::size_t n,
                              std::size_t curves, double confidence) {
  check(outputs, parameters, n, curves, confidence);
  const Edf all(std::vector<double>(outputs.begin(), outputs.end()));
  SensitivityResult result{.mean = all.mean(), .variance = std::pow(all.standardDeviation(), 2.0), .parameters = {}};
  for (std::size_t i = 0; i < parameters; ++i) {
    std::vector<double> firsts;
    std::vector<double> totals;
    for (std::size_t curve = 0; curve < curves; ++curve) {
      const BlockIndices indices = blockIndices(outputs.subspan((curve * parameters + i) * n, n));
      firsts.push_back(indices.first);
      totals.push_back(indices.total);
    }
    result.parameters.push_back({.first = meanOf(firsts, confidence), .total = meanOf(totals, confidence)});
  }
  return result;
}

}  // namespace metrics
