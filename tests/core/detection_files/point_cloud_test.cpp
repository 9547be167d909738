#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/detection_files/detection_file.h"
#include "core/file.h"
#include "tests/core/detection_files/made_up.h"
#include "tests/support/paths.h"
#include "tests/support/thrown_message.h"

// The files of tests/data/detection_files are written by write_files.py there, from the formats' descriptions.
namespace core {
namespace {

using ::testing::HasSubstr;

std::filesystem::path file(const std::string& name) { return test_support::testData("detection_files/" + name); }

std::string errorOf(const std::filesystem::path& path) {
  return test_support::thrownMessage([&] { (void)readDetections(path); });
}

/// What is said of a file with this content.
std::string errorOf(const std::string& name, const std::string& content) {
  const test_support::TemporaryFolder folder;
  return errorOf(folder.write(name, content));
}

std::string pcd(const std::string& fields, const std::string& rows, int points = 1) {
  std::string sizes, types;
  for (const char c : fields + " ") {
    if (c == ' ') sizes += " 4", types += " F";
  }
  return "VERSION 0.7\nFIELDS " + fields + "\nSIZE" + sizes + "\nTYPE" + types + "\nWIDTH " + std::to_string(points) +
         "\nHEIGHT 1\nPOINTS " + std::to_string(points) + "\nDATA ascii\n" + rows;
}

TEST(Pcd, ReadsWhatOthersWroteInAllThreeEncodings) {
  for (const char* name : {"ascii.pcd", "binary.pcd", "compressed.pcd"}) {
    SCOPED_TRACE(name);
    const Detections detections = readDetections(file(name));
    core_test::expectThePoints(detections);
    EXPECT_EQ(detections.layer, (std::vector<std::int32_t>{7, 1, 3}));  // the field is named ring
    EXPECT_EQ(detections.echo, (std::vector<std::int32_t>{1, 1, 1}));
    EXPECT_TRUE(detections.time_s.empty());
  }
}

TEST(Ply, ReadsWhatOthersWroteInAllThreeEncodings) {
  for (const char* name : {"ascii.ply", "little.ply", "big.ply"}) {
    SCOPED_TRACE(name);
    const Detections detections = readDetections(file(name));
    core_test::expectThePoints(detections);
    EXPECT_EQ(detections.layer, (std::vector<std::int32_t>{7, 1, 3}));
  }
}

// At every length that is too short there must be a message, never a crash or fewer points.
TEST(PointCloud, EveryTruncationIsSaid) {
  for (const char* name : {"ascii.pcd", "binary.pcd", "compressed.pcd", "ascii.ply", "little.ply", "big.ply"}) {
    const std::string whole = readFile(file(name));
    const bool ply = std::string(name).ends_with("ply");
    // In ascii a number may lose its last digit or line end, and a PLY's faces may be missing, unseen.
    const bool ascii = std::string(name).starts_with("ascii");
    const std::size_t unseen = ply ? 13 : 0;
    for (std::size_t length = 0; length + unseen + (ascii ? 10 : 0) < whole.size(); ++length) {
      const std::string message = core_test::errorOfBytes(ply ? "ply" : "pcd", whole.substr(0, length));
      ASSERT_THAT(message, HasSubstr("damaged.")) << name << ", " << length << " of " << whole.size();
    }
  }
}

TEST(PointCloud, EveryFlippedByteIsReadOrSaid) {
  for (const char* name : {"ascii.pcd", "binary.pcd", "compressed.pcd", "ascii.ply", "little.ply", "big.ply"}) {
    const std::string whole = readFile(file(name));
    for (std::size_t i = 0; i < whole.size(); ++i) {
      std::string damaged = whole;
      damaged[i] = static_cast<char>(damaged[i] ^ 0x55);
      EXPECT_NO_FATAL_FAILURE(
          (void)core_test::errorOfBytes(std::string(name).ends_with("ply") ? "ply" : "pcd", damaged));
    }
  }
}

TEST(Pcd, ErrorsNamePlaceAndRemedy) {
  EXPECT_THAT(errorOf("a.pcd", pcd("y z", "1 2\n")), HasSubstr("no field 'x'"));
  EXPECT_THAT(errorOf("a.pcd", pcd("x y z", "1 nan 3\n")), AllOf(HasSubstr("a.pcd:9"), HasSubstr("field 'y'")));
  EXPECT_THAT(errorOf("a.pcd", pcd("x y z", "1 2\n")), AllOf(HasSubstr("a.pcd:9"), HasSubstr("2 numbers")));
  EXPECT_THAT(errorOf("a.pcd", pcd("x y z", "1 2 three\n")), AllOf(HasSubstr("a.pcd:9"), HasSubstr("'three'")));
  EXPECT_THAT(errorOf("a.pcd", pcd("x y z", "1 2 3\n", 2)), HasSubstr("1 of 2 points"));
  EXPECT_THAT(errorOf("a.pcd", pcd("x y z", "1 2 3\n", 2'000'000'000)), HasSubstr("announces 2000000000 points"));
  EXPECT_THAT(errorOf("a.pcd", pcd("x y z ring", "1 2 3 0.5\n")), HasSubstr("whole number"));
  EXPECT_THAT(errorOf("a.pcd", pcd("range_m azimuth_rad", "1 2\n")), HasSubstr("only some of the fields"));
  std::string other = pcd("x y z", "");
  other.replace(other.find("DATA ascii"), 10, "DATA zstd ");
  EXPECT_THAT(errorOf("a.pcd", other), AllOf(HasSubstr("a.pcd:8"), HasSubstr("'zstd'"), HasSubstr("compression")));
  other = pcd("x y z", "1 2 3\n");
  other.insert(other.find("POINTS"), "VIEWPOINT 0 0 1.5 1 0 0 0\n");
  EXPECT_THAT(errorOf("a.pcd", other), AllOf(HasSubstr("a.pcd:7"), HasSubstr("VIEWPOINT")));
  EXPECT_THAT(errorOf("a.pcd", "VERSION 0.7\nDATA ascii\n"), HasSubstr("no line FIELDS"));
}

TEST(Ply, ErrorsNamePlaceAndRemedy) {
  EXPECT_THAT(errorOf("a.ply", "ply\nformat ascii 1.0\nelement face 0\nproperty int a\nend_header\n"),
              HasSubstr("has no points"));
  EXPECT_THAT(errorOf("a.ply", "ply\nformat packed 1.0\nend_header\n"), HasSubstr("a.ply:2"));
  const std::string head = "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n";
  EXPECT_THAT(errorOf("a.ply", head + "end_header\n1 2\n"), HasSubstr("no field 'z'"));
  EXPECT_THAT(errorOf("a.ply", head + "property float z\nend_header\n1 2 inf\n"),
              AllOf(HasSubstr("a.ply:8"), HasSubstr("field 'z'")));
  EXPECT_THAT(errorOf("a.ply", head + "property half z\nend_header\n1 2 3\n"),
              AllOf(HasSubstr("a.ply:6"), HasSubstr("'half'")));
  std::string records = readFile(file("little.ply"));
  records.replace(records.find("end_header\n") + 11 + 13, 4, std::string("\0\0\xc0\x7f", 4));  // x of the first point
  EXPECT_THAT(errorOf("a.ply", records), AllOf(HasSubstr("point 1 (byte"), HasSubstr("field 'x'")));
}

TEST(PointCloud, FieldsCanBeMappedAndOursWin) {
  const test_support::TemporaryFolder folder;
  const auto mapped = folder.write("a.pcd", pcd("x y z amplitude range_m", "3 4 0 17 5.5\n"));
  const Detections detections = readDetections(mapped, {{"intensity", "amplitude"}});
  EXPECT_EQ(detections.intensity, std::vector<double>{17});
  EXPECT_EQ(detections.range_m, std::vector<double>{5.5});
  EXPECT_THAT(test_support::thrownMessage([&] {
                (void)readDetections(mapped, {{"intensity", "amplitud"}});
              }),
              HasSubstr("Did you mean 'amplitude'?"));
}

}  // namespace
}  // namespace core
