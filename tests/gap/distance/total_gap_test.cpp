#include "gap/distance/total_gap.h"

#include <gtest/gtest.h>

namespace {

const std::vector<model::Measurand> kRange = {{"range", "range_m", "m", "ratio", 0.01}};

core::Detections detections(const std::vector<double>& ranges_m, const std::vector<double>& azimuths_rad) {
  core::Detections result;
  for (std::size_t i = 0; i < ranges_m.size(); ++i) {
    result.frame.push_back(static_cast<int>(i) % 2);
    result.layer.push_back(0);
    result.azimuth_rad.push_back(azimuths_rad[i]);
    result.elevation_rad.push_back(0.0);
    result.echo.push_back(1);
    result.range_m.push_back(ranges_m[i]);
  }
  return result;
}

// A simulation that is the measurement plus b has bias b and no scatter: b / resolution steps in all.
TEST(TotalGap, PureOffsetCountsInStepsOfTheResolution) {
  const std::vector<double> azimuths = {0.01, 0.01, 0.05, 0.05};
  const auto measured = detections({10.0, 10.1, 10.2, 10.4}, azimuths);
  const auto simulated = detections({10.05, 10.15, 10.25, 10.45}, azimuths);
  const gap::TotalGap gap = gap::totalGap(kRange, measured, simulated, 2);
  ASSERT_EQ(gap.measurands.size(), 1U);
  EXPECT_NEAR(gap.measurands[0].d_bias, 0.05, 1e-12);  // positive: the simulation is too high
  EXPECT_NEAR(gap.measurands[0].d_cavm, 0.0, 1e-12);
  EXPECT_NEAR(gap.total, 5.0, 1e-9);
}

// Four echoes simulated per two frames, one of them in a cell where nothing was measured, and one measured elsewhere:
// missing 1/4, extra 1/4 of all simulated.
TEST(TotalGap, ExistenceCountsCellsOfTwoDegrees) {
  const auto measured = detections({10, 10, 10, 10}, {0.001, 0.001, 0.001, 0.5});
  const auto simulated = detections({10, 10, 10, 10}, {0.001, 0.001, 0.001, -0.5});
  const gap::TotalGap gap = gap::totalGap(kRange, measured, simulated, 2);
  EXPECT_NEAR(gap.missing_fraction, 0.25, 1e-12);
  EXPECT_NEAR(gap.extra_fraction, 0.25, 1e-12);
  EXPECT_NEAR(gap.total, 50.0, 1e-9);
}

// -30° is a border of cells; a file that holds it to six decimals must not fall into the neighbour.
TEST(TotalGap, AzimuthsRoundedInFilesStayInTheirCell) {
  const auto measured = detections({10, 10}, {-0.523599, -0.523599});
  const auto simulated = detections({10, 10}, {-0.52359877559829887, -0.52359877559829887});
  EXPECT_EQ(gap::totalGap(kRange, measured, simulated, 2).missing_fraction, 0.0);
}

TEST(TotalGap, MeanKeepsTheSignOfTheBias) {
  gap::TotalGap a, b;
  a.measurands = {{"range", "m", 0.03, 0.01, 0.01}};
  b.measurands = {{"range", "m", -0.01, 0.03, 0.01}};
  a.total = 4.0;
  b.total = 4.0;
  const gap::TotalGap mean = gap::meanOf({a, b});
  EXPECT_NEAR(mean.measurands[0].d_bias, 0.01, 1e-15);
  EXPECT_NEAR(mean.measurands[0].d_cavm, 0.02, 1e-15);
  EXPECT_NEAR(mean.total, 4.0, 1e-15);
}

}  // namespace
