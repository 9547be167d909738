#include "tests/core/detection_files/made_up.h"

#include <cmath>
#include <gtest/gtest.h>

#include "core/detection_files/detection_format.h"
#include "tests/support/thrown_message.h"

namespace core_test {

core::Detections madeUpDetections() {
  core::Detections d;
  for (int i = 0; i < 200; ++i) {
    d.frame.push_back(i / 80);
    d.time_s.push_back(1e-4 * (i % 80) / 3.0);
    d.layer.push_back(i % 4);
    d.azimuth_rad.push_back(std::sin(0.1 * (i / 2)));
    d.elevation_rad.push_back(-0.02 + 0.0137 * (i % 4 / 2));
    d.echo.push_back(1 + i % 2);
    d.range_m.push_back(3.0 + std::sqrt(static_cast<double>(i)) + 20.0 * (i % 2));
    d.epw_m.push_back(0.4 + 0.1 * std::cos(i));
    d.intensity.push_back(100.0 / (1.0 + i));
  }
  return d;
}

void expectSame(const core::Detections& a, const core::Detections& b) {
  for (const core::DetectionColumn& column : core::detectionColumns()) {
    if (column.real) {
      EXPECT_EQ(a.*column.real, b.*column.real) << column.name;
    } else {
      EXPECT_EQ(a.*column.whole, b.*column.whole) << column.name;
    }
  }
}

void expectThePoints(const core::Detections& d) {
  constexpr double kRounding = 1e-12;
  ASSERT_EQ(d.size(), 3u);
  EXPECT_NEAR(d.range_m[0], 5.0, kRounding);
  EXPECT_NEAR(d.range_m[1], 2.0, kRounding);
  EXPECT_NEAR(d.range_m[2], 3.0, kRounding);
  EXPECT_NEAR(d.azimuth_rad[0], std::atan2(4.0, 3.0), kRounding);
  EXPECT_NEAR(d.azimuth_rad[1], -std::acos(0.0), kRounding);
  EXPECT_NEAR(d.azimuth_rad[2], std::atan2(2.0, 1.0), kRounding);
  EXPECT_NEAR(d.elevation_rad[0], 0.0, kRounding);
  EXPECT_NEAR(d.elevation_rad[2], std::asin(2.0 / 3.0), kRounding);
  EXPECT_EQ(d.epw_m, (std::vector<double>{0.5, 0.25, 0.125}));
  EXPECT_EQ(d.intensity, (std::vector<double>{11, 12, 13}));
}

std::string errorOfBytes(const std::string& format, const std::string& content) {
  for (const core::DetectionFormat& candidate : core::detectionFormats()) {
    if (candidate.name != format) continue;
    return test_support::thrownMessage(
        [&] { (void)candidate.read({.file = "damaged." + format, .content = content, .columns = {}}); });
  }
  return "no format " + format;
}

}  // namespace core_test
