#include <gmock/gmock.h>
#include <map>
#include <nlohmann/json.hpp>

#include "tests/support/program.h"

namespace {

using test_support::runFidelis;
using testing::HasSubstr;

std::map<std::string, bool> fittedOf(const std::string& effect) {
  const auto run = runFidelis({"effects", effect, "--json", "-"});
  EXPECT_EQ(run.status, 0) << run.messages;
  std::map<std::string, bool> fitted;
  const auto document = nlohmann::json::parse(run.out);
  for (const auto& parameter : document["effects"][0]["parameters"])
    if (parameter.contains("fitted")) fitted[parameter["name"]] = parameter["fitted"];
  return fitted;
}

// The reach is free in another form of the effect, the diameter of the window in none.
TEST(EffectsCommand, SaysWhatADiagnosisFitsInAnyForm) {
  EXPECT_EQ(fittedOf("blooming"), (std::map<std::string, bool>{{"fraction", true}, {"neighbours", true}}));
  EXPECT_FALSE(fittedOf("precipitation-clutter").at("window_m"));
  EXPECT_THAT(runFidelis({"effects", "blooming"}).out, HasSubstr("default 5, fitted by a diagnosis"));
}

TEST(EffectsCommand, ATypoIsAnsweredWithTheNearestName) {
  const auto run = runFidelis({"effects", "bloming"});
  EXPECT_EQ(run.status, 2);
  EXPECT_THAT(run.messages, HasSubstr("Did you mean 'blooming'?"));
}

}  // namespace
