#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/detection_files/detection_file.h"
#include "core/file.h"
#include "tests/support/paths.h"
#include "tests/support/program.h"

namespace {

using test_support::runFidelis;
using test_support::testData;
using ::testing::HasSubstr;

TEST(ConvertCommand, PointsWithoutLayersBecomeACsvOnceTheSensorIsNamed) {
  const test_support::TemporaryFolder folder;
  const std::string in = testData("detection_files/detections.osi").string();
  const auto refused = runFidelis({"convert", in, folder / "d.csv"});
  EXPECT_EQ(refused.status, 2);
  EXPECT_THAT(refused.messages, HasSubstr("no layer"));
  EXPECT_FALSE(std::filesystem::exists(folder / "d.csv"));
  const auto run = runFidelis({"convert", in, folder / "d.csv", "--sensor", "ibeo-lux-2010"});
  EXPECT_EQ(run.status, 0) << run.messages;
  EXPECT_THAT(run.messages, HasSubstr("4 detections"));
  const core::Detections detections = core::readDetections(folder / "d.csv");
  EXPECT_EQ(detections.range_m, (std::vector<double>{10, 5, 2, 3}));
  EXPECT_EQ(detections.layer.size(), 4u);
}

TEST(ConvertCommand, ThereAndBackGivesTheSameBytes) {
  const test_support::TemporaryFolder folder;
  const auto csv = test_support::sourceFolder() / "resources/demo/range-sweep/measurements/r10.csv";
  ASSERT_EQ(runFidelis({"convert", csv, folder / "first.csv"}).status, 0);
  ASSERT_EQ(runFidelis({"convert", csv, folder / "d.ply", "--encoding", "binary_big_endian"}).status, 0);
  ASSERT_EQ(runFidelis({"convert", folder / "d.ply", folder / "d.pcd", "--encoding", "binary_compressed"}).status, 0);
  ASSERT_EQ(runFidelis({"convert", folder / "d.pcd", folder / "again.csv"}).status, 0);
  EXPECT_EQ(core::readFile(folder / "again.csv"), core::readFile(folder / "first.csv"));
}

TEST(ConvertCommand, ReflectionsBecomePointsOnDemand) {
  const test_support::TemporaryFolder folder;
  const std::string in = testData("detection_files/reflections.osi").string();
  EXPECT_EQ(runFidelis({"convert", in, folder / "p.ply"}).status, 2);
  EXPECT_EQ(runFidelis({"convert", in, folder / "p.ply", "--reflections"}).status, 0);
  EXPECT_EQ(core::readDetections(folder / "p.ply").size(), 3u);
}

}  // namespace
