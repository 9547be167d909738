#include "gap/which/decision.h"

#include <gtest/gtest.h>

namespace gap {
namespace {

TEST(TotalGap, MayStayAsLargeWhereAllCellsAgreeOrTheCausesOwnNoiseIsLeft) {
  const auto left = [](double explained, double total_left) {
    return Candidate{.explained = explained, .total_left = total_left};
  };
  EXPECT_TRUE(holdsOnTotal(left(0.8, 0.9), 0.1));
  EXPECT_FALSE(holdsOnTotal(left(0.8, 0.9), -0.1)) << "fitted single cells only";
  EXPECT_TRUE(holdsOnTotal(left(0.96, 0.9), -0.1));
  EXPECT_TRUE(holdsOnTotal(left(0.8, 0.4), -0.1)) << "rare false alarms";
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
