#include "metrics/validity/tolerance_check.h"

#include <cmath>
#include <gtest/gtest.h>

#include "core/error.h"
#include "tests/support/thrown_message.h"

namespace {

using metrics::checkTolerance;
using metrics::Tolerance;
using metrics::ToleranceBand;
using metrics::toleranceBand;
using metrics::ToleranceCheck;
using Curve = std::vector<double>;
using Curves = std::vector<Curve>;

const Curve kParameter{10.0, 20.0, 30.0};

// Means 2, 4, -10; deviations 1, 0, 2 (of 1, 2, 3 and so on).
const Curves kRepetitions{{1.0, 4.0, -12.0}, {2.0, 4.0, -10.0}, {3.0, 4.0, -8.0}};

TEST(ToleranceBand, IsMeanAndDeviationsAndFixedAndRelativePart) {
  const ToleranceBand band =
      toleranceBand(kParameter, kRepetitions, {.deviations = 2.0, .absolute = 0.5, .relative = 0.1});
  const Curve half{2.0 + 0.5 + 0.2, 0.0 + 0.5 + 0.4, 4.0 + 0.5 + 1.0};
  const Curve mean{2.0, 4.0, -10.0};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(band.low[i], mean[i] - half[i], 1e-14);
    EXPECT_NEAR(band.high[i], mean[i] + half[i], 1e-14);
  }
}

TEST(ToleranceCheck, CountsTheBoundsAsInside) {
  const ToleranceBand band = toleranceBand(kParameter, Curves{{1.0, 2.0, 3.0}}, {.absolute = 0.5});
  EXPECT_TRUE(checkTolerance(band, Curve{1.5, 1.5, 3.5}).passed());
  EXPECT_EQ(checkTolerance(band, Curve{1.5, 1.5, 3.5}).share_inside, 1.0);
}

TEST(ToleranceCheck, NamesTheFirstAndTheWorstViolation) {
  const ToleranceBand band = toleranceBand(kParameter, Curves{{1.0, 2.0, 3.0}}, {.absolute = 0.5});
  const ToleranceCheck check = checkTolerance(band, Curve{1.0, 2.75, 0.5});
  EXPECT_FALSE(check.passed());
  EXPECT_NEAR(check.share_inside, 1.0 / 3.0, 1e-15);
  EXPECT_EQ(check.first->index, 1u);
  EXPECT_EQ(check.first->parameter, 20.0);
  EXPECT_DOUBLE_EQ(check.first->excess, 0.25);
  EXPECT_EQ(check.worst->index, 2u);
  EXPECT_DOUBLE_EQ(check.worst->excess, -2.0);
}

TEST(ToleranceCheck, NeverGetsWorseWithMoreTolerance) {
  const Curve curve{3.1, 3.2, -7.0};
  double before = 0.0;
  for (const double k : {0.0, 0.5, 1.0, 2.0, 4.0}) {
    const double share =
        checkTolerance(toleranceBand(kParameter, kRepetitions, {.deviations = k, .absolute = 0.2 * k}), curve)
            .share_inside;
    EXPECT_GE(share, before);
    before = share;
  }
  EXPECT_EQ(before, 1.0);
}

TEST(ToleranceBand, SaysWhichCurveIsWrong) {
  const auto message = [](const Curve& parameter, const Curves& curves, const Tolerance& tolerance) {
    return test_support::thrownMessage([&] { (void)toleranceBand(parameter, curves, tolerance); });
  };
  EXPECT_NE(message(kParameter, {{1.0, 2.0}}, {}).find("curve 1: has 2 values for 3"), std::string::npos);
  EXPECT_NE(message(kParameter, {{1.0, 2.0, 3.0}, {1.0, NAN, 3.0}}, {}).find("curve 2, value 2"), std::string::npos);
  EXPECT_NE(message({1.0, 1.0}, {{1.0, 2.0}}, {}).find("parameter, value 2"), std::string::npos);
  EXPECT_NE(message({1.0}, {{1.0}}, {.deviations = 1.0}).find("single curve"), std::string::npos);
  EXPECT_NE(message({1.0}, {{1.0}}, {.absolute = -1.0}).find("must not be negative"), std::string::npos);
  EXPECT_NE(message({}, {{}}, {}).find("at least"), std::string::npos);
  const ToleranceBand band = toleranceBand(kParameter, kRepetitions, {});
  EXPECT_THROW((void)checkTolerance(band, Curve{1.0}), core::InputError);
}

}  // namespace
