#pragma once

#include <string>

#include "gap/far/how_far.h"

namespace gap {

/// A unit in which numbers up to some size are read without an exponent: those in W below a milliwatt in nW, those
/// in nW above a tenth of a milliwatt in mW, lengths below a millimetre in mm.
struct ReadableUnit {
  double per_unit;  ///< of the unit that it stands for
  std::string unit;
};
[[nodiscard]] ReadableUnit readableUnit(double largest, const std::string& unit);

/// A number with its readable unit, to some digits; what exists in echoes per shot.
[[nodiscard]] std::string withUnit(double value, const std::string& unit, int digits = 3);
/// The same in the unit that suits the largest of some numbers: what stands side by side shares one, and what is
/// nothing beside the largest is 0.
[[nodiscard]] std::string withUnitOf(double largest, double value, const std::string& unit, int digits = 3);
/// "0.42 to 0.47 m"; both ends in one unit, which suits `largest`, too, and in so many digits that they differ.
[[nodiscard]] std::string intervalText(const Interval& interval, const std::string& unit, double largest = 0.0);

/// "62 %".
[[nodiscard]] std::string percent(double fraction);
/// "92 to 97 %".
[[nodiscard]] std::string percentInterval(const Interval& interval);
/// Of a gap that shrinks by so much of itself: "62 %", "-30 %", and what makes it more than twice as large "grows 4×".
[[nodiscard]] std::string shrinkOf(double fraction);
/// Its interval in the same words: "[55, 70]", "[110×, 140×]".
[[nodiscard]] std::string shrinkInterval(double fraction, const Interval& interval);

}  // namespace gap
