#include "metrics/validity/tolerance_check.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "core/error.h"
#include "metrics/distributions/edf.h"

namespace metrics {

namespace {

void mustBeACurve(std::span<const double> curve, std::size_t points, const std::string& name) {
  if (curve.size() != points) {
    throw core::InputError({.item = name}, fmt::format("has {} values for {} parameters.", curve.size(), points),
                           "Interpolate all curves to the same parameters first.");
  }
  const auto bad = std::find_if(curve.begin(), curve.end(), [](double x) { return !std::isfinite(x); });
  if (bad == curve.end()) return;
  throw core::InputError({.item = fmt::format("{}, value {}", name, bad - curve.begin() + 1)},
                         fmt::format("is {}; a curve needs finite numbers.", *bad),
                         "Remove or correct it; nothing is dropped silently.");
}

void check(std::span<const double> parameter, std::span<const std::vector<double>> curves, const Tolerance& tolerance) {
  if (parameter.empty() || curves.empty()) {
    throw core::InputError({}, "a tolerance band needs a parameter and a curve at least.", "Check the file.");
  }
  mustBeACurve(parameter, parameter.size(), "parameter");
  const auto fall = std::adjacent_find(parameter.begin(), parameter.end(), std::greater_equal<>());
  if (fall != parameter.end()) {
    throw core::InputError({.item = fmt::format("parameter, value {}", fall - parameter.begin() + 2)},
                           fmt::format("is {} after {}; parameters must ascend.", *(fall + 1), *fall),
                           "Sort the curves by their parameter; take the mean of points at the same one.");
  }
  for (std::size_t k = 0; k < curves.size(); ++k) {
    mustBeACurve(curves[k], parameter.size(), fmt::format("curve {}", k + 1));
  }
  for (const double part : {tolerance.deviations, tolerance.absolute, tolerance.relative}) {
    if (part >= 0.0 && std::isfinite(part)) continue;
    throw core::InputError({.item = "tolerance"}, fmt::format("is {}; it must not be negative.", part),
                           "Give magnitudes; the band has two sides.");
  }
  if (tolerance.deviations > 0.0 && curves.size() < 2) {
    throw core::InputError({.item = "tolerance"}, "counts deviations, but there is a single curve.",
                           "Give two repetitions or more, or an absolute or relative tolerance.");
  }
}

}  // namespace

ToleranceBand toleranceBand(std::span<const double> parameter, std::span<const std::vector<double>> curves,
                            const Tolerance& tolerance) {
  check(parameter, curves, tolerance);
  ToleranceBand band{.parameter = {parameter.begin(), parameter.end()}, .low = {}, .high = {}};
  for (std::size_t i = 0; i < parameter.size(); ++i) {
    std::vector<double> here;
    for (const std::vector<double>& curve : curves) here.push_back(curve[i]);
    const Edf repetitions(std::move(here));
    const double mean = repetitions.mean();
    const double scatter = tolerance.deviations > 0.0 ? tolerance.deviations * repetitions.standardDeviation() : 0.0;
    const double half = scatter + tolerance.absolute + tolerance.relative * std::abs(mean);
    band.low.push_back(mean - half);
    band.high.push_back(mean + half);
  }
  return band;
}

ToleranceCheck checkTolerance(const ToleranceBand& band, std::span<const double> curve) {
  mustBeACurve(curve, band.parameter.size(), "curve");
  ToleranceCheck result{.share_inside = 1.0, .first = {}, .worst = {}};
  std::size_t outside = 0;
  for (std::size_t i = 0; i < curve.size(); ++i) {
    const double excess = curve[i] > band.high[i]  ? curve[i] - band.high[i]
                          : curve[i] < band.low[i] ? curve[i] - band.low[i]
                                                   : 0.0;
    if (excess == 0.0) continue;
    ++outside;
    const Violation here{.index = i, .parameter = band.parameter[i], .excess = excess};
    if (!result.first) result.first = here;
    if (!result.worst || std::abs(excess) > std::abs(result.worst->excess)) result.worst = here;
  }
  result.share_inside = 1.0 - static_cast<double>(outside) / static_cast<double>(curve.size());
  return result;
}

}  // namespace metrics
