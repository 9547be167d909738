#include "gap/causes/search.h"

#include <algorithm>
#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "gap/candidates/candidates.h"
#include "gap/causes/starts.h"
#include "gap/distance/discrepancy.h"
#include "gap/pairs/partners.h"
#include "tests/gap/measured_wall.h"

// How the values of a cause are searched.
namespace {

using test_support::SmallWorld;

class Search : public test_support::MeasuredWall {};

// The threshold is 10 times the noise: factors below do nothing, one of 20 would double it.
TEST_F(Search, FindsAThresholdThatBeginsToActBetweenTwoStepsOfAnEvenSearch) {
  measure({{"dynamic-threshold", {{"factor", 10.7}}}});
  const gap::Scouted found = scouted(effect("dynamic-threshold"));
  EXPECT_NEAR(found.values[0], 10.7, 0.03 * 10.7);
}

// A receiver that looks past the beam: 8 m away all light is lost from an offset of 58 mm on, and no larger one does
// more, so that all of these seem equally good. The right one takes nearly all; a millimetre less leaves twice as much.
TEST_F(Search, FindsANarrowDipBesideARangeInWhichAllIsLost) {
  measure({{"aperture-offset", {{"offset_m", 0.0565}}}}, {}, SmallWorld::narrowView());
  const gap::Scouted found = scouted(effect("aperture-offset"));
  EXPECT_NEAR(found.values[0], 0.0565, 0.0005);
}

// Up to an offset of 50 mm the receiver sees the whole beam 8 m away; half a millimetre more takes a little light, and
// every step of an even search does either nothing or far too much.
TEST_F(Search, FindsWhatACauseDoesFirstWhereItSoonDoesTooMuch) {
  measure({{"aperture-offset", {{"offset_m", 0.051}}}}, {}, SmallWorld::narrowView());
  const gap::Scouted found = scouted(effect("aperture-offset"));
  EXPECT_NEAR(found.values[0], 0.051, 0.0002);
}

// A sensor that looks down by 4 degrees, and a range offset: a rough fit of both traces nothing.
TEST_F(Search, OfTwoCausesLetsTheOneFollowThatSendsNoRaysOtherWays) {
  measure({{"mounting-error", {{"pitch_deg", 4.0}}}, {"range-offset", {{"offset_m", 0.1}}}});
  const gap::Candidate mounting{.hypothesis = effect("mounting-error"), .values = {0.0, 3.8}};
  const gap::Candidate offset{.hypothesis = effect("range-offset"), .values = {0.02}};
  const gap::Candidate pair = gap::pairOf(mounting, offset);
  const core::SilentProgress progress;
  const auto rough = gap::roughFitFrom(*replay_, pair.hypothesis, split_.fitted, pair.values, progress);
  EXPECT_THAT(rough, testing::ElementsAre(testing::DoubleNear(0.0, 1e-9), testing::DoubleNear(3.8, 1e-9),
                                          testing::DoubleNear(0.1, 0.03)));
  const auto both = gap::fitFrom(*replay_, pair.hypothesis, split_.fitted, rough, progress);
  const auto leftBy = [&](const std::vector<double>& values) {
    return gap::discrepancyOf(*replay_, gap::worldOf(*replay_, pair.hypothesis, values), split_.fitted);
  };
  const double right = leftBy({0.0, 4.0, 0.1});
  EXPECT_LT(leftBy(both) - right, 0.5 * (leftBy(rough) - right));
}

TEST_F(Search, TriesEachOfSeveralMechanismsAlone) {
  measure({{"pulse-jitter", {{"duration_stddev_ns", 0.1}}}});
  const gap::Hypothesis jitter = effect("pulse-jitter");
  const gap::Scouted found = scouted(jitter);
  ASSERT_EQ(jitter.parameters[0].name, "duration_stddev_ns");
  EXPECT_NEAR(found.values[0], 0.1, 0.05);
  EXPECT_LT(found.values[1], 0.002);  // of the power: off
}

// The map shows the sector but not how strong the cause is there; a cover that takes a tenth of the power is farther
// from the data than a clean one.
TEST_F(Search, FindsAWeakCauseWhereStrongerOnesAreWorseThanNone) {
  measure({{"cover-contamination", {{"attenuation", 0.02}, {"azimuth_from_deg", -8.0}, {"azimuth_to_deg", 4.0}}}});
  const gap::Hypothesis cover = effect("cover-contamination");
  const auto where = gap::whereIn(*replay_, replay_->baseline(), 1);
  const gap::Scouted found =
      gap::scout(*replay_, cover, split_.fitted, gap::startsFrom(*replay_, cover, where), core::SilentProgress());
  ASSERT_EQ(cover.parameters[0].name, "attenuation");
  EXPECT_NEAR(found.values[0], 0.02, 0.012);
  EXPECT_GT(found.gain, 0.0);
}

// A gate takes a third of the echoes of one wall, which stands in none of the samples looked at.
TEST_F(Search, KeepsWhatTheMapSuggestsWhereTheSamplesLookedAtShowNothing) {
  measure({{"range-gating", {{"from_m", 7.995}}}});
  const gap::Hypothesis gate = effect("range-gating");
  gap::Evidence far = split_.fitted;
  std::erase_if(far.samples, [&](std::size_t s) { return replay_->samples()[s].sample->id == "r8"; });
  ASSERT_FALSE(far.samples.empty());
  const auto where = gap::whereIn(*replay_, replay_->baseline(), 1);
  const gap::Scouted found =
      gap::scout(*replay_, gate, far, gap::startsFrom(*replay_, gate, where), core::SilentProgress());
  ASSERT_EQ(gate.parameters[0].name, "from_m");
  EXPECT_NEAR(found.values[0], 8.0, 0.02);
  EXPECT_EQ(found.gain, 0.0);
}

// Beams are 1° apart.
// Few beams led to values that are 2 cm off. Ranges have steps of 1 cm.
TEST_F(Search, RefinesTheOffsetOfEverySetUpByItself) {
  const std::map<std::string, double> offset_m = {{"r8", 0.06}, {"r13", -0.05}, {"r19", 0.0}, {"r27", 0.1}};
  measure({}, offset_m);
  const gap::Hypothesis setups = test_support::hypothesisNamed(gap::hypothesesFor(*replay_, {"latency"}),
                                                               "/scene/0/pose/position_m/0", "per set-up");
  std::vector<double> found;
  for (const gap::FreeParameter& setup : setups.parameters)
    found.push_back(offset_m.contains(setup.name) ? offset_m.at(setup.name) + 0.02 : 0.0);
  found = gap::refine(*replay_, setups, gap::splitByBeams(*replay_, 1).refined, found, core::SilentProgress());
  for (std::size_t i = 0; i < found.size(); ++i) {
    const auto& name = setups.parameters[i].name;
    EXPECT_NEAR(found[i], offset_m.contains(name) ? offset_m.at(name) : 0.0, 0.015) << name;
  }
}

// Few samples show it: in one a wall stands near a pane, in the others any dead time of the range that is searched does
// nothing. The number that all samples suggest is as good as the middle of that range, and right.
TEST_F(Search, KeepsTheOneNumberThatTheMapSuggestsWhereTheSamplesLookedAtShowNothing) {
  world_.behindAPane(5.0);
  measure({{"dead-time", {{"dead_time_ns", 70.0}}}}, {}, {}, {{"transmission", nlohmann::json::object()}});
  const gap::WhereResult where = gap::whereIn(*replay_, replay_->baseline(), 1);
  const gap::Hypothesis dead_time = effect("dead-time");
  gap::Evidence far = split_.fitted;
  std::erase_if(far.samples, [&](std::size_t s) { return replay_->samples()[s].sample->id != "r46"; });
  ASSERT_FALSE(far.samples.empty());
  const auto starts = gap::startsFrom(*replay_, dead_time, where);
  ASSERT_EQ(starts.size(), 1U);
  EXPECT_EQ(gap::scout(*replay_, dead_time, far, starts, core::SilentProgress()).values, starts.front());
}

// A light's sector is given by its middle and its width: with one edge in its place and the other 5° inside, any other
// middle alone, and nearly any other width alone, is worse.
TEST_F(Search, MovesOneEdgeOfASectorWhereTheOtherIsInItsPlace) {
  measure({{"blinding", {{"azimuth_deg", -3.9}, {"width_deg", 13.0}, {"irradiance", 0.5}, {"gain_loss", 0.6}}}});
  const auto forms = gap::hypothesesFor(*replay_, {"blinding"});
  const gap::Hypothesis blinding = test_support::hypothesisNamed(forms, "blinding", "desensitised");
  ASSERT_EQ(blinding.parameters[2].name, "width_deg");
  const auto found = gap::fitFrom(*replay_, blinding, split_.fitted, {-1.4, 0.5, 8.0, 0.6}, core::SilentProgress());
  EXPECT_NEAR(found[0] - found[2] / 2.0, -10.4, 0.6);
  EXPECT_NEAR(found[0] + found[2] / 2.0, 2.6, 0.6);
}

// The wetter a surface and the flatter its film, the brighter its lobe: what one number has too little the other makes
// up for, nearly.
TEST_F(Search, FollowsTheNarrowValleyOfNumbersOfLikeEffect) {
  measure({{"surface-moisture", {{"wetness", 0.5}, {"lobe_exponent", 30.0}, {"film_reflectance", 0.03}}}});
  const auto forms = gap::hypothesesFor(*replay_, {"surface-moisture"});
  const auto film = std::find_if(forms.begin(), forms.end(), [](const auto& h) { return h.variant == "other film"; });
  ASSERT_NE(film, forms.end());
  const std::vector<double> start{0.4, 50.0, 0.02};
  const auto near = gap::refineBriefly(*replay_, *film, split_.refined, start, core::SilentProgress());
  const auto found = gap::refineAlongValley(*replay_, *film, split_.refined, near, core::SilentProgress());
  EXPECT_GT(std::abs(near[1] - 30.0), 1.5);  // half way
  EXPECT_NEAR(found[0], 0.5, 0.02);
  EXPECT_NEAR(found[1], 30.0, 1.5);
  EXPECT_NEAR(found[2], 0.03, 0.002);
  EXPECT_EQ(gap::refine(*replay_, *film, split_.refined, start, core::SilentProgress()), found);
}

// Dirt on nearly all of the window, and more power that makes up for it, nearly: the two follow their valley, and the
// ends of the sector, of which small steps jump, stay where they are.
TEST_F(Search, FollowsAValleyBesideTheEndsOfASector) {
  measure({{"cover-contamination", {{"attenuation", 0.2}, {"azimuth_from_deg", -11.5}, {"azimuth_to_deg", 11.5}}}});
  const gap::Hypothesis pair =
      gap::together(effect("cover-contamination"),
                    test_support::hypothesisNamed(gap::hypothesesFor(*replay_, {}), "/sensor/emitter/peak_power_w"));
  const std::vector<double> start{0.25, -11.5, 11.5, 57.0};
  const auto near = gap::refineBriefly(*replay_, pair, split_.refined, start, core::SilentProgress());
  const auto found = gap::refineAlongValley(*replay_, pair, split_.refined, start, core::SilentProgress());
  EXPECT_GT(near[3], 55.0);  // hardly on its way
  EXPECT_NEAR(found[0], 0.2, 0.004);
  EXPECT_NEAR(found[3], 50.0, 0.5);
  EXPECT_EQ(found[1], -11.5);
  EXPECT_EQ(found[2], 11.5);
}

// A lobe is absent where all of the reflection is diffuse, at the upper end of that share.
TEST_F(Search, FindsACauseThatIsAbsentAtTheUpperEndOfItsRange) {
  measure({{"angular-reflection", {{"model", "phong"}, {"diffuse_fraction", 0.97}, {"exponent", 20}}}});
  const gap::Hypothesis lobe = effect("angular-reflection");
  const gap::Scouted found = scouted(lobe);
  ASSERT_EQ(lobe.parameters[0].name, "diffuse_fraction");
  EXPECT_NEAR(found.values[0], 0.97, 0.02);
  EXPECT_GT(found.gain, 0.3);
}

// Echoes of other lidars, that lie anywhere, make the mean range of all echoes that no surface makes a farther one.
TEST_F(Search, FindsWhereAFalseTargetStandsAmongEchoesFromAnywhere) {
  measure({{"spoofing", {{"azimuth_deg", 0.0}, {"width_deg", 3.0}, {"range_m", 5.0}}},
           {"crosstalk", {{"rate_1_s", 4000}}}});
  const gap::Hypothesis spoofing = effect("spoofing");
  ASSERT_EQ(spoofing.parameters[1].name, "range_m");
  const auto distance = [&](double range_m) {
    return gap::discrepancyOf(*replay_, gap::worldOf(*replay_, spoofing, {0.0, range_m, 3.0}), split_.fitted);
  };
  for (const double elsewhere_m : {5.4, 6.0, 10.0, 14.0})
    EXPECT_GT(distance(elsewhere_m), distance(5.0)) << elsewhere_m;
}

// Whatever lies between 0.42 and 0.81 is equally right, and an end of it the worst guess for other samples.
TEST_F(Search, TakesTheMiddleOfWhatTheDataLeaveOpen) {
  moveBy(0.1);
  gap::Hypothesis gate;
  gate.name = "gate";
  gate.parameters = {{"value", "", 0.01, 1.0, false, 0.01}};
  gate.apply = [](gap::World& world, const std::vector<double>& values) {
    if (values[0] > 0.42 && values[0] < 0.81) world.references.push_back({"/scene/0/pose/position_m/0", 0.1, {}});
  };
  EXPECT_NEAR(scouted(gate).values[0], 0.615, 0.04);
}

TEST_F(Search, FitsCountsAsWholeNumbers) {
  measure({{"quantisation", {{"intensity_bits", 9}}}});
  const auto forms = gap::hypothesesFor(*replay_, {"quantisation"});
  const auto bits = std::find_if(forms.begin(), forms.end(), [](const auto& h) { return h.variant == "intensity"; });
  ASSERT_NE(bits, forms.end());
  const core::SilentProgress progress;
  const std::vector<double> found = gap::fitFrom(*replay_, *bits, split_.fitted, scouted(*bits).values, progress);
  EXPECT_EQ(found[0], 9.0);
  EXPECT_EQ(gap::resolvedAt(bits->parameters[0], 9.0), 0.5);
}

// The wall stands four steps of 0.1 m too far and all ranges are 0.5 m too long. The ranges alone may be eight steps
// and 0.1 m, too: one step less makes them wrong by 0.1 m, and only with an offset that is larger by as much it tells
// what the power does, that the wall is nearer.
TEST_F(Search, TriesACountLessWithWhatGoesWithIt) {
  std::map<std::string, double> moved;
  for (const char* sample : {"r8", "r13", "r19", "r27", "r36", "r46"}) moved[sample] = 4 * 0.1;
  measure({{"range-offset", {{"offset_m", 0.5}}}}, moved);
  gap::Hypothesis both;
  both.name = "steps and an offset";
  both.parameters = {{.name = "steps", .low = 0.0, .high = 20.0, .whole = true}, {.name = "offset_m", .high = 1.0}};
  both.apply = [](gap::World& world, const std::vector<double>& values) {
    world.references.push_back({"/scene/0/pose/position_m/0", 0.1 * values[0], {}});
    world.model = model::withEffect(world.model, {"range-offset", {{{"offset_m", values[1]}}, {}, {}}, {}});
  };
  const auto found = gap::fitFrom(*replay_, both, split_.fitted, {8.0, 0.1}, core::SilentProgress());
  EXPECT_EQ(found[0], 4.0);
  EXPECT_NEAR(found[1], 0.5, 0.004);
}

// Of 0.01 to 1, searched in its logarithm, to 13 bits of that range: ln(100) / 8192 of the value.
TEST(Resolved, IsTheStepOfTheSearchAtThatValue) {
  const gap::FreeParameter parameter{"value", "", 0.01, 1.0, true, 0.1};
  EXPECT_NEAR(gap::resolvedAt(parameter, 0.2), 0.2 * std::log(100.0) / 8192.0, 1e-7);
}

}  // namespace
