#include "gap/where.h"

#include <gtest/gtest.h>

#include "gap/wording.h"

namespace {

gap::ResidualTable tableOf(const std::vector<double>& values, double error) {
  gap::ResidualTable table{"epw", "bias", "m", 0.04, {}};
  for (std::size_t i = 0; i < values.size(); ++i) table.rows.push_back({0, i, values[i], error, 10.0});
  return table;
}

TEST(Where, ExcessIsZeroWhereResidualsAreNoLargerThanTheirErrors) {
  EXPECT_EQ(tableOf({0.01, -0.012, 0.008}, 0.01).excess(), 0.0);
}

// sqrt(0.05² - (2·0.015)²) = 0.04: one step of 0.04 m in half of the rows.
TEST(Where, ExcessCountsWhatTheErrorLeavesInStepsOfTheResolution) {
  EXPECT_NEAR(tableOf({0.05, 0.0}, 0.015).excess(), 0.5, 1e-12);
}

TEST(Wording, StratumSentenceSaysWhatIsLargerAndWhere) {
  gap::WhereRow row{.measurand = "epw",
                    .component = "bias",
                    .covariate = "range_m",
                    .low = 28.1,
                    .high = 69.0,
                    .value = -0.27,
                    .unit = "m",
                    .share = 0.62,
                    .size = 0.4};
  EXPECT_EQ(
      gap::whereSentence(row),
      "The simulated echo pulse width is 0.27 m too large at ranges from 28.1 to 69 m: 62 % of this gap, in 40 % of "
      "the data.");
}

TEST(Wording, OneEchoIsNotSeveral) {
  gap::WhereRow row{.measurand = "existence",
                    .component = "missing",
                    .covariate = "range_m",
                    .low = 30.0,
                    .high = 60.0,
                    .value = -1.0,
                    .unit = "1/shot"};
  EXPECT_NE(gap::whereSentence(row).find("lacks 1 echo per shot"), std::string::npos);
  row.value = -0.5;
  EXPECT_NE(gap::whereSentence(row).find("lacks 0.5 echoes per shot"), std::string::npos);
  EXPECT_EQ(gap::withUnit(-1.0, "1/shot"), "-1 echo per shot");
  EXPECT_EQ(gap::withUnit(0.5, "1/shot"), "0.5 echoes per shot");
}

}  // namespace
