#include <algorithm>
#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <optional>

#include "gap/causes/starts.h"
#include "gap/far/how_far.h"
#include "gap/which/belief.h"
#include "gap/which/candidates.h"
#include "gap/which/decision.h"
#include "gap/which/partners.h"
#include "gap/which/rivals.h"
#include "gap/which/separation.h"
#include "tests/gap/hypothesis_named.h"
#include "tests/gap/small_world.h"

// How the values of a cause are searched, and what counts when causes are compared.
namespace {

using test_support::SmallWorld;

class Search : public testing::Test {
 protected:
  void measure(SmallWorld::Effects truth, const std::map<std::string, double>& offset_m = {},
               const std::map<std::string, double>& sensor = {}, const SmallWorld::Effects& known = {}) {
    truth.insert(known.begin(), known.end());
    measured_ = world_.measuredBy(SmallWorld::modelWith(truth, sensor), 0.4, offset_m);
    replay_.emplace(measured_, SmallWorld::modelWith(known, sensor));
    split_ = gap::splitOf(*replay_, 1);
  }
  /// Nothing is missing but that the wall stands elsewhere in all samples.
  void moveBy(double offset_m) {
    std::map<std::string, double> everywhere;
    for (const char* sample : {"r8", "r13", "r19", "r27", "r36", "r46"}) everywhere[sample] = offset_m;
    measure({}, everywhere);
  }
  [[nodiscard]] gap::Hypothesis effect(const std::string& name) const {
    return test_support::hypothesisNamed(gap::hypothesesFor(*replay_, {name}), name);
  }
  [[nodiscard]] gap::Scouted scouted(const gap::Hypothesis& hypothesis) const {
    return gap::scout(*replay_, hypothesis, split_.fitted, {}, core::SilentProgress());
  }
  /// An effect as it is ranked, with what the residual map suggests.
  [[nodiscard]] gap::Candidate rankedAlone(const char* name) const {
    const gap::Judge judge{*replay_, split_, gap::yardstickOf(*replay_, split_.held_out)};
    core::SilentProgress progress;
    return gap::rank(judge, {effect(name)}, gap::whereIn(*replay_, replay_->baseline(), 1), progress).front();
  }

