#include "gap/report/quantities.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "core/text.h"

namespace gap {

namespace {

/// A unit in which numbers of this size are read without an exponent.
struct Readable {
  double per_unit;
  std::string unit;
};

Readable readable(double largest, const std::string& unit) {
  constexpr double kSmall = 1e-3;
  if (largest == 0.0 || largest >= kSmall) return {1.0, unit};
  if (unit == "W") return {1e9, "nW"};
  if (unit == "m") return {1e3, "mm"};
  return {1.0, unit};
}

std::string numberIn(const Readable& shown, double value, int digits) {
  const std::string number = core::significant(shown.per_unit * value, digits);
  if (shown.unit == "1/shot") return number + (number == "1" || number == "-1" ? " echo per shot" : " echoes per shot");
  return number + (shown.unit.empty() || shown.unit == "°" ? "" : " ") + shown.unit;
}

/// In whole per cent, never "-0".
double wholePercent(double fraction) { return std::round(100.0 * fraction) + 0.0; }

/// So much larger that per cent say less than a factor.
bool growsManyTimes(double shrink) { return shrink < -1.0; }

}  // namespace

std::string withUnit(double value, const std::string& unit, int digits) { return withUnitOf(0.0, value, unit, digits); }

std::string withUnitOf(double largest, double value, const std::string& unit, int digits) {
  return numberIn(readable(std::max(largest, std::abs(value)), unit), value, digits);
}

std::string intervalText(const Interval& interval, const std::string& unit, double largest) {
  const Readable shown = readable(std::max({std::abs(interval.low), std::abs(interval.high), largest}), unit);
  return fmt::format("{} to {}", core::significant(shown.per_unit * interval.low), numberIn(shown, interval.high, 3));
}

std::string percent(double fraction) { return fmt::format("{:.0f} %", wholePercent(fraction)); }

std::string percentInterval(const Interval& interval) {
  return fmt::format("{:.0f} to {:.0f} %", wholePercent(interval.low), wholePercent(interval.high));
}

std::string shrinkOf(double fraction) {
  return growsManyTimes(fraction) ? fmt::format("grows {:.0f}×", 1.0 - fraction) : percent(fraction);
}

std::string shrinkInterval(double fraction, const Interval& interval) {
  if (growsManyTimes(fraction)) return fmt::format("[{:.0f}×, {:.0f}×]", 1.0 - interval.high, 1.0 - interval.low);
  return fmt::format("[{:.0f}, {:.0f}]", wholePercent(interval.low), wholePercent(interval.high));
}

}  // namespace gap
