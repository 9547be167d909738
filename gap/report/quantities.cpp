#include "gap/report/quantities.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "core/text.h"

namespace gap {

namespace {

constexpr int kFewDigits = 3, kMostDigits = 7;  // of the ends of an interval

/// What would be said with an exponent beside a number a thousand times as large is 0.
std::string significantBeside(double largest, double value, int digits) {
  constexpr double kWithExponent = 1e-4, kNothing = 1e-3;
  const bool nothing = std::abs(value) < kWithExponent && std::abs(value) < kNothing * std::abs(largest);
  return core::significant(nothing ? 0.0 : value, digits);
}

std::string numberIn(const ReadableUnit& shown, double largest, double value, int digits) {
  const std::string number = significantBeside(shown.per_unit * largest, shown.per_unit * value, digits);
  if (shown.unit == "1/shot") return number + (number == "1" || number == "-1" ? " echo per shot" : " echoes per shot");
  return number + (shown.unit.empty() || shown.unit == "°" ? "" : " ") + shown.unit;
}

/// In whole per cent, never "-0".
double wholePercent(double fraction) { return std::round(100.0 * fraction) + 0.0; }

/// So much larger that per cent say less than a factor.
bool growsManyTimes(double shrink) { return shrink < -1.0; }

}  // namespace

ReadableUnit readableUnit(double largest, const std::string& unit) {
  constexpr double kSmall = 1e-3, kManyNanowatts = 1e5;
  if (unit == "nW" && largest >= kManyNanowatts) return {1e-6, "mW"};
  if (largest == 0.0 || largest >= kSmall) return {1.0, unit};
  if (unit == "W") return {1e9, "nW"};
  if (unit == "m") return {1e3, "mm"};
  return {1.0, unit};
}

std::string withUnit(double value, const std::string& unit, int digits) { return withUnitOf(0.0, value, unit, digits); }

std::string withUnitOf(double largest, double value, const std::string& unit, int digits) {
  const double size = std::max(largest, std::abs(value));
  return numberIn(readableUnit(size, unit), size, value, digits);
}

std::string intervalText(const Interval& interval, const std::string& unit, double largest) {
  const double size = std::max({std::abs(interval.low), std::abs(interval.high), largest});
  const ReadableUnit shown = readableUnit(size, unit);
  const auto text = [&](double end, int digits) {
    return significantBeside(shown.per_unit * size, shown.per_unit * end, digits);
  };
  int digits = kFewDigits;
  while (digits < kMostDigits && interval.low < interval.high &&
         text(interval.low, digits) == text(interval.high, digits))
    ++digits;
  return fmt::format("{} to {}", text(interval.low, digits), numberIn(shown, size, interval.high, digits));
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
