#include "gap/pairs/exchanges.h"

#include <algorithm>
#include <gtest/gtest.h>

#include "gap/far/how_far.h"
#include "gap/pairs/partners.h"
#include "tests/gap/hypothesis_named.h"
#include "tests/gap/small_world.h"

namespace {

using test_support::SmallWorld;

struct Fitted {
  std::string name;
  std::vector<double> values;
  std::string form;
};

/// The pairs after members were exchanged, of a measurement with these effects. The pair that begins is that of the
/// first two causes.
std::vector<gap::Candidate> exchanged(const SmallWorld::Effects& truth, const std::vector<Fitted>& causes,
                                      double true_reflectivity = 0.4) {
  const SmallWorld world;
  const model::Experiment experiment = world.measuredBy(SmallWorld::modelWith(truth), true_reflectivity);
  const gap::Replay replay(experiment, SmallWorld::modelWith({}));
  const gap::Split split = gap::splitOf(replay, 1);
  const gap::Judge judge{replay, split, gap::yardstickOf(replay, split.held_out)};
  const gap::HeldOutGaps gaps(replay, split.held_out.samples, 1);
  std::vector<gap::Candidate> singles;
  for (const auto& [name, values, form] : causes) {
    singles.push_back({test_support::hypothesisNamed(gap::hypothesesFor(replay, {name}), name, form), values});
  }
  std::vector<gap::Candidate> pairs{gap::pairOf(singles[0], singles[1])};
  judge.hear(pairs.front());
  const gap::Candidate first = pairs.front();
  gap::exchangeMembersOf(first, judge, judge, gaps, singles, pairs, core::SilentProgress());
  return pairs;
}

// Speckle of 100 looks scatters power by 1/√100 (Goodman 2007, eq. 3-26), as a jitter of the pulse's power by 0.1 does.
// Alone, that jitter had been fitted to half of it.
TEST(Exchanges, ACauseThatDoesTheSameIsFittedBesideTheOtherMember) {
  const auto pairs = exchanged({{"speckle", {{"looks", 100}}}, {"detection-loss", {{"probability", 0.1}}}},
                               {{"speckle", {100.0}, ""},
                                {"detection-loss", {0.1}, ""},
                                {"pulse-jitter", {0.0, 0.05}, ""},
                                {"clock-drift", {1000.0}, ""}});
  const auto exchanged = std::find_if(pairs.begin(), pairs.end(), [](const gap::Candidate& pair) {
    return pair.hypothesis.name == "detection-loss + pulse-jitter";
  });
  ASSERT_NE(exchanged, pairs.end());
  EXPECT_NEAR(exchanged->values[0], 0.1, 0.01);  // loss
  EXPECT_NEAR(exchanged->values[2], 0.1, 0.01);  // power of the pulse
  EXPECT_NEAR(exchanged->explained, 1.0, 0.1);
}

// Dirt that takes 0.4 of the light each way leaves as much as a receiver that lost 0.64 of its gain. Alone, the dirt
// had been fitted where a dark board stood.
TEST(Exchanges, ACauseInASectorIsTriedInThatOfTheMemberInWhosePlaceItComes) {
  const auto pairs =
      exchanged({{"range-offset", {{"offset_m", 0.1}}},
                 {"cover-contamination", {{"attenuation", 0.4}, {"azimuth_from_deg", 5.5}, {"azimuth_to_deg", 8.5}}}},
                {{"range-offset", {0.1}, ""},
                 {"blinding", {7.0, 0.1, 3.0, 0.64}, "desensitised"},
                 {"cover-contamination", {0.4, -9.0, -6.0}, ""}});
  const auto exchanged = std::find_if(pairs.begin(), pairs.end(), [](const gap::Candidate& pair) {
    return pair.hypothesis.name == "range-offset + cover-contamination";
  });
  ASSERT_NE(exchanged, pairs.end());
  EXPECT_NEAR(exchanged->values[2], 5.5, 0.6);  // beams are a degree apart
  EXPECT_NEAR(exchanged->values[3], 8.5, 0.6);
  EXPECT_NEAR(exchanged->explained, 1.0, 0.1);
}

// A wall that is 0.9 times as bright returns what a laser of 0.9 times the power does. Fitted alone, the wall had to
// take what haze takes, too, and so it comes nowhere near beside the haze.
TEST(Exchanges, AParameterThatDoesWhatTheMemberDoesIsTriedWhereItDoesSo) {
  const auto pairs = exchanged({{"atmospheric-attenuation", {{"visibility_m", 200}}}},
                               {{"atmospheric-attenuation", {200.0}, ""},
                                {"/sensor/emitter/peak_power_w", {45.0}, ""},
                                {"range-offset", {0.0}, ""},
                                {"clock-drift", {0.0}, ""},
                                {"detection-loss", {0.0}, ""},
                                {"false-alarm", {0.0}, ""},
                                {"pulse-jitter", {0.0, 0.0}, ""},
                                {"cover-contamination", {0.0, -9.0, -6.0}, ""},
                                {"/materials/plaster/reflectivity", {0.2}, ""}},
                               0.36);
  const auto exchanged = std::find_if(pairs.begin(), pairs.end(), [](const gap::Candidate& pair) {
    return pair.hypothesis.name == "atmospheric-attenuation + /materials/plaster/reflectivity";
  });
  ASSERT_NE(exchanged, pairs.end());
  EXPECT_NEAR(exchanged->values[0], 200.0, 5.0);
  EXPECT_NEAR(exchanged->values[1], 0.36, 0.005);
}

// A threshold that is 12 times the noise is another constant threshold; one that falls with range (by nothing) comes as
// near and has a number more, so that nobody would put it in the place of a parameter.
TEST(Exchanges, TheUsualFormOfACauseIsTriedWhereAnotherFormComesNearest) {
  const auto pairs = exchanged({{"dynamic-threshold", {{"factor", 12}}}, {"detection-loss", {{"probability", 0.1}}}},
                               {{"detection-loss", {0.1}, ""},
                                {"range-offset", {0.01}, ""},
                                {"dynamic-threshold", {14.0}, ""},
                                {"dynamic-threshold", {12.0, 0.0}, "falling with range"}});
  const auto usual = std::find_if(pairs.begin(), pairs.end(), [](const gap::Candidate& pair) {
    return pair.hypothesis.name == "detection-loss + dynamic-threshold" && pair.hypothesis.variant.empty();
  });
  ASSERT_NE(usual, pairs.end());
  EXPECT_NEAR(usual->values[1], 12.0, 0.2);
}

// One shot in some hundreds has such an echo: few shots of few samples hardly show how many. Alone, foreign pulses had
// been fitted to what the offset makes of all surfaces.
TEST(Exchanges, ARareEchoHasTheRateThatIsCountedBesideTheOtherMember) {
  const auto pairs =
      exchanged({{"range-offset", {{"offset_m", 0.1}}}, {"crosstalk", {{"rate_1_s", 20000}}}},
                {{"range-offset", {0.1}, ""}, {"false-alarm", {0.02}, ""}, {"crosstalk", {900000.0, 300.0}, ""}});
  const auto exchanged = std::find_if(pairs.begin(), pairs.end(), [](const gap::Candidate& pair) {
    return pair.hypothesis.name == "range-offset + crosstalk";
  });
  ASSERT_NE(exchanged, pairs.end());
  EXPECT_NEAR(exchanged->values[1], 20000.0, 4000.0);
  EXPECT_NEAR(exchanged->explained, 1.0, 0.1);
}

// A light that blinds, too strong because it stood for the echoes that the saturation takes, beside which a saturation
// that was fitted alone takes far too much. Both are far from where they are together, and a rough fit of all four
// numbers ends half way.
TEST(Exchanges, OfTheBestAloneOneThatIsFarFromItsPlaceBesideTheOtherIsFittedToTheEnd) {
  const auto pairs =
      exchanged({{"saturation", {{"saturation_w", 4e-6}}},
                 {"blinding", {{"azimuth_deg", 0.0}, {"irradiance", 0.5}, {"width_deg", 11.0}}}},
                {{"detection-loss", {0.08}, ""}, {"blinding", {0.5, 1.8, 10.0}, ""}, {"saturation", {1e-6}, ""}});
  const auto exchanged = std::find_if(pairs.begin(), pairs.end(), [](const gap::Candidate& pair) {
    return pair.hypothesis.name == "blinding + saturation";
  });
  ASSERT_NE(exchanged, pairs.end());
  EXPECT_NEAR(exchanged->values[3], 4e-6, 0.2e-6);
  EXPECT_GT(exchanged->explained, 0.9);
}

}  // namespace
