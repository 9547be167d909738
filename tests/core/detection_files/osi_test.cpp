#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/detection_files/detection_file.h"
#include "core/detection_files/lidar_view.h"
#include "core/file.h"
#include "core/physics.h"
#include "tests/core/detection_files/made_up.h"
#include "tests/support/paths.h"
#include "tests/support/thrown_message.h"

// The traces of tests/data/detection_files are written by write_files.py there, byte by byte from the standard's field
// numbers, without protobuf.
namespace core {
namespace {

using ::testing::HasSubstr;

std::filesystem::path file(const std::string& name) { return test_support::testData("detection_files/" + name); }

std::string errorOf(const std::filesystem::path& path) {
  return test_support::thrownMessage([&] { (void)readDetections(path); });
}

TEST(OsiDetections, AreReadByTheFieldNumbersOfTheStandard) {
  const Detections d = readDetections(file("detections.osi"));
  ASSERT_EQ(d.size(), 4u);  // one more is classified invalid
  EXPECT_EQ(d.frame, (std::vector<std::int32_t>{0, 0, 2, 2}));
  EXPECT_EQ(d.echo, (std::vector<std::int32_t>{2, 1, 1, 1}));  // the first lies behind the second, in its direction
  EXPECT_EQ(d.range_m, (std::vector<double>{10, 5, 2, 3}));
  EXPECT_EQ(d.azimuth_rad[1], std::atan2(4.0, 3.0));
  EXPECT_EQ(d.elevation_rad[3], std::atan2(2.0, std::hypot(1.0, 2.0)));
  EXPECT_EQ(d.epw_m, (std::vector<double>{0.75, 0.5, 0.25, 0.125}));
  EXPECT_EQ(d.intensity, (std::vector<double>{14, 11, 12, 13}));
  EXPECT_TRUE(d.layer.empty());
}

TEST(OsiDetections, WrongVersionIsSaidWithTheMessage) {
  EXPECT_THAT(errorOf(file("version_2.osi")), AllOf(HasSubstr("message 1 (byte 0)"), HasSubstr("version 2")));
  EXPECT_THAT(errorOf(file("no_version.osi")),
              AllOf(HasSubstr("message 1 (byte 0)"), HasSubstr("no interface version")));
}

TEST(OsiDetections, EveryTruncationIsSaid) {
  const std::string whole = readFile(file("detections.osi"));
  std::size_t at = 0, messages = 0;
  for (std::size_t length = 0; length < whole.size(); ++length) {
    const std::string message = core_test::errorOfBytes("osi", whole.substr(0, length));
    std::size_t size = 0;
    for (std::size_t k = 0; k < 4; ++k) size |= std::size_t{static_cast<unsigned char>(whole[at + k])} << (8 * k);
    if (length == at + 4 + size) {  // whole messages are a trace
      EXPECT_EQ(message, "");
      at = length, ++messages;
    } else {
      ASSERT_THAT(message, HasSubstr(length == 0 ? "empty" : "message " + std::to_string(messages + 1)));
    }
  }
  EXPECT_EQ(messages, 2u);
}

TEST(OsiDetections, EveryFlippedByteIsReadOrSaid) {
  const std::string whole = readFile(file("detections.osi"));
  for (std::size_t i = 0; i < whole.size(); ++i) {
    std::string damaged = whole;
    damaged[i] = static_cast<char>(damaged[i] ^ 0x55);
    EXPECT_NO_FATAL_FAILURE((void)core_test::errorOfBytes("osi", damaged));
  }
}

TEST(OsiDetections, WrongLengthIsSaidWithItsPlace) {
  const test_support::TemporaryFolder folder;
  std::string trace = readFile(file("version_2.osi"));
  trace += std::string("\xff\xff\xff\x7f", 4);
  EXPECT_THAT(errorOf(folder.write("a.osi", trace)),
              AllOf(HasSubstr("message 2 (byte 96)"), HasSubstr("2147483647 bytes")));
  EXPECT_THAT(errorOf(folder.write("zero.osi", std::string(4, '\0'))), HasSubstr("length 0"));
}

TEST(OsiReflections, AreReadByTheFieldNumbersOfTheStandard) {
  const std::vector<LidarSensorView> views = readLidarSensorViews(file("reflections.osi"));
  ASSERT_EQ(views.size(), 2u);
  EXPECT_EQ(views[0].time_s, 2.5);
  EXPECT_EQ(views[0].emitter_frequency_hz, 3.3e14);
  ASSERT_EQ(views[0].reflections.size(), 2u);  // the ray between them hit nothing
  const LidarReflection& first = views[0].reflections[0];
  EXPECT_NEAR(views[0].directions[first.ray][0], 0.6, 1e-15);
  EXPECT_NEAR(views[0].directions[first.ray][1], 0.8, 1e-15);
  EXPECT_EQ(views[0].directions.size(), 3u);
  EXPECT_EQ(views[0].reflections[1].ray, 2u);
  EXPECT_EQ(first.signal_strength_db, -80.5);
  EXPECT_NEAR(first.time_of_flight_s * kSpeedOfLight_m_s / 2, 5.0, 1e-12);
  EXPECT_EQ(first.doppler_shift_hz, -4.0);
  EXPECT_EQ(*first.surface_normal, (std::array<double, 3>{-1, 0, 0}));
  EXPECT_EQ(*first.object, ~std::uint64_t{0});
  ASSERT_EQ(views[1].reflections.size(), 1u);  // directions of the first message hold on
  EXPECT_NEAR(views[1].directions[views[1].reflections[0].ray][2], 2.0 / 3.0, 1e-15);
}

TEST(OsiReflections, RoundTripAndPoints) {
  const test_support::TemporaryFolder folder;
  const std::vector<LidarSensorView> views = readLidarSensorViews(file("reflections.osi"));
  writeLidarSensorViews(folder / "again.osi", views);
  const std::vector<LidarSensorView> again = readLidarSensorViews(folder / "again.osi");
  ASSERT_EQ(again.size(), views.size());
  for (std::size_t v = 0; v < views.size(); ++v) {
    EXPECT_EQ(again[v].time_s, views[v].time_s);
    EXPECT_EQ(again[v].emitter_frequency_hz, views[v].emitter_frequency_hz);
    EXPECT_EQ(again[v].directions.size(), views[v].directions.size());  // of rays that met nothing, too
    ASSERT_EQ(again[v].reflections.size(), views[v].reflections.size());
    for (std::size_t i = 0; i < views[v].reflections.size(); ++i) {
      EXPECT_EQ(again[v].reflections[i].ray, views[v].reflections[i].ray);
      EXPECT_EQ(again[v].reflections[i].signal_strength_db, views[v].reflections[i].signal_strength_db);
      EXPECT_EQ(again[v].reflections[i].time_of_flight_s, views[v].reflections[i].time_of_flight_s);
      EXPECT_EQ(again[v].reflections[i].object, views[v].reflections[i].object);
      EXPECT_EQ(again[v].reflections[i].surface_normal, views[v].reflections[i].surface_normal);
    }
  }
  const Detections points = pointsOf(views);
  ASSERT_EQ(points.size(), 3u);
  EXPECT_NEAR(points.range_m[1], 3.0, 1e-12);
  EXPECT_NEAR(points.elevation_rad[1], std::asin(2.0 / 3.0), 1e-12);
  EXPECT_EQ(points.frame, (std::vector<std::int32_t>{0, 0, 1}));
}

TEST(OsiReflections, AreNotTakenForDetectionsNorTheOtherWayRound) {
  EXPECT_THAT(errorOf(file("reflections.osi")), AllOf(HasSubstr("reflections"), HasSubstr("--reflections")));
  EXPECT_THAT(test_support::thrownMessage([&] { (void)readLidarSensorViews(file("detections.osi")); }),
              HasSubstr("SensorData"));
}

TEST(OsiReflections, WithoutDirectionsAreRefused) {
  const test_support::TemporaryFolder folder;
  std::string trace = readFile(file("reflections.osi"));
  const std::size_t first = 4 + static_cast<unsigned char>(trace[0]) + 256 * static_cast<unsigned char>(trace[1]);
  EXPECT_THAT(
      test_support::thrownMessage([&] { (void)readLidarSensorViews(folder.write("late.osi", trace.substr(first))); }),
      AllOf(HasSubstr("message 1"), HasSubstr("3 reflections and 0 directions")));
}

// Recorded views of environment simulations: nothing of a lidar in them.
TEST(OsiShared, TracesWithoutLidarSaySo) {
  FIDELIS_NEEDS_SHARED(shared);
  const struct {
    const char* name;
    const char* messages;
  } traces[] = {{"openmaterial3d_sv_360_two_vehicles", "140 SensorView"},
                {"openmsl_sl13_sv_340_300", "150 SensorView"},
                {"openmsl_sv_350_100", "100 SensorView"},
                {"osi_validation_minimal_valid", "20 SensorView"},
                {"qc_invalid_version", "547 SensorView"}};
  for (const auto& trace : traces) {
    const auto path = shared / "data/formats/osi" / (std::string(trace.name) + ".osi");
    EXPECT_THAT(errorOf(path), AllOf(HasSubstr("no lidar inside"), HasSubstr(trace.messages)));
    EXPECT_THAT(test_support::thrownMessage([&] { (void)readLidarSensorViews(path); }), HasSubstr("no lidar inside"));
  }
  const auto invalid = shared / "data/formats/osi/qc_invalid_version.osi";
  EXPECT_THAT(errorOf(invalid), HasSubstr("Message 1 has no interface version"));
}

}  // namespace
}  // namespace core
