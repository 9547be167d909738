#include "gap/pairs/recalibrations.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/gap/looked_at_causes.h"

namespace {

using test_support::LookedAtCauses;
using test_support::SmallWorld;

// The model was calibrated in haze, so that its walls are darker than they are. The noise is that of a weak sensor:
// cells with an echo or two are off by ten errors, and squares of these hide what all others say.
TEST(Recalibration, HidesACauseThatSumsOfShiftsShow) {
  const SmallWorld world;
  const LookedAtCauses causes(world, {{"atmospheric-attenuation", {{"visibility_m", 4666.0}}}}, "range-offset",
                              "atmospheric-attenuation",
                              {{"/sensor/receiver/threshold_w", 1.2e-7}, {"/sensor/receiver/noise_w", 4e-8}}, 0.405);
  const gap::Looks looks = causes.looks();
  const auto besideHaze = [&](const std::vector<gap::Guess>& guesses) {
    std::vector<std::string> names;
    for (const gap::Guess& guess : guesses)
      if (causes.nameOf(guess.first) == "atmospheric-attenuation") names.push_back(causes.nameOf(guess.second));
    return names;
  };
  const gap::Recalibrations::Hidden hidden = gap::Recalibrations(looks).hidden();
  // Where all is of one material both hide it alike, and few data may say which comes first.
  const auto either = testing::AnyOf("/sensor/emitter/peak_power_w", "/materials/plaster/reflectivity");
  EXPECT_THAT(besideHaze(hidden.by_means), testing::Contains(either));
  EXPECT_THAT(besideHaze(hidden.by_another), testing::ElementsAre(either));
}

// Few data hardly tell a little haze behind a little power from much of both; all that are fitted do. Between the
// visibilities that were looked at (1.7, 4.6 km) what haze does is interpolated.
TEST(Recalibration, HidesAsMuchOfACauseAsAllFittedDataSay) {
  const SmallWorld world;
  LookedAtCauses causes(world, {{"atmospheric-attenuation", {{"visibility_m", 2600.0}}}}, "range-offset",
                        "atmospheric-attenuation", {}, 0.42);
  const std::size_t reflectivity = causes.fitted("/materials/plaster/reflectivity", {0.403});
  const gap::Looks looks = causes.looks();
  const std::vector<gap::Guess> guesses =
      gap::Recalibrations(looks).hiddenFromFewData(reflectivity, causes.leftBy(reflectivity));
  const auto haze = std::find_if(guesses.begin(), guesses.end(), [&](const gap::Guess& guess) {
    return causes.nameOf(guess.first) == "atmospheric-attenuation";
  });
  ASSERT_NE(haze, guesses.end());
  EXPECT_EQ(causes.nameOf(haze->second), "/materials/plaster/reflectivity");
  EXPECT_NEAR(haze->values.front(), 2600.0, 600.0);
  EXPECT_NEAR(haze->values.back(), 0.42, 0.01);
}

}  // namespace
