#include "metrics/sensitivity/sensitivity_plan.h"

#include <cmath>
#include <gtest/gtest.h>
#include <set>

#include "core/error.h"
#include "tests/metrics/sensitivity/closed_forms.h"
#include "tests/support/thrown_message.h"

namespace {

using metrics::fastPlan;
using metrics::SensitivityPlan;
using metrics::sobolPlan;
using metrics_test::parameters;

// What makes it a (t, m, s)-net in one dimension: 2^m points put one in every 2^m-th of each range, whatever the shift.
TEST(SobolPlan, FillsEveryRangeEvenly) {
  for (const std::uint64_t seed : {1, 2, 77}) {
    const SensitivityPlan plan = sobolPlan(parameters(5, 0.0, 1.0), 64, seed);
    for (std::size_t block = 0; block < 7; ++block) {
      for (std::size_t i = 0; i < 5; ++i) {
        std::set<int> cells;
        for (std::size_t j = 0; j < 64; ++j) cells.insert(static_cast<int>(64.0 * plan.rows[block * 64 + j][i]));
        EXPECT_EQ(cells.size(), 64u);
      }
    }
  }
}

TEST(SobolPlan, MixesOneParameterOfBIntoA) {
  const SensitivityPlan plan = sobolPlan(parameters(3, -2.0, 5.0), 16, 1);
  ASSERT_EQ(plan.rows.size(), 16u * 5u);
  for (std::size_t j = 0; j < 16; ++j) {
    for (std::size_t block = 0; block < 3; ++block) {
      for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(plan.rows[(2 + block) * 16 + j][i], plan.rows[(i == block ? 16 : 0) + j][i]);
      }
    }
  }
  EXPECT_EQ(plan.blockOf(0), "A");
  EXPECT_EQ(plan.blockOf(16), "B");
  EXPECT_EQ(plan.blockOf(2 * 16 + 15), "x1");
  EXPECT_EQ(plan.blockOf(4 * 16), "x3");
}

TEST(SensitivityPlan, IsTheSameForTheSameSeedOnly) {
  EXPECT_EQ(sobolPlan(parameters(2, 0.0, 1.0), 8, 1).rows, sobolPlan(parameters(2, 0.0, 1.0), 8, 1).rows);
  EXPECT_NE(sobolPlan(parameters(2, 0.0, 1.0), 8, 1).rows, sobolPlan(parameters(2, 0.0, 1.0), 8, 2).rows);
  EXPECT_NE(fastPlan(parameters(2, 0.0, 1.0), 65, 1, 1).rows, fastPlan(parameters(2, 0.0, 1.0), 65, 1, 2).rows);
}

TEST(SensitivityPlan, StaysInItsRangesAndSpreadsDecadesEvenly) {
  const std::vector<metrics::UncertainParameter> ranges{{.name = "x", .min = 0.1, .max = 1000.0, .logarithmic = true}};
  for (const SensitivityPlan& plan : {sobolPlan(ranges, 64, 3), fastPlan(ranges, 129, 2, 3)}) {
    std::size_t below_ten = 0;
    for (const auto& row : plan.rows) {
      EXPECT_GE(row[0], 0.1);
      EXPECT_LE(row[0], 1000.0);
      below_ten += row[0] < 10.0 ? 1 : 0;
    }
    EXPECT_NEAR(static_cast<double>(below_ten) / static_cast<double>(plan.rows.size()), 0.5, 0.03);
  }
}

// A triangle wave spends as long at every value: the share below a quarter of the range is a quarter.
TEST(FastPlan, IsUniformAlongEveryCurve) {
  const SensitivityPlan plan = fastPlan(parameters(3, 0.0, 1.0), 1001, 2, 5);
  ASSERT_EQ(plan.rows.size(), 6006u);
  for (std::size_t block = 0; block < 6; ++block) {
    for (std::size_t i = 0; i < 3; ++i) {
      double below = 0.0;
      for (std::size_t j = 0; j < 1001; ++j) below += plan.rows[block * 1001 + j][i] < 0.25 ? 1.0 : 0.0;
      EXPECT_NEAR(below / 1001.0, 0.25, 0.02);
    }
  }
  EXPECT_EQ(plan.blockOf(1001), "x2");
  EXPECT_EQ(plan.blockOf(3003), "x1");
  EXPECT_EQ(plan.curveOf(3002), 1u);
  EXPECT_EQ(plan.curveOf(3003), 2u);
}

TEST(SensitivityPlan, RefusesRangesThatAreNone) {
  const auto message = [](std::vector<metrics::UncertainParameter> all) {
    return test_support::thrownMessage([&] { (void)sobolPlan(all, 8, 1); });
  };
  EXPECT_NE(message({{.name = "x", .min = 2.0, .max = 1.0}}).find("parameter 'x': has the range 2 to 1"),
            std::string::npos);
  EXPECT_NE(message({{.name = "x", .min = 1.0, .max = 1.0}}).find("has the range"), std::string::npos);
  EXPECT_NE(message({{.name = "x", .min = 0.0, .max = NAN}}).find("has the range"), std::string::npos);
  EXPECT_NE(message({{.name = "x", .min = 0.0, .max = 1.0, .logarithmic = true}}).find("logarithmic"),
            std::string::npos);
  EXPECT_NE(message({{.name = "x"}, {.name = "x"}}).find("twice"), std::string::npos);
  EXPECT_NE(message({{.name = "A"}}).find("name of a block"), std::string::npos);
  EXPECT_NE(message({}).find("0 parameters"), std::string::npos);
  EXPECT_THROW((void)sobolPlan(parameters(1, 0.0, 1.0), 1, 1), core::InputError);
  EXPECT_THROW((void)fastPlan(parameters(1, 0.0, 1.0), 64, 1, 1), core::InputError);
  EXPECT_THROW((void)fastPlan(parameters(1, 0.0, 1.0), 65, 0, 1), core::InputError);
}

}  // namespace
