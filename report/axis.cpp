#include "report/axis.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace report {

namespace {

/// 1, 2 or 5 times a power of ten, so that about `count` steps fit into `length`; exponent gives the decimals.
struct Step {
  double size;
  int decimals;
};

Step niceStep(double length, int count) {
  const double raw = length / std::max(count, 1);
  int exponent = static_cast<int>(std::floor(std::log10(raw)));
  const double lead = raw / std::pow(10.0, exponent);
  double factor = 10.0;
  for (const double candidate : {1.0, 2.0, 5.0}) {
    if (lead <= candidate * 1.0001) {
      factor = candidate;
      break;
    }
  }
  if (factor == 10.0) {
    factor = 1.0;
    ++exponent;
  }
  return {factor * std::pow(10.0, exponent), std::max(0, -exponent)};
}

}  // namespace

Ticks niceTicks(Range range, int count) {
  Ticks ticks;
  const double length = range.high - range.low;
  if (!(length > 0.0) || !std::isfinite(length)) return ticks;
  const Step step = niceStep(length, count);
  const double first = std::ceil(range.low / step.size - 1e-9);
  const double last = std::floor(range.high / step.size + 1e-9);
  // Values so large that the step is lost in rounding would loop for ever.
  if (!(last - first < 1000.0) || std::abs(first) > 1e15) return ticks;
  for (double k = first; k <= last; k += 1.0) {
    const double value = k == 0.0 ? 0.0 : k * step.size;  // no "-0"
    ticks.at.push_back(value);
    const bool plain = std::abs(value) < 1e7 && step.decimals <= 6;
    ticks.labels.push_back(plain ? fmt::format("{:.{}f}", value, step.decimals) : fmt::format("{:.3g}", value));
  }
  return ticks;
}

Range widened(Range range, double fraction) {
  double margin = fraction * (range.high - range.low);
  const double resolvable = 1e-6 * std::max({std::abs(range.low), std::abs(range.high), 1e-6});
  if (range.high - range.low < resolvable) margin = std::max(resolvable, 0.01 * std::abs(range.low));
  return {range.low - margin, range.high + margin};
}

double Scale::pixel(double value) const {
  const double share = (value - values_.low) / (values_.high - values_.low);
  return pixel_low_ + share * (pixel_high_ - pixel_low_);
}

double Scale::value(double pixel) const {
  const double share = (pixel - pixel_low_) / (pixel_high_ - pixel_low_);
  return values_.low + share * (values_.high - values_.low);
}

double Scale::pixelWithin(double value) const { return pixel(std::clamp(value, values_.low, values_.high)); }

}  // namespace report
