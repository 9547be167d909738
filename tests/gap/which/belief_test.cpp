#include "gap/which/belief.h"

#include <gtest/gtest.h>
#include <string>
#include <vector>

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
    EXPECT_LT(effectIn(4.9, accounted_for), 0.97 * effectIn(5.1, accounted_for)) << accounted_for;
}

// One number fits a little noise more easily than an effect that must also be where it is.
TEST(Belief, OfASmallGapIsLeastInAParameter) {
  EXPECT_LT(beliefIn(gapOf(4.0), 0.9, CauseKind::kParameter), effectIn(4.0, 0.9));
  EXPECT_EQ(beliefIn(gapOf(20.0), 0.9, CauseKind::kParameter), effectIn(20.0, 0.9));
}

// Few causes move a surface as a wrong pose does, set-up by set-up.
TEST(Belief, IsMoreInAReferenceHoweverSmallTheGap) {
  for (const double z : {4.0, 20.0}) EXPECT_GT(beliefIn(gapOf(z), 0.65, CauseKind::kReference), 0.85) << z;
}

/// A best cause and others with these separations from it.
Decision decisionAmong(const std::vector<double>& separations) {
  Decision decision;
  decision.singles.resize(1 + separations.size());
  decision.singles.front().hypothesis.name = "best";
  for (std::size_t i = 0; i < separations.size(); ++i) {
    const std::string name = "rival " + std::to_string(i);
    decision.singles[i + 1].hypothesis.name = name;
    decision.rivals.push_back({name, separations[i], {}});
  }
  return decision;
}

// Of 69 fresh verdicts in which one cause of several was right that nothing told apart, 38 named that one first
// (docs/diagnosis-evidence.md).
TEST(Belief, IsSharedByWhatCannotBeToldApartOfWhichTheBestIsLikelierThanAnyOther) {
  const std::vector<double> shared = confidencesOf(decisionAmong({0.0, 0.0, 9.0}), 0.9);
  EXPECT_NEAR(shared[0] + shared[1] + shared[2], 0.9, 1e-9);
  EXPECT_DOUBLE_EQ(shared[1], shared[2]);
  EXPECT_NEAR(shared[0], 0.5, 1e-9);  // 2.5 of 4.5
  EXPECT_NEAR(shared[3], 0.0, 1e-9);
}

TEST(Belief, OfWhatIsToldFromAllOthersIsShared) {
  EXPECT_NEAR(confidencesOf(decisionAmong({5.0, 7.0}), 0.9).front(), 0.9, 1e-5);
}

}  // namespace
}  // namespace gap
