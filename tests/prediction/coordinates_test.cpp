#include "prediction/coordinates.h"

#include <array>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <numbers>

#include "core/error.h"
#include "prediction/detection_quantities.h"
#include "tests/prediction/small_package.h"
#include "tests/support/thrown_message.h"

namespace {

using prediction::Coordinate;
using prediction::coordinatesFor;
using prediction::CoordinateSource;
using prediction::SamplePoints;
using testing::HasSubstr;
using Names = std::vector<std::string>;

class Coordinates : public testing::Test {
 protected:
  void SetUp() override {
    nlohmann::json json = test_prediction::emptyExperiment();
    test_prediction::addSample(folder_, json, "near", {{"range_m", 12.0}, {"tilt_deg", 5.0}}, "range_m\n");
    test_prediction::addSample(folder_, json, "far", {{"tilt_deg", 9.0}}, "range_m\n");
    json["samples"][1]["patch"] = {{{"op", "replace"}, {"path", "/environment/visibility_m"}, {"value", 50.0}}};
    experiment_ = model::parseExperiment(json, folder_ / "package/experiment.json");
  }
  CoordinateSource sourceOf(const std::string& parameter, const Names& chosen = {}) {
    return coordinatesFor(Names{parameter}, experiment_, chosen).front().source;
  }
  /// The coordinate of the second detection of a sample; NaN if it is not known.
  double second(const std::string& parameter, std::size_t sample, const Names& chosen = {}) {
    const auto coordinates = coordinatesFor(Names{parameter}, experiment_, chosen);
    const SamplePoints points(coordinates, experiment_, experiment_.samples[sample], detections_);
    std::array<double, 1> point{};
    return points.at(1, point) ? point[0] : std::nan("");
  }
  std::string refusal(const std::string& parameter, const Names& chosen = {}) {
    return test_support::thrownMessage([&] { (void)coordinatesFor(Names{parameter}, experiment_, chosen); });
  }

  test_support::TemporaryFolder folder_;
  model::Experiment experiment_;
  core::Detections detections_{.frame = {0, 1},
                               .layer = {2, 3},
                               .azimuth_rad = {0.0, std::numbers::pi / 6},
                               .elevation_rad = {0.0, 0.0},
                               .echo = {1, 2},
                               .range_m = {10.0, 20.0}};
};

TEST_F(Coordinates, SampleWinsOverDetectionAndDetectionOverEnvironment) {
  EXPECT_EQ(sourceOf("range_m"), CoordinateSource::Sample);
  EXPECT_EQ(sourceOf("layer"), CoordinateSource::Detection);
  EXPECT_EQ(sourceOf("visibility_m"), CoordinateSource::Environment);
  EXPECT_EQ(sourceOf("range_m", {"range_m=detection"}), CoordinateSource::Detection);
}

TEST_F(Coordinates, AreThoseOfTheSampleTheDetectionOrThePatchedEnvironment) {
  EXPECT_EQ(second("range_m", 0), 12.0);
  EXPECT_EQ(second("range_m", 0, {"range_m=detection"}), 20.0);
  EXPECT_EQ(second("distance", 0, {"distance=detection:range_m"}), 20.0);
  EXPECT_EQ(second("layer", 0), 3.0);
  EXPECT_EQ(second("echo", 0), 2.0);
  EXPECT_NEAR(second("azimuth_deg", 0), 30.0, 1e-12);
  EXPECT_EQ(second("visibility_m", 0), 200.0);
  EXPECT_EQ(second("visibility_m", 1), 50.0);
}

// The second sample has no range of its own: the range of its detections is something else and is not taken.
TEST_F(Coordinates, WhatNobodyRecordedIsUnknownAndNotFilledInFromElsewhere) {
  EXPECT_TRUE(std::isnan(second("range_m", 1)));
  EXPECT_TRUE(std::isnan(second("temperature_degC", 0)));
  EXPECT_TRUE(std::isnan(second("rain_rate_mm_h", 0)));
  EXPECT_TRUE(std::isnan(second("intensity", 0)));
}

TEST_F(Coordinates, UnknownNameIsToldWithTheNearestAndAllThatThereAre) {
  const std::string message = refusal("tilt_degr");
  EXPECT_THAT(message, HasSubstr("'tilt_degr'"));
  EXPECT_THAT(message, HasSubstr("samples name range_m, tilt_deg; detections have range_m, azimuth_deg"));
  EXPECT_THAT(message, HasSubstr("the environment has temperature_degC, visibility_m"));
  EXPECT_THAT(message, HasSubstr("--coordinate tilt_degr=sample:tilt_deg"));
  EXPECT_THAT(refusal("incidence_deg"), HasSubstr("'incidence_deg'"));
}

TEST_F(Coordinates, ChoiceThatIsNoneIsRefused) {
  EXPECT_THAT(refusal("range_m", {"range_m"}), HasSubstr("Write range_m=detection"));
  EXPECT_THAT(refusal("range_m", {"rang_m=detection"}), HasSubstr("Did you mean 'range_m'?"));
  EXPECT_THAT(refusal("range_m", {"range_m=detections"}), HasSubstr("Did you mean 'detection'?"));
  EXPECT_THAT(refusal("range_m", {"range_m=environment"}), HasSubstr("no environment has 'range_m'"));
}

TEST(DetectionQuantities, EveryOneIsReadFromACompleteDetection) {
  const core::Detections one{.frame = {1},
                             .time_s = {2},
                             .layer = {3},
                             .azimuth_rad = {4},
                             .elevation_rad = {5},
                             .echo = {6},
                             .range_m = {7},
                             .epw_m = {8},
                             .intensity = {9}};
  for (const std::string& quantity : prediction::detectionQuantities()) {
    EXPECT_TRUE(prediction::valuesOf(one, quantity)) << quantity;
  }
  EXPECT_FALSE(prediction::valuesOf(core::Detections{.frame = {1}, .echo = {1}, .range_m = {7}}, "azimuth_deg"));
}

}  // namespace
