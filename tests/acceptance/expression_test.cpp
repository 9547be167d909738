#include "acceptance/expression.h"

#include <cmath>
#include <gmock/gmock.h>

namespace acceptance {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

Expression parse(const std::string& text) { return Expression(text, {.item = "test T"}); }

const std::map<std::string, double> kValues = {{"d_bias", -0.03}, {"d_cavm", 0.02}, {"range_m", 10.0}, {"n_sim", 150}};

/// What the user would read.
std::string messageOf(const std::string& text) {
  try {
    (void)parse(text).evaluate(kValues);
  } catch (const core::InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(Expression, EvaluatesBothSidesOfARelation) {
  const Decision decision = parse("abs(d_bias) <= 0.005 * range_m").evaluate(kValues);
  EXPECT_TRUE(decision.holds);
  ASSERT_EQ(decision.relations.size(), 1u);
  EXPECT_DOUBLE_EQ(decision.relations[0].value, 0.03);
  EXPECT_DOUBLE_EQ(decision.relations[0].limit, 0.05);
  EXPECT_DOUBLE_EQ(decision.relations[0].margin(), 0.02);
  EXPECT_EQ(decision.relations[0].left, "abs(d_bias)");
  EXPECT_EQ(decision.relations[0].right, "0.005 * range_m");
}

TEST(Expression, HoldsOnlyIfAllRelationsDo) {
  EXPECT_TRUE(parse("abs(d_bias) <= 0.05 && d_cavm <= 0.05").evaluate(kValues).holds);
  EXPECT_FALSE(parse("abs(d_bias) <= 0.05 && d_cavm <= 0.01").evaluate(kValues).holds);
  EXPECT_FALSE(parse("abs(d_bias) <= 0.01 && d_cavm <= 0.05").evaluate(kValues).holds);
}

TEST(Expression, KnowsAllFourRelationsAtTheirBorder) {
  const std::map<std::string, double> one = {{"x", 1.0}};
  EXPECT_TRUE(parse("x <= 1").evaluate(one).holds);
  EXPECT_FALSE(parse("x < 1").evaluate(one).holds);
  EXPECT_TRUE(parse("x >= 1").evaluate(one).holds);
  EXPECT_FALSE(parse("x > 1").evaluate(one).holds);
  EXPECT_DOUBLE_EQ(parse("x >= 3").evaluate(one).decisive().margin(), -2.0);
}

TEST(Expression, TheSmallestMarginRelativeToItsLimitDecides) {
  EXPECT_EQ(parse("abs(d_bias) <= 0.04 && d_cavm <= 1").evaluate(kValues).decisive().left, "abs(d_bias)");
  EXPECT_EQ(parse("abs(d_bias) <= 1 && n_sim >= 149").evaluate(kValues).decisive().left, "n_sim");
  // A strict limit met exactly has no margin, but it is what fails.
  EXPECT_EQ(parse("d_cavm <= 0.020001 && n_sim < 150").evaluate(kValues).decisive().left, "n_sim");
}

TEST(Expression, ParenthesesMayGroupRelationsAndArithmetic) {
  EXPECT_THAT(parse("((d_cavm <= (1 + 2) * 3) && (min(n_sim, 3) > 2))").variables(), ElementsAre("d_cavm", "n_sim"));
  EXPECT_TRUE(parse("((d_cavm <= (1 + 2) * 3) && (min(n_sim, 3) > 2))").evaluate(kValues).holds);
  EXPECT_EQ(parse("(n_sim >= 1 && range_m > 0) && d_cavm < 1").evaluate(kValues).relations.size(), 3u);
}

TEST(Expression, AnUndefinedValueNeverHolds) {
  const std::map<std::string, double> values = {{"d_bias", std::nan("")}};
  EXPECT_FALSE(parse("d_bias <= 1").evaluate(values).holds);
  EXPECT_FALSE(parse("d_bias > 1").evaluate(values).holds);
}

TEST(Expression, AnUnknownVariableIsNamedWithItsPositionAndTheNearestKnownOne) {
  const std::string message = messageOf("d_cavm <= 1 && abs(d_bais) <= 1");
  EXPECT_THAT(message, HasSubstr("test T"));
  EXPECT_THAT(message, HasSubstr("position 20"));
  EXPECT_THAT(message, HasSubstr("names 'd_bais', which is not known."));
  EXPECT_THAT(message, HasSubstr("Did you mean 'd_bias'?"));
  EXPECT_THAT(messageOf("something_else <= 1"), HasSubstr("Known are d_bias, d_cavm, n_sim, range_m."));
}

TEST(Expression, SaysWhatIsWrongAndWhere) {
  EXPECT_THAT(messageOf("  "), HasSubstr("is empty."));
  EXPECT_THAT(messageOf("abs(d_bias)"), HasSubstr("compares nothing."));
  EXPECT_THAT(messageOf("0 <= d_bias <= 1"), HasSubstr("position 13: compares twice in one relation."));
  EXPECT_THAT(messageOf("d_bias = 1"), HasSubstr("position 8: has '='"));
  EXPECT_THAT(messageOf("d_bias == 1"), HasSubstr("has '='"));
  EXPECT_THAT(messageOf("d_bias < 1 || d_cavm < 1"), HasSubstr("position 12: has '|'"));
  EXPECT_THAT(messageOf("d_bias < 1 && "), HasSubstr("compares nothing."));
  EXPECT_THAT(messageOf("d_bias <= "), HasSubstr("lacks one side of a relation."));
  EXPECT_THAT(messageOf("abs(d_bias <= 1"), HasSubstr("ends before a parenthesis is closed."));
  EXPECT_THAT(messageOf("d_bias) <= 1"), HasSubstr("position 7: closes a parenthesis that was never opened."));
  EXPECT_THAT(messageOf("d_bias + * 2 <= 1"), HasSubstr("cannot be read"));
  EXPECT_THAT(messageOf("d_bias <= 0,005 * range_m"), HasSubstr("position 12: has ',' outside of a function."));
}

TEST(Expression, AnUnknownFunctionIsNamed) {
  const std::string message = messageOf("d_cavm <= 1 && abss(d_bias) <= 1");
  EXPECT_THAT(message, HasSubstr("abs"));
  EXPECT_NE(message, "no error");
}

}  // namespace
}  // namespace acceptance
