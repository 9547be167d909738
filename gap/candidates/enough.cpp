#include "gap/candidates/enough.h"

#include <algorithm>

namespace gap {

namespace {

constexpr double kAccountsFor = 0.7;  // of the gap: what accounts for less is as likely wrong as right
constexpr double kOfTheCells = 0.92;  // explained by a pair, beside noise: right ones explain 0.95 and more

}  // namespace

double enoughToName(const Yardstick& yardstick) {
  return std::max(kWeakGap, kAccountsFor - 2.0 * yardstick.noiseOfShare());
}

double enoughForTwo(const Yardstick& yardstick) { return kOfTheCells - 2.0 * yardstick.noiseOfShare(); }

}  // namespace gap
