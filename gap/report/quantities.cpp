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

}  // namespace

std::string withUnit(double value, const std::string& unit, int digits) {
  const Readable shown = readable(std::abs(value), unit);
  const std::string number = core::significant(shown.per_unit * value, digits);
  if (unit == "1/shot") return number + (number == "1" || number == "-1" ? " echo per shot" : " echoes per shot");
  return number + (unit.empty() || unit == "°" ? "" : " ") + shown.unit;
}

std::string intervalText(const Interval& interval, const std::string& unit) {
  const Readable shown = readable(std::max(std::abs(interval.low), std::abs(interval.high)), unit);
  return fmt::format("{} to {}", core::significant(shown.per_unit * interval.low),
                     withUnit(shown.per_unit * interval.high, shown.unit));
}

std::string percent(double fraction) { return fmt::format("{:.0f} %", 100.0 * fraction); }

}  // namespace gap
