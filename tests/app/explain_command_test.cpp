#include <algorithm>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/json_object.h"
#include "tests/support/paths.h"
#include "tests/support/program.h"

namespace {

using test_support::ProgramRun;
using test_support::runFidelis;
using testing::HasSubstr;

/// Of the demo's first sample under a model of its own.
class ExplainCommand : public testing::Test {
 protected:
  ProgramRun explain(const nlohmann::json& effects, const std::vector<std::string>& more) {
    nlohmann::json model = core::readJson(demo_ / "model.json");
    model["effects"].update(effects);
    core::writeJson(folder_ / "model.json", model);
    std::vector<std::string> words{"explain", (demo_ / "range-sweep").string(), "--model",
                                   (folder_ / "model.json").string()};
    words.insert(words.end(), more.begin(), more.end());
    return runFidelis(words);
  }

  std::filesystem::path demo_ = test_support::sourceFolder() / "resources/demo";
  test_support::TemporaryFolder folder_;
};

TEST_F(ExplainCommand, TellsWhatSurfacesSendFromWhatTheAirSends) {
  const ProgramRun run = explain({{"atmospheric-backscatter", {{"visibility_m", 40.0}}}, {"speckle", {{"looks", 4.0}}}},
                                 {"--azimuth-deg", "0", "--json", "-"});
  ASSERT_EQ(run.status, 0) << run.messages;
  const nlohmann::json beam = nlohmann::json::parse(run.out);
  EXPECT_EQ(beam.at("fluctuation"), 1.0);
  EXPECT_NE(beam.at("fluctuation_of_surfaces"), 1.0);
  const auto of_surface = [](const nlohmann::json& pulse) { return pulse.at("of_surface").get<bool>(); };
  const auto& pulses = beam.at("pulses");
  EXPECT_TRUE(std::any_of(pulses.begin(), pulses.end(), of_surface));
  const auto of_air = std::find_if_not(pulses.begin(), pulses.end(), of_surface);
  ASSERT_NE(of_air, pulses.end());
  EXPECT_LT(of_air->at("range_m"), std::find_if(pulses.begin(), pulses.end(), of_surface)->at("range_m"));
}

TEST_F(ExplainCommand, AFrameThatIsNotThereIsNamed) {
  const ProgramRun run = explain(nlohmann::json::object(), {"--azimuth-deg", "0", "--frame", "1000"});
  EXPECT_EQ(run.status, 2);
  EXPECT_THAT(run.messages, HasSubstr("--frame 1000"));
}

}  // namespace
