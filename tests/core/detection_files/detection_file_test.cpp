#include "core/detection_files/detection_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/detection_files/detection_format.h"
#include "core/file.h"
#include "tests/core/detection_files/made_up.h"
#include "tests/support/paths.h"
#include "tests/support/thrown_message.h"

namespace core {
namespace {

using core_test::expectSame;
using core_test::madeUpDetections;
using ::testing::HasSubstr;

const char* const kEndings[] = {".csv", ".pcd", ".ply", ".osi"};

TEST(DetectionFile, PointCloudsKeepEveryBitInEveryEncoding) {
  const test_support::TemporaryFolder folder;
  const Detections detections = madeUpDetections();
  for (const DetectionFormat& format : detectionFormats()) {
    for (const std::string& encoding : format.encodings) {
      SCOPED_TRACE(format.name + " " + encoding);
      writeDetections(folder / ("d" + format.endings.front()), detections, encoding);
      expectSame(readDetections(folder / ("d" + format.endings.front())), detections);
    }
  }
}

// CSV rounds to 0.1 mm and a microradian; OSI has neither layers nor times of single detections.
TEST(DetectionFile, CsvAndOsiKeepWhatTheyCanHold) {
  const test_support::TemporaryFolder folder;
  const Detections detections = madeUpDetections();
  writeDetections(folder / "d.csv", detections);
  const Detections csv = readDetections(folder / "d.csv");
  EXPECT_EQ(csv.layer, detections.layer);
  EXPECT_EQ(csv.echo, detections.echo);
  for (std::size_t i = 0; i < detections.size(); ++i) {
    EXPECT_NEAR(csv.range_m[i], detections.range_m[i], 0.5001e-4);
    EXPECT_NEAR(csv.azimuth_rad[i], detections.azimuth_rad[i], 0.5001e-6);
  }
  writeDetections(folder / "d.osi", detections);
  Detections known = detections;
  known.layer.clear();
  known.time_s.clear();
  expectSame(readDetections(folder / "d.osi"), known);
}

TEST(DetectionFile, NoDetectionsAreASampleToo) {
  const test_support::TemporaryFolder folder;
  for (const char* ending : kEndings) {
    writeDetections(folder / (std::string("none") + ending), {});
    EXPECT_EQ(readDetections(folder / (std::string("none") + ending)).size(), 0u) << ending;
  }
  writeDetections(folder / "none.pcd", {}, "binary_compressed");
  EXPECT_EQ(readDetections(folder / "none.pcd").size(), 0u);
}

// Without these columns a reader would take the sample as one whose directions were not recorded, and a total loss
// would be no gap (formats.md section 1).
TEST(DetectionFile, ACsvWithoutDetectionsStillHasAllColumns) {
  const test_support::TemporaryFolder folder;
  writeDetections(folder / "d.csv", {});
  EXPECT_EQ(readFile(folder / "d.csv"), "frame,time_s,layer,azimuth_rad,elevation_rad,echo,range_m,epw_m,intensity\n");
}

TEST(DetectionFile, TheContentTellsTheFormatWhateverTheName) {
  const test_support::TemporaryFolder folder;
  const Detections detections = madeUpDetections();
  for (const char* true_ending : kEndings) {
    writeDetections(folder / (std::string("d") + true_ending), detections);
    for (const char* name : {"x.csv", "x.pcd", "x.ply", "x.osi", "x.dat", "x"}) {
      core::writeFile(folder / name, core::readFile(folder / (std::string("d") + true_ending)));
      EXPECT_EQ(readDetections(folder / name).size(), detections.size()) << true_ending << " as " << name;
    }
  }
}

TEST(DetectionFile, AnyFormatMayBeGzipped) {
  const test_support::TemporaryFolder folder;
  for (const char* ending : kEndings) {
    const std::string name = std::string("d") + ending + ".gz";
    writeDetections(folder / name, madeUpDetections());
    EXPECT_EQ(readDetections(folder / name).size(), 200u) << name;
  }
}

TEST(DetectionFile, RangesWithoutDirectionsStayRanges) {
  const test_support::TemporaryFolder folder;
  Detections ranges;
  ranges.frame = {0, 1};
  ranges.echo = {1, 1};
  ranges.range_m = {4.5, 4.75};
  for (const char* ending : {".csv", ".pcd", ".ply"}) {
    writeDetections(folder / (std::string("r") + ending), ranges);
    const Detections again = readDetections(folder / (std::string("r") + ending));
    EXPECT_FALSE(again.hasDirections()) << ending;
    EXPECT_EQ(again.range_m, ranges.range_m) << ending;
  }
  EXPECT_THAT(test_support::thrownMessage([&] { writeDetections(folder / "r.osi", ranges); }),
              HasSubstr("no directions"));
  EXPECT_FALSE(std::filesystem::exists(folder / "r.osi"));
}

TEST(DetectionFile, WhatAFormatCannotDoIsSaidWithTheFile) {
  const test_support::TemporaryFolder folder;
  Detections points = madeUpDetections();
  points.layer.clear();
  EXPECT_THAT(test_support::thrownMessage([&] { writeDetections(folder / "p.csv", points); }),
              AllOf(HasSubstr("p.csv"), HasSubstr("no layer")));
  EXPECT_THAT(test_support::thrownMessage([&] { writeDetections(folder / "p.ply", points, "binary"); }),
              AllOf(HasSubstr("'binary' is no encoding"), HasSubstr("binary_little_endian")));
  core::writeFile(folder / "cloud.las", "LASF and more");
  EXPECT_THAT(test_support::thrownMessage([&] { (void)readDetections(folder / "cloud.las"); }), HasSubstr("LAS"));
}

}  // namespace
}  // namespace core
