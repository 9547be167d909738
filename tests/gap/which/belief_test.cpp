#include "gap/which/belief.h"

#include <gtest/gtest.h>

namespace gap {
namespace {

Yardstick gapOf(double z) { return {.baseline = 100.0 + z, .perfect = 100.0, .perfect_spread = 1.0}; }

double effectIn(double z, double accounted_for) { return beliefIn(gapOf(z), accounted_for, CauseKind::kEffect); }

TEST(Belief, GrowsWithTheShareOfTheGapThatACauseAccountsFor) {
  double before = 0.0;
  for (const double accounted_for : {0.0, 0.3, 0.5, 0.65, 0.8, 0.95, 1.0}) {
    const double belief = effectIn(20.0, accounted_for);
    EXPECT_GT(belief, before) << accounted_for;
    before = belief;
  }
  EXPECT_LT(before, 0.97) << "nobody is ever certain";
  EXPECT_GT(before, 0.9);
}

TEST(Belief, OfWhatIsNamedIsMoreThanEven) {
  constexpr double kNamedFrom = 0.7;  // docs/diagnosis.md
  EXPECT_GT(effectIn(20.0, kNamedFrom), 0.5);
  EXPECT_LT(effectIn(20.0, kNamedFrom - 0.1), 0.5);
}

// Of a gap hardly above noise, chance explains a share, too.
TEST(Belief, IsLessWhereTheGapIsSmall) {
  for (const double accounted_for : {0.5, 0.8, 1.0})
    EXPECT_LT(effectIn(4.9, accounted_for), 0.95 * effectIn(5.1, accounted_for)) << accounted_for;
}

// Few causes move a surface as a wrong pose does, set-up by set-up.
TEST(Belief, IsMoreInAReferenceHoweverSmallTheGap) {
  for (const double z : {4.0, 20.0}) EXPECT_GT(beliefIn(gapOf(z), 0.65, CauseKind::kReference), 0.85) << z;
}

}  // namespace
}  // namespace gap