  SmallWorld world_;
  model::Experiment measured_;
  std::optional<gap::Replay> replay_;
  gap::Split split_;
};

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

// One in five hundred shots: three frames of four samples hardly have such an echo, all that was measured has dozens.
TEST_F(Search, BeginsAtTheRateAtWhichFalseEchoesCame) {
  measure({{"false-alarm", {{"rate_per_beam", 0.002}}}});
  const auto where = gap::whereIn(*replay_, replay_->baseline(), 1);
  const auto starts = gap::startsFrom(*replay_, effect("false-alarm"), where);
  ASSERT_EQ(starts.size(), 1U);
  const double shots = 6.0 * 20.0 * 4.0 * 41.0;
  EXPECT_NEAR(starts[0][0], 0.002, 4.0 * std::sqrt(0.002 / shots));
  const auto of_pulses = gap::startsFrom(*replay_, effect("crosstalk"), where);
  ASSERT_FALSE(of_pulses.empty());
  EXPECT_NEAR(of_pulses[0][0] * 2.0 * 150.0 / 299792458.0, starts[0][0], 1e-9);
}

// What edges do in two programs is no false echo, so beams at edges are no shots either. Of a wall 3 m wide many are.
TEST_F(Search, CountsFalseEchoesOfTheBeamsThatItLooksAtOnly) {
  world_.withAWallOf(3.0);
  measure({{"false-alarm", {{"rate_per_beam", 0.1}}}});
  const auto where = gap::whereIn(*replay_, replay_->baseline(), 1);
  const double shots = 6.0 * 20.0 * 4.0 * 37.0;  // without two columns at each edge: with them a tenth would be lost
  EXPECT_NEAR(where.false_echoes_per_shot, 0.1, 2.5 * std::sqrt(0.1 / shots));
}

// Within the echo separation, 0.8 m, two echoes are one, and its range lies between them.
TEST_F(Search, LooksForAFalseTargetOnBothSidesOfTheEchoThatItMayPull) {
  measure({});
  gap::WhereResult where;
  where.rows.push_back({.measurand = "range", .covariate = "azimuth_deg", .low = 4.0, .high = 6.0});
  where.rows.push_back({.measurand = "range", .covariate = "range_m", .low = 13.0, .high = 13.2});
  std::vector<double> ranges_m;
  for (const auto& start : gap::startsFrom(*replay_, effect("spoofing"), where)) {
    EXPECT_DOUBLE_EQ(start[0], 5.0);  // azimuth_deg
    ranges_m.push_back(start[1]);
  }
  using testing::DoubleNear;
  EXPECT_THAT(ranges_m,
              testing::UnorderedElementsAre(DoubleNear(12.7, 1e-9), DoubleNear(12.9, 1e-9), DoubleNear(13.1, 1e-9),
                                            DoubleNear(13.3, 1e-9), DoubleNear(13.5, 1e-9)));
}

// From an irradiance that saturates the receiver no step leads to a gain that gives way alone.
TEST_F(Search, BeginsWithEachStrengthOfALightAloneToo) {
  measure({});
  gap::WhereResult where;
  where.rows.push_back({.measurand = "intensity", .covariate = "azimuth_deg", .low = -6.0, .high = 4.0});
  const auto forms = gap::hypothesesFor(*replay_, {"blinding"});
  const gap::Hypothesis blinding = test_support::hypothesisNamed(forms, "blinding", "desensitised");
  ASSERT_EQ(blinding.parameters[1].name, "irradiance");
  ASSERT_EQ(blinding.parameters[3].name, "gain_loss");
  double largest_loss = 0.0;
  for (const auto& start : gap::startsFrom(*replay_, blinding, where)) {
    EXPECT_DOUBLE_EQ(start[0], -1.0);  // azimuth_deg
    if (start[1] < 5.0) largest_loss = std::max(largest_loss, start[3]);
  }
  EXPECT_GT(largest_loss, 0.5);
}

// A cloud returns echoes, as the model has it; one column of beams elsewhere sees a false target.
TEST_F(Search, LooksForAFalseTargetWhereTheModelExpectsNoEcho) {
  const SmallWorld::Effects cloud = {{"exhaust-cloud", {{"centre", {4.0, -0.7, 0.0}}, {"size_m", 1.5}}}};
  SmallWorld::Effects truth = cloud;
  truth["spoofing"] = {{"azimuth_deg", 5.0}, {"width_deg", 0.8}, {"range_m", 5.0}};
  measured_ = world_.measuredBy(SmallWorld::modelWith(truth), 0.4);
  replay_.emplace(measured_, SmallWorld::modelWith(cloud));
  split_ = gap::splitOf(*replay_, 1);
  const auto where = gap::whereIn(*replay_, replay_->baseline(), 1);
  const auto starts = gap::startsFrom(*replay_, effect("spoofing"), where);
  ASSERT_FALSE(starts.empty());
  EXPECT_NEAR(starts.back()[0], 5.0, 0.4);  // azimuth_deg
  EXPECT_NEAR(starts.back()[1], 5.0, 0.1);  // range_m
  EXPECT_NEAR(starts.back()[2], 1.0, 0.3);  // width_deg, of one beam
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

TEST_F(Search, SeesToABeamWhereASectorEnds) {
  measure({{"cover-contamination", {{"attenuation", 0.05}, {"azimuth_from_deg", -8.4}, {"azimuth_to_deg", 4.4}}}});
  const auto sectors = gap::whereIn(*replay_, replay_->baseline(), 1).sectors;
  ASSERT_FALSE(sectors.empty());
  EXPECT_NEAR(sectors[0].from_deg, -8.4, 0.6);
  EXPECT_NEAR(sectors[0].to_deg, 4.4, 0.6);
}

// Someone raised the power until the mean agreed: inside the sector less is wrong now than outside.
TEST_F(Search, SeesASectorThatDiffersLessThanItsSurroundings) {
  const SmallWorld::Effects dirt = {
      {"cover-contamination", {{"attenuation", 0.05}, {"azimuth_from_deg", -8.4}, {"azimuth_to_deg", 4.4}}}};
  const auto truth = SmallWorld::modelWith(dirt, {{"/sensor/emitter/peak_power_w", 53}});
  const auto measured = world_.measuredBy(truth, 0.4);
  const gap::Replay replay(measured, SmallWorld::modelWith({}));
  const auto sectors = gap::whereIn(replay, replay.baseline(), 1).sectors;
  EXPECT_TRUE(std::any_of(sectors.begin(), sectors.end(), [](const gap::Sector& sector) {
    return std::abs(sector.from_deg + 8.4) < 0.6 && std::abs(sector.to_deg - 4.4) < 0.6;
  }));
}

TEST_F(Search, SeesNoSectorWhereNothingDiffers) {
  measure({});
  EXPECT_TRUE(gap::whereIn(*replay_, replay_->baseline(), 1).sectors.empty());
}

// Three frames of four samples do not tell a sector of 34° from the whole view of 40°.
TEST_F(Search, FitsTheEndsOfASectorThatIsNearlyTheWholeView) {
  measure({{"cover-contamination", {{"attenuation", 0.02}, {"azimuth_from_deg", -17.4}, {"azimuth_to_deg", 16.4}}}});
  const gap::Candidate found = rankedAlone("cover-contamination");
  ASSERT_EQ(found.hypothesis.parameters[1].name, "azimuth_from_deg");
  EXPECT_NEAR(found.values[0], 0.02, 0.005);
  EXPECT_NEAR(found.values[1], -17.4, 0.6);
  EXPECT_NEAR(found.values[2], 16.4, 0.6);
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

// Fitted walls end at 13.9 m and begin at 27; the one that the gate cuts is held out.
TEST_F(Search, TakesWhatTheFittedSamplesLeaveOpenFromWhereEchoesAreLost) {
  measure({{"range-gating", {{"from_m", 19.6}, {"to_m", 1000.0}}}});
  const gap::Candidate found = rankedAlone("range-gating");
  ASSERT_EQ(found.hypothesis.parameters[0].name, "from_m");
  EXPECT_NEAR(found.values[0], 19.6, 0.1);
  EXPECT_GT(found.explained, 0.9);
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

/// A cause that moves the wall.
gap::Hypothesis movedBy(const char* name, double most, double m_per_unit) {
  gap::Hypothesis cause;
  cause.name = name;
  cause.parameters = {{"value", "", -most, most}};
  cause.apply = [m_per_unit](gap::World& world, const std::vector<double>& values) {
    world.references.push_back({"/scene/0/pose/position_m/0", m_per_unit * values[0], {}});
  };
  return cause;
}

// A car that is reported 4 ms late at 25 m/s stands 10 cm elsewhere; a delay might be a second, an offset half a metre.
TEST_F(Search, CannotTellTwoCausesOfOneNumberThatDoTheSameHoweverSmallTheNumber) {
  moveBy(0.1);
  const gap::Judge judge{*replay_, split_, gap::yardstickOf(*replay_, split_.held_out)};
  const gap::Candidate delay{.hypothesis = movedBy("delay", 1.0, 25.0), .values = {0.004}};
  const gap::Candidate offset{.hypothesis = movedBy("offset", 0.5, 1.0), .values = {0.1}};
  EXPECT_TRUE(gap::rivalsOf(judge, judge, {delay, offset}).front().tied());
  EXPECT_TRUE(gap::rivalsOf(judge, judge, {offset, delay}).front().tied());
}

TEST_F(Search, SaysWhoMayStandInThePlaceOfOneOfAPair) {
  moveBy(0.1);
  const gap::Judge judge{*replay_, split_, gap::yardstickOf(*replay_, split_.held_out)};
  const gap::Hypothesis loss = effect("detection-loss");
  const auto besideLoss = [&](const char* name, double offset_m) {
    return gap::Candidate{.hypothesis = gap::together(loss, movedBy(name, 0.5, 1.0)), .values = {0.01, offset_m}};
  };
  const auto rivals = gap::rivalsInPairs(
      judge, judge, {besideLoss("delay", 0.1), besideLoss("offset", 0.1), besideLoss("drift", 0.08)}, 0.5);
  ASSERT_EQ(rivals.size(), 2U);
  EXPECT_EQ(rivals[0].name, "offset");
  EXPECT_EQ(rivals[0].instead_of, "delay");
  EXPECT_TRUE(rivals[0].tied());
  EXPECT_EQ(rivals[1].name, "drift");
  EXPECT_FALSE(rivals[1].tied());

  gap::Decision decision;
  decision.name(besideLoss("delay", 0.1));
  decision.rivals = rivals;
  EXPECT_EQ(decision.ties(), std::vector<std::string>{"offset"});
  EXPECT_EQ(gap::shareOf(decision, "detection-loss"), 1.0);
  EXPECT_NEAR(gap::shareOf(decision, "delay"), 2.5 / 3.5, 0.01);  // what leads is 2.5 times as likely
  EXPECT_NEAR(gap::shareOf(decision, "offset"), 1.0 / 3.5, 0.01);
  decision.pairs = {besideLoss("delay", 0.1), besideLoss("drift", 0.08), besideLoss("offset", 0.1)};
  const auto tied = gap::tiedPairs(decision);
  ASSERT_EQ(tied.size(), 1U);
  EXPECT_EQ(tied[0].first, "offset");
  EXPECT_EQ(tied[0].second.hypothesis.name, decision.pairs[2].hypothesis.name);
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

// By the few beams with which causes are chosen a blooming led by 0.5; by all beams it is nothing.
TEST_F(Search, LooksAtFurtherCausesWhereAllBeamsSayLessOfTheFirst) {
  measure({{"range-offset", {{"offset_m", 0.1}}}});
  const gap::Judge judge{*replay_, split_, gap::yardstickOf(*replay_, split_.held_out)};
  const gap::HeldOutGaps gaps(*replay_, split_.held_out.samples, 1);
  std::vector<gap::Candidate> candidates{
      {.hypothesis = effect("blooming"), .values = {0.001}, .explained = 1.0, .merit = 0.9},
      {.hypothesis = effect("range-offset"), .values = {0.1}, .explained = 0.6, .merit = 0.4}};
  gap::polish(judge, gaps, candidates, gap::whereIn(*replay_, replay_->baseline(), 1), core::SilentProgress());
  EXPECT_EQ(candidates.front().hypothesis.name, "range-offset");
  EXPECT_GT(candidates.front().merit, 0.9);
}

// At the one range that is held out, an offset and a scale do the same; those that were fitted tell them apart.
TEST_F(Search, TellsCausesByTheFittedSamplesThatTheHeldOutOnesCannotTell) {
  measure({{"range-offset", {{"offset_m", 0.02}}}});
  for (model::Sample& sample : measured_.samples)
    sample.role = sample.id == "r19" ? model::Role::kPrediction : model::Role::kCalibration;
  replay_.emplace(measured_, SmallWorld::modelWith({}));
  split_ = gap::splitOf(*replay_, 1);
  const gap::Judge judge{*replay_, split_, gap::yardstickOf(*replay_, split_.held_out)};
  const double range_m = gap::situationIn(replay_->baseline(), measured_, *replay_->samples()[2].sample)
                             .scene.objects.front()
                             .pose.position_m[0];
  const gap::Candidate offset{.hypothesis = effect("range-offset"), .values = {0.02}};
  const gap::Candidate drift{.hypothesis = effect("clock-drift"), .values = {1e6 * 0.02 / range_m}};
  EXPECT_LT(std::abs(gap::separation(judge, offset, drift)), 1.5);
  EXPECT_GT(gap::separationOnAll(judge, judge, offset, drift, 0.03), 4.0);
  EXPECT_LE(gap::separationOnAll(judge, judge, drift, offset, 0.03), 0.0);
  EXPECT_EQ(gap::separationOnAll(judge, judge, offset, offset, 0.03), 0.0);
}

// Of 0.01 to 1, searched in its logarithm, to 13 bits of that range: ln(100) / 8192 of the value.
TEST(Resolved, IsTheStepOfTheSearchAtThatValue) {
  const gap::FreeParameter parameter{"value", "", 0.01, 1.0, true, 0.1};
  EXPECT_NEAR(gap::resolvedAt(parameter, 0.2), 0.2 * std::log(100.0) / 8192.0, 1e-7);
}

/// Causes of which each moves the wall by its first number.
class MovedWall : public Search {
 protected:
  [[nodiscard]] static gap::Hypothesis cause(const std::string& name) {
    gap::Hypothesis hypothesis;
    hypothesis.name = name;
    hypothesis.parameters = {{"offset", "m", -0.5, 0.5, false, 0.0}};
    hypothesis.apply = [](gap::World& world, const std::vector<double>& values) {
      world.references.push_back({"/scene/0/pose/position_m/0", values[0], {}});
    };
    return hypothesis;
  }
  [[nodiscard]] gap::Judge judge() const { return {*replay_, split_, gap::yardstickOf(*replay_, split_.held_out)}; }
  /// The variants that are tried of a cause, one of which takes long to fit.
  [[nodiscard]] std::vector<std::string> tried() const {
    gap::Hypothesis costly = cause("elsewhere");
    costly.variant = "costly";
    costly.costly = true;
    core::SilentProgress progress;
    std::vector<std::string> variants;
    for (const gap::Candidate& candidate : gap::rank(judge(), {costly, cause("elsewhere")}, {}, progress))
      variants.push_back(candidate.hypothesis.variant);
    return variants;
  }
};

TEST_F(MovedWall, IsTriedInACostlyFormWhereTheUsualOneExplainsSomething) {
  moveBy(0.1);
  EXPECT_THAT(tried(), testing::UnorderedElementsAre("", "costly"));
}

TEST_F(MovedWall, IsNotTriedInACostlyFormWhereTheUsualOneExplainsNothing) {
  moveBy(0.0);
  EXPECT_THAT(tried(), testing::ElementsAre(""));
}

// Of two causes that say the same with one number neither can be preferred; one that needs a second number for it can
// be left aside.
TEST_F(MovedWall, IsNotToldFromATwinButFromACauseWithAnIdleNumber) {
  moveBy(0.1);
  gap::Hypothesis idle = cause("with an idle number");
  idle.parameters.push_back({"idle", "", 1.0, 2.0, false, 1.5});
  const gap::HeldOutGaps gaps(*replay_, split_.held_out.samples, 1);
  core::SilentProgress progress;
  const gap::Decision decision =
      gap::decide(judge(), judge(), gaps, true, {}, {cause("elsewhere"), cause("twin"), idle}, progress);
  ASSERT_TRUE(decision.winner.has_value());
  std::vector<std::string> alike = decision.ties();
  alike.push_back(decision.winner->hypothesis.name);
  EXPECT_THAT(alike, testing::UnorderedElementsAre("elsewhere", "twin"));
}

class Merit : public Search {
 protected:
  void SetUp() override { measure({}); }
  /// Of 900 that there are to explain.
  [[nodiscard]] double of(gap::Candidate candidate, double weight_of_total) const {
    return gap::Judge{*replay_, split_, {.baseline = 1000.0, .perfect = 100.0, .perfect_spread = 5.0}, weight_of_total}
        .meritOf(candidate);
  }
  [[nodiscard]] static gap::Candidate candidate(double explained, double discrepancy, std::size_t numbers = 0) {
    gap::Candidate candidate{.explained = explained, .discrepancy = discrepancy};
    candidate.hypothesis.parameters.resize(numbers);
    return candidate;
  }
};

TEST_F(Merit, ExcusesAWorldForHalfOfItsNoise) {
  EXPECT_DOUBLE_EQ(of(candidate(1.0, 550.0), 0.0), 0.75);  // half of the way, and all of it but for noise
}

TEST_F(Merit, FallsWithWhatIsLeftOfTheTotalGap) {
  gap::Candidate cause = candidate(0.9, 190.0);
  cause.total_left = 0.5;
  EXPECT_DOUBLE_EQ(of(cause, 0.3), 0.9 - 0.15);
  cause.total_left = 7.0;  // twice the gap is as wrong as seven times the gap
  EXPECT_DOUBLE_EQ(of(cause, 0.3), 0.9 - 0.6);
}

TEST_F(Merit, EveryFreeNumberCostsHalfTheLogarithmOfTheCells) {
  EXPECT_NEAR(of(candidate(0.9, 190.0, 8), 0.0), 0.9 - 8 * 4.0 / 900.0, 1e-12);
}

}  // namespace
