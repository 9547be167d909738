#include <gmock/gmock.h>

#include "tests/bench/withheld/small_world.h"
#include "tests/support/program.h"

// Two programs that share no code read formats.md, section "reference signal chain". Where they agree, both are right
// or both misread the same sentence.
namespace {

using nlohmann::json;
using namespace small_world;
using test_support::runFidelis;
using test_support::runProgram;

json noisy(json sensor) {
  sensor["receiver"]["noise_w"] = 3e-9;
  auto& detection = sensor["detection"];
  detection["range_resolution_m"] = 0.01, detection["epw_resolution_m"] = 0.03, detection["intensity_resolution"] = 5;
  detection["range_noise_m"] = 0.02, detection["epw_noise_m"] = 0.05;
  return sensor;
}

// A board before a wall, turned, with a sphere, a pole and a box at its side: even faces, edges, curved bodies.
json variedExperiment() {
  json package = experiment({8, 15, 30, 60}, 30);
  package["sensor"] = noisy(sensor());
  package["scene"][0]["shape"] = {{"type", "rectangle"}, {"width_m", 3}, {"height_m", 3}};
  package["scene"][0]["pose"]["yaw_pitch_roll_deg"] = {25, 5, 0};
  const auto add = [&](const char* id, const json& shape, const json& position) {
    package["scene"].push_back({{"id", id},
                                {"shape", shape},
                                {"pose", {{"position_m", position}, {"yaw_pitch_roll_deg", {10, 0, 0}}}},
                                {"material", "board"}});
  };
  add("wall", {{"type", "box"}, {"size_m", {1, 60, 30}}}, {70, 0, 0});
  add("ball", {{"type", "sphere"}, {"radius_m", 0.6}}, {12, 1.4, 0});
  add("pole", {{"type", "cylinder"}, {"radius_m", 0.4}, {"height_m", 3}}, {14, -1.8, 0});
  add("box", {{"type", "box"}, {"size_m", {2, 1.5, 1.5}}}, {22, -3.0, 0.2});
  add("road", {{"type", "plane"}}, {0, 0, -1.0});
  return package;
}

struct Case {
  std::string name;
  json effects;
  std::string mode;
};

class WithheldAgreement : public testing::TestWithParam<Case> {};

json compared(const std::string& real, const std::string& simulated, const std::string& column) {
  const auto result = runFidelis({"metric", real, simulated, "--column", column, "--json", "-", "--quiet"});
  EXPECT_EQ(result.status, 0) << result.messages;
  return json::parse(result.out)["measurands"][0];
}

TEST_P(WithheldAgreement, BaselinesDifferByLessThanOneStep) {
  const test_support::TemporaryFolder folder;
  json world = model(GetParam().effects);
  world["sensor"] = noisy(sensor());
  world["sensor"]["detection"]["range_mode"] = GetParam().mode;
  folder.write("package/experiment.json", variedExperiment().dump(1));
  const std::string file = folder.write("world.json", world.dump(1));
  const auto foreign =
      runProgram("withheld_generator", {folder / "package", "--model", file, "--out", folder / "foreign"});
  ASSERT_EQ(foreign.status, 0) << foreign.messages;
  const auto own = runFidelis({"simulate", folder / "package", "--model", file, "--out", folder / "own", "--quiet"});
  ASSERT_EQ(own.status, 0) << own.messages;
  for (const std::string sample : {"s0", "s1", "s2", "s3"}) {
    const std::string csv = "measurements/" + sample + ".csv.gz";
    const std::map<std::string, double> steps = {{"range_m", 0.01}, {"epw_m", 0.03}};
    for (const auto& [column, step] : steps) {
      const json result = compared(folder / ("foreign/" + csv), folder / ("own/" + csv), column);
      EXPECT_LT(std::abs(result["dvm"][0].get<double>()), step) << sample << ' ' << column;
      EXPECT_LT(result["dvm"][1].get<double>(), step) << sample << ' ' << column;
      const double measured = result["n_real"], simulated = result["n_sim"][0];
      EXPECT_NEAR(simulated / measured, 1.0, 0.01) << sample;
    }
  }
}

const json kOn = json::object();

INSTANTIATE_TEST_SUITE_P(
    Baselines, WithheldAgreement,
    testing::Values(Case{"one_ray", json::object(), "peak"}, Case{"footprint", {{"beam-divergence", kOn}}, "peak"},
                    Case{"leading_edge", {{"beam-divergence", kOn}}, "leading-edge"},
                    Case{"centre_broadened", {{"beam-divergence", kOn}, {"pulse-broadening", kOn}}, "centre"}),
    [](const auto& test) { return test.param.name; });

}  // namespace
