#include <fstream>
#include <gmock/gmock.h>
#include <iterator>
#include <regex>

#include "tests/bench/withheld/small_world.h"
#include "tests/support/program.h"

namespace {

using nlohmann::json;
using namespace small_world;
using test_support::runProgram;
using testing::HasSubstr;

std::string bytesOf(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

TEST(WithheldGeneratorProgram, SameSeedSameBytesForAnyNumberOfThreads) {
  const test_support::TemporaryFolder folder;
  json noisy = model(
      {{"beam-divergence", json::object()}, {"speckle", json::object()}, {"false-alarm", {{"rate_per_beam", 0.1}}}});
  noisy["sensor"]["receiver"]["noise_w"] = 3e-9;
  folder.write("package/experiment.json", experiment({10, 20, 30}, 3).dump(1));
  const std::string world = folder.write("world.json", noisy.dump());
  for (const std::string run : {"a", "b", "c"}) {
    const auto result =
        runProgram("withheld_generator", {folder / "package", "--model", world, "--out", folder / run, "--threads",
                                          run == "b" ? "3" : "1", "--seed", run == "c" ? "8" : "7"});
    ASSERT_EQ(result.status, 0) << result.messages;
  }
  EXPECT_EQ(bytesOf(folder / "a/experiment.json"), bytesOf(folder / "package/experiment.json"));
  for (const std::string file : {"measurements/s0.csv.gz", "measurements/s2.csv.gz"}) {
    EXPECT_FALSE(bytesOf(folder / ("a/" + file)).empty());
    EXPECT_EQ(bytesOf(folder / ("a/" + file)), bytesOf(folder / ("b/" + file)));
    EXPECT_NE(bytesOf(folder / ("a/" + file)), bytesOf(folder / ("c/" + file)));
  }
}

std::string complaint(const json& experiment, const json& model) {
  const test_support::TemporaryFolder folder;
  folder.write("package/experiment.json", experiment.dump());
  const auto result =
      runProgram("withheld_generator",
                 {folder / "package", "--model", folder.write("world.json", model.dump()), "--out", folder / "out"});
  EXPECT_EQ(result.status, 2);
  EXPECT_FALSE(std::filesystem::exists(folder / "out"));
  return result.messages;
}

TEST(WithheldGeneratorProgram, WrongInputIsNamedAndNothingIsWritten) {
  const json good = experiment({20});
  EXPECT_THAT(complaint(good, model({{"range-ofset", json::object()}})), HasSubstr("'range-offset'"));
  EXPECT_THAT(complaint(good, model({{"speckle", {{"look", 3}}}})), HasSubstr("'looks'"));
  EXPECT_THAT(complaint(good, model({{"speckle", {{"looks", 1e6}}}})), HasSubstr("[1, 100]"));
  json mesh = good;
  mesh["scene"][0]["shape"] = {{"type", "mesh"}, {"file", "car.obj"}};
  EXPECT_THAT(complaint(mesh, model(json::object())), HasSubstr("/scene/0/shape/type"));
  json outside = good;
  outside["samples"][0]["measurements"] = "../s0.csv";
  EXPECT_THAT(complaint(outside, model(json::object())), HasSubstr("outside the package"));
  EXPECT_EQ(runProgram("withheld_generator", {"--modle"}).status, 2);
}

// The point of a second generator: it must not share what it is to check.
TEST(WithheldGeneratorProgram, IncludesNothingOfTheProgramThatItChecks) {
  const std::regex include("^\\s*#\\s*include\\s*\"([^\"]+)\"");
  int files = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(test_support::sourceFolder() / "bench/withheld/generator")) {
    if (entry.path().extension() != ".h" && entry.path().extension() != ".cpp") continue;
    ++files;
    std::ifstream stream(entry.path());
    std::smatch match;
    for (std::string line; std::getline(stream, line);) {
      if (!std::regex_search(line, match, include)) continue;
      EXPECT_TRUE(match[1].str().starts_with("bench/withheld/generator/")) << entry.path() << " includes " << match[1];
    }
  }
  EXPECT_GT(files, 20);
}

}  // namespace
