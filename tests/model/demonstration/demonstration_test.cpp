#include "model/demonstration/demonstration.h"

#include <cmath>
#include <gmock/gmock.h>

#include "core/error.h"
#include "core/file.h"
#include "core/json_object.h"
#include "model/effects/effect.h"
#include "tests/support/paths.h"
#include "tests/support/thrown_message.h"

namespace model {
namespace {

using testing::HasSubstr;

std::filesystem::path fileOf(const std::string& effect) {
  return test_support::sourceFolder() / "resources/effects" / (effect + ".json");
}

// scripts/effect-pages draws it there.
TEST(Demonstrations, OfEveryEffectHaveTheirPictureInItsSection) {
  constexpr std::size_t kLargest = 40'000;
  const auto docs = test_support::sourceFolder() / "docs";
  const std::string page = core::readFile(docs / "effects.md");
  for (const EffectEntry& entry : allEffects()) {
    const std::string& name = entry.info.name;
    ASSERT_TRUE(std::filesystem::exists(fileOf(name))) << name << " has no demonstration";
    const DemonstrationPlan plan = readDemonstration(fileOf(name));
    EXPECT_EQ(plan.effect, name);
    const std::size_t begin = page.find("## " + name + "\n");
    ASSERT_NE(begin, std::string::npos) << name;
    const std::string section = page.substr(begin, page.find("\n## ", begin) - begin);
    EXPECT_THAT(section, HasSubstr("](images/effects/" + name + ".svg)"));
    EXPECT_THAT(section, HasSubstr(plan.caption));
    const auto picture = docs / "images/effects" / (name + ".svg");
    ASSERT_TRUE(std::filesystem::exists(picture)) << picture;
    EXPECT_LT(std::filesystem::file_size(picture), kLargest) << picture;
    const std::string svg = core::readFile(picture);
    for (const std::string& word : {plan.title, plan.x_name, plan.y_name, plan.off.name, plan.on.back().name})
      EXPECT_THAT(svg, HasSubstr(word)) << name << ": run scripts/effect-pages";
  }
}

// A picture in which off and on look the same shows nothing. 1 % of the picture: a line in 300 pixels is 3 off.
TEST(Demonstrations, OfEveryEffectDifferWithItFromWithoutIt) {
  constexpr double kLeast = 0.01;
  for (const EffectEntry& entry : allEffects()) {
    const Demonstration shown = demonstrate(readDemonstration(fileOf(entry.info.name)));
    for (std::size_t i = 1; i < shown.series.size(); ++i)
      EXPECT_GE(difference(shown, i), kLeast) << entry.info.name << ", " << shown.series[i].name;
  }
}

// r_reported = r (1 + 1e-6 scale); the mean of n = 400 ranges with 1 cm of noise lies within 5 sigma/sqrt(n) of that.
TEST(Demonstrations, SweepsShowTheModelsOwnClosedForm) {
  const Demonstration shown = demonstrate(readDemonstration(fileOf("clock-drift")));
  ASSERT_EQ(shown.series.size(), 3u);
  for (std::size_t i = 0; i < shown.series[1].x.size(); ++i) {
    const double range_m = shown.series[1].x[i];
    EXPECT_NEAR(shown.series[0].y[i], 0.0, 100.0 * 5.0 * 0.01 / 20.0);
    EXPECT_NEAR(shown.series[1].y[i], 100.0 * 500e-6 * range_m, 100.0 * 5.0 * 0.01 / 20.0);
    EXPECT_NEAR(shown.series[2].y[i], 100.0 * -1000e-6 * range_m, 100.0 * 5.0 * 0.01 / 20.0);
  }
}

TEST(Demonstrations, OfAnEffectThatDoesNothingDoNotDiffer) {
  DemonstrationPlan lines = readDemonstration(fileOf("range-offset"));
  for (auto& setting : lines.on) setting.parameters["offset_m"] = 0.0;
  EXPECT_EQ(difference(demonstrate(lines), 1), 0.0);
  DemonstrationPlan points = readDemonstration(fileOf("detection-loss"));
  for (auto& setting : points.on) setting.parameters["probability"] = 0.0;
  EXPECT_EQ(difference(demonstrate(points), 1), 0.0);
}

// All echoes lost: every point without the effect is alone, and there are no others.
TEST(Demonstrations, OfAnEffectThatTakesEverythingDifferEntirely) {
  DemonstrationPlan plan = readDemonstration(fileOf("detection-loss"));
  plan.on.front().parameters["probability"] = 1.0;
  EXPECT_EQ(difference(demonstrate(plan), 1), 1.0);
}

class DemonstrationFiles : public testing::Test {
 protected:
  /// The message for a demonstration of the real one's content with `change` merged into it.
  static std::string refusalOf(const nlohmann::json& change) {
    const auto folder = std::filesystem::path(testing::TempDir()) / "demonstration";
    std::filesystem::create_directories(folder / "scenes");
    nlohmann::json value = core::readJson(fileOf("clock-drift"));
    std::filesystem::copy_file(fileOf("scenes/target"), folder / "scenes/target.json",
                               std::filesystem::copy_options::overwrite_existing);
    value.merge_patch(change);
    core::writeJson(folder / "wrong.json", value);
    return test_support::thrownMessage([&] { (void)demonstrate(readDemonstration(folder / "wrong.json")); });
  }
};

TEST_F(DemonstrationFiles, NameTheirPlaceWhenTheyAreWrong) {
  EXPECT_THAT(refusalOf({{"captoin", "x"}}), HasSubstr("captoin"));
  EXPECT_THAT(refusalOf({{"draw", {{"view", "sweeep"}}}}), HasSubstr("sweep"));
  EXPECT_THAT(refusalOf({{"draw", {{"from", 200}}}}), HasSubstr("'from'"));
  EXPECT_THAT(refusalOf({{"draw", {{"step", 1e-9}}}}), HasSubstr("2000 steps"));
  EXPECT_THAT(refusalOf({{"draw", {{"over", "/scene/9/pose"}}}}), HasSubstr("patch"));
  EXPECT_THAT(
      refusalOf(
          {{"draw",
            {{"view", "bins"}, {"over", "epw_m"}, {"value", "rate"}, {"minus_sweep", nullptr}, {"of", nullptr}}}}),
      HasSubstr("'epw_m'"));  // nobody knows the echo pulse width of a shot without an echo
  EXPECT_THAT(refusalOf({{"scene", "nowhere"}}), HasSubstr("nowhere.json"));
  EXPECT_THAT(refusalOf({{"on", nlohmann::json::array()}}), HasSubstr("at least one"));
  EXPECT_THAT(refusalOf({{"effect", "clock-drfit"}}), HasSubstr("clock-drift"));
  EXPECT_THAT(refusalOf({{"patch", {{{"op", "replace"}, {"path", "/scene/7"}, {"value", 1}}}}}), HasSubstr("patch"));
}

}  // namespace
}  // namespace model
