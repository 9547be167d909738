#include "gap/which/decision.h"

#include <gtest/gtest.h>

#include "gap/unexplained/rest.h"

namespace gap {
namespace {

/// Of the gap so much is left, all of which follows something.
Rest following(double left) { return {.left = left, .systematic = 1.0, .laws = {}}; }

TEST(Ceiling, IsNotHeldAgainstACauseThatLeavesNextToNothingByAnotherMeasure) {
  const auto left = [](double explained, double total_left) {
    return Candidate{.explained = explained, .total_left = total_left};
  };
  EXPECT_TRUE(staysBelowCeiling(left(0.7, 0.3), following(0.2)));
  EXPECT_FALSE(staysBelowCeiling(left(0.7, 0.3), following(0.05))) << "what is left follows nothing";
  EXPECT_FALSE(staysBelowCeiling(left(0.7, 0.01), following(0.2))) << "fog that takes the gap but for a hundredth";
  EXPECT_FALSE(staysBelowCeiling(left(0.97, 0.3), following(0.2))) << "a rare loss, which no single cell shows";
  Candidate comb = left(0.5, 0.6);
  comb.hypothesis.seen_in_values = true;
  EXPECT_FALSE(staysBelowCeiling(comb, following(0.5))) << "all ranges are multiples of one step";
}

TEST(Ceiling, OfAPlainLawIsHeldAgainstACauseSooner) {
  const Candidate cause{.explained = 0.8, .total_left = 0.3};
  Rest rest = following(0.07);
  EXPECT_FALSE(staysBelowCeiling(cause, rest));
  rest.laws = {{.measurand = "range", .component = "scatter", .explained = 0.4}};
  EXPECT_FALSE(staysBelowCeiling(cause, rest)) << "the law says less than half of it";
  rest.laws.front().explained = 0.6;
  EXPECT_TRUE(staysBelowCeiling(cause, rest));
  EXPECT_FALSE(staysBelowCeiling({.explained = 0.97, .total_left = 0.3}, rest));
}

TEST(Decision, NamesTheEffectOfAPairBeforeWhatIsBesideIt) {
  Hypothesis power, fog;
  power.kind = CauseKind::kParameter;
  power.name = "power";
  power.parameters = {{"value", "W"}};
  power.apply = fog.apply = [](World&, const std::vector<double>&) {};
  fog.name = "fog";
  fog.parameters = {{"visibility_m", "m"}, {"backscatter", ""}};
  Decision decision;
  decision.name({.hypothesis = together(power, fog), .values = {40.0, 300.0, 0.1}});
  EXPECT_EQ(decision.kind, VerdictKind::kEffect);
  EXPECT_EQ(decision.names(), std::vector<std::string>{"fog"});
  EXPECT_EQ(decision.beside(), std::vector<std::string>{"power"});
  EXPECT_EQ(decision.winner->values, (std::vector<double>{300.0, 0.1, 40.0}));
  EXPECT_EQ(membersOf(*decision.winner).front().hypothesis.name, "fog");
}

}  // namespace
}  // namespace gap
