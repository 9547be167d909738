#include "gap/which/decision.h"

#include <gtest/gtest.h>

#include "gap/unexplained/rest.h"

namespace gap {
namespace {

/// Of the gap so much is left, all of which follows something.
Rest following(double left) { return {.left = left, .systematic = 1.0, .laws = {}}; }

/// Won by a cause that explains so much of the cells and leaves so much of the total gap.
Decision wonBy(double explained, double total_left) {
  Decision decision;
  decision.winner = Candidate{.hypothesis = {.name = "fog"}, .explained = explained, .total_left = total_left};
  return decision;
}

TEST(Ceiling, IsNotHeldAgainstACauseThatLeavesNextToNothingByAnotherMeasure) {
  EXPECT_TRUE(staysBelowCeiling(wonBy(0.7, 0.3), following(0.2)));
  EXPECT_FALSE(staysBelowCeiling(wonBy(0.7, 0.3), following(0.05))) << "what is left follows nothing";
  EXPECT_FALSE(staysBelowCeiling(wonBy(0.7, 0.01), following(0.2))) << "fog that takes the gap but for a hundredth";
  EXPECT_FALSE(staysBelowCeiling(wonBy(0.97, 0.3), following(0.2))) << "a rare loss, which no single cell shows";
  Decision comb = wonBy(0.5, 0.6);
  comb.winner->hypothesis.seen_in_values = true;
  EXPECT_FALSE(staysBelowCeiling(comb, following(0.5))) << "all ranges are multiples of one step";
}

TEST(Ceiling, OfAPlainLawIsHeldAgainstACauseSooner) {
  const Decision decision = wonBy(0.8, 0.3);
  Rest rest = following(0.07);
  EXPECT_FALSE(staysBelowCeiling(decision, rest));
  rest.laws = {{.measurand = "range", .component = "scatter", .explained = 0.4}};
  EXPECT_FALSE(staysBelowCeiling(decision, rest)) << "the law says less than half of it";
  rest.laws.front().explained = 0.6;
  EXPECT_TRUE(staysBelowCeiling(decision, rest));
  EXPECT_FALSE(staysBelowCeiling(wonBy(0.97, 0.3), rest));
}

TEST(Ceiling, OfAPlainLawIsNotHeldAgainstACauseBesideWhichAnotherOneTakesIt) {
  Decision decision = wonBy(0.8, 0.3);
  const Rest rest{.left = 0.07, .systematic = 1.0, .laws = {{.measurand = "epw", .explained = 0.9}}};
  const auto tried = [](const char* member, double explained) {
    return Candidate{.hypothesis = {.members = {{.name = member}, {.name = "jitter"}}}, .explained = explained};
  };
  decision.pairs = {tried("fog", 0.94), tried("rain", 0.99)};
  EXPECT_TRUE(staysBelowCeiling(decision, rest)) << "beside fog the jitter leaves 0.06";
  decision.pairs.front().explained = 0.97;
  EXPECT_FALSE(staysBelowCeiling(decision, rest));
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
