#include "gap/causes/hypotheses.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <set>

#include "core/json_object.h"
#include "core/physics.h"
#include "gap/causes/fit.h"
#include "gap/causes/layer_gains.h"
#include "model/simulate.h"
#include "tests/gap/hypothesis_named.h"
#include "tests/gap/small_world.h"

namespace {

using test_support::SmallWorld;

// A number of the model file is searched in the unit that the ending of its name says.
TEST(Hypotheses, AWrongNumberOfTheModelHasTheUnitOfItsKey) {
  const SmallWorld world;
  const auto model = SmallWorld::modelWith({{"mounting-error", {{"yaw_deg", 0.3}}},
                                            {"atmospheric-attenuation", {{"visibility_m", 400}}},
                                            {"detection-loss", {{"probability", 0.1}}}});
  const auto measured = world.measuredBy(model, 0.4);
  const gap::Replay replay(measured, model);
  std::map<std::string, std::string> units;
  for (const gap::Hypothesis& hypothesis : gap::hypothesesFor(replay, {})) {
    if (hypothesis.kind == gap::CauseKind::kParameter) units[hypothesis.name] = hypothesis.parameters.at(0).unit;
  }
  const std::map<std::string, std::string> expected = {{"/sensor/emitter/peak_power_w", "W"},
                                                       {"/sensor/emitter/pulse_fwhm_ns", "ns"},
                                                       {"/sensor/emitter/divergence_rad/horizontal", "rad"},
                                                       {"/sensor/emitter/divergence_rad/vertical", "rad"},
                                                       {"/sensor/receiver/noise_w", "W"},
                                                       {"/sensor/receiver/threshold_w", "W"},
                                                       {"/sensor/detection/range_noise_m", "m"},
                                                       {"/sensor/detection/epw_noise_m", "m"},
                                                       {"/effects/mounting-error/yaw_deg", "deg"},
                                                       {"/effects/atmospheric-attenuation/visibility_m", "m"},
                                                       {"/effects/detection-loss/probability", ""}};
  for (const auto& [pointer, unit] : expected) {
    ASSERT_TRUE(units.contains(pointer)) << pointer;
    EXPECT_EQ(units.at(pointer), unit) << pointer;
  }
}

// A sensor may be turned about any of its axes, and only one of them at once is tried beside yaw and pitch.
TEST(Hypotheses, AnEffectIsTriedInEveryFormThatItDeclares) {
  const SmallWorld world;
  const auto model = SmallWorld::modelWith({});
  const auto measured = world.measuredBy(model, 0.4);
  const gap::Replay replay(measured, model);
  const auto all = gap::hypothesesFor(replay, {"mounting-error"});
  const auto roll = std::find_if(all.begin(), all.end(), [](const gap::Hypothesis& h) { return h.variant == "roll"; });
  ASSERT_NE(roll, all.end());
  const gap::World turned = gap::worldOf(replay, *roll, {0.7});
  EXPECT_EQ(turned.model.effects.back().parameters.numbers, (std::map<std::string, double>{{"roll_deg", 0.7}}));
}

// An azimuth has neither a sign nor a size that a ratio of the recorded one would keep.
TEST(Hypotheses, AnAzimuthOfAnActiveEffectMayLieAnywhere) {
  const SmallWorld world;
  const auto model = SmallWorld::modelWith(
      {{"cover-contamination", {{"attenuation", 0.2}, {"azimuth_from_deg", -3.0}, {"azimuth_to_deg", 4.0}}}});
  const auto measured = world.measuredBy(model, 0.4);
  const gap::Replay replay(measured, model);
  const gap::Hypothesis to =
      test_support::hypothesisNamed(gap::hypothesesFor(replay, {}), "/effects/cover-contamination/azimuth_to_deg");
  EXPECT_TRUE(to.parameters.at(0).azimuth);
  EXPECT_LT(to.parameters.at(0).low, -30.0);
  EXPECT_GT(to.parameters.at(0).high, 40.0);
}

// Offsets are named after their set-ups, which people name as they like.
TEST(Hypotheses, AnOffsetIsNoAzimuthWhateverItsSetUpIsCalled) {
  const SmallWorld world;
  const auto model = SmallWorld::modelWith({});
  auto measured = world.measuredBy(model, 0.4);
  for (model::Sample& sample : measured.samples) sample.setup = "azimuth_" + sample.id;
  const gap::Replay replay(measured, model);
  const gap::Hypothesis varying =
      test_support::hypothesisNamed(gap::hypothesesFor(replay, {}), "/scene/0/pose/position_m/0", "per set-up");
  ASSERT_EQ(varying.parameters.size(), measured.samples.size());
  for (const gap::FreeParameter& offset : varying.parameters) EXPECT_FALSE(offset.azimuth) << offset.name;
}

// Where both numbers of it are free, whatever scatters by one number fits as well and is simpler.
TEST(Hypotheses, APulseMayJitterInItsPowerAloneOrInItsDurationAlone) {
  const SmallWorld world;
  const auto model = SmallWorld::modelWith({});
  const auto measured = world.measuredBy(model, 0.4);
  const gap::Replay replay(measured, model);
  std::set<std::vector<std::string>> free;
  for (const gap::Hypothesis& hypothesis : gap::hypothesesFor(replay, {"pulse-jitter"})) {
    if (hypothesis.name != "pulse-jitter") continue;
    std::vector<std::string> names;
    for (const gap::FreeParameter& parameter : hypothesis.parameters) names.push_back(parameter.name);
    free.insert(names);
  }
  EXPECT_EQ(free, (std::set<std::vector<std::string>>{
                      {"duration_stddev_ns", "power_stddev"}, {"duration_stddev_ns"}, {"power_stddev"}}));
}

// Noise of 2 nW takes one echo in seven hundred of a receiver that clips 6 nW above its threshold of 20 nW: nearer to
// it, clipping would be another name for lost shots.
TEST(Hypotheses, AReceiverClipsAboveItsNoise) {
  const SmallWorld world;
  const auto model = SmallWorld::modelWith({});
  const auto measured = world.measuredBy(model, 0.4);
  const gap::Replay replay(measured, model);
  std::size_t forms = 0;
  for (const gap::Hypothesis& hypothesis : gap::hypothesesFor(replay, {"saturation"})) {
    if (hypothesis.name != "saturation") continue;
    ASSERT_EQ(hypothesis.parameters.front().name, "saturation_w");
    EXPECT_DOUBLE_EQ(hypothesis.parameters.front().low, 26e-9);
    ++forms;
  }
  EXPECT_EQ(forms, 3U);
}

// A sensor that reports the leading edge already walks as it is; its calibration is a constant offset, which has a
// name.
TEST(Hypotheses, OfASensorThatReportsTheLeadingEdgeOnlyALinearFrontIsARangeWalk) {
  const SmallWorld world;
  const auto formsOf = [&](const char* range_mode) {
    auto json = SmallWorld::modelWith({}).json;
    json["sensor"]["detection"]["range_mode"] = range_mode;
    const auto model = model::parseModel(json, "model.json");
    const auto measured = world.measuredBy(model, 0.4);
    const gap::Replay replay(measured, model);
    std::set<std::string> variants;
    for (const gap::Hypothesis& hypothesis : gap::hypothesesFor(replay, {"range-walk"}))
      if (hypothesis.name == "range-walk") variants.insert(hypothesis.variant);
    return variants;
  };
  EXPECT_EQ(formsOf("peak"), (std::set<std::string>{"", "bare crossing", "linear front"}));
  EXPECT_EQ(formsOf("leading-edge"), (std::set<std::string>{"linear front"}));
}

TEST(Hypotheses, EndsOfASectorThatASearchCrossedStandInOrder) {
  const std::vector<gap::FreeParameter> cover{
      {.name = "attenuation"}, {.name = "azimuth_from_deg"}, {.name = "azimuth_to_deg"}};
  EXPECT_EQ(gap::inOrder(cover, {0.9, 20.0, -5.0}), (std::vector<double>{0.9, -5.0, 20.0}));
  EXPECT_EQ(gap::inOrder(cover, {0.9, -5.0, 20.0}), (std::vector<double>{0.9, -5.0, 20.0}));
  EXPECT_EQ(gap::inOrder({{.name = "factor"}, {.name = "window"}}, {9.0, 5.0}), (std::vector<double>{9.0, 5.0}));
}

// What stands within its recorded uncertainty is where it may be: no error of the reference, however well it fits.
TEST(Hypotheses, AReferenceIsWrongOnlyBeyondWhatIsRecordedOfIt) {
  SmallWorld world;
  const auto model = SmallWorld::modelWith({});
  const auto unknown = world.measuredBy(model, 0.4);
  const auto known = world.knownToWithin(0.01).measuredBy(model, 0.4);
  const gap::Replay without(unknown, model), within(known, model);
  const auto all = gap::hypothesesFor(within, {"range-offset"});
  const auto constant = std::find_if(all.begin(), all.end(), [](const gap::Hypothesis& h) {
    return h.name == "/scene/0/pose/position_m/0" && !h.per_setup;
  });
  const auto varying = std::find_if(all.begin(), all.end(), [](const gap::Hypothesis& h) {
    return h.name == "/scene/0/pose/position_m/0" && h.per_setup;
  });
  ASSERT_NE(constant, all.end());
  ASSERT_NE(varying, all.end());
  EXPECT_TRUE(gap::asRecorded(within, *constant, {-0.008}));
  EXPECT_FALSE(gap::asRecorded(within, *constant, {0.012}));
  EXPECT_FALSE(gap::asRecorded(without, *constant, {0.001}));  // nothing was recorded of it
  std::vector<double> offsets(varying->parameters.size(), 0.005);
  EXPECT_TRUE(gap::asRecorded(within, *varying, offsets));
  offsets.back() = -0.02;  // one set-up is enough
  EXPECT_FALSE(gap::asRecorded(within, *varying, offsets));
  EXPECT_FALSE(gap::asRecorded(within, all.front(), {0.001}));  // an effect
}

// Who forgot that a beam has a width means the profile's; another width is another thing to be wrong about.
TEST(Hypotheses, BeamDivergenceIsTriedWithTheWidthOfTheProfileFirst) {
  const SmallWorld world;
  auto json = SmallWorld::modelWith({}).json;
  json["effects"].erase("beam-divergence");
  const auto measured = world.measuredBy(SmallWorld::modelWith({}), 0.4);
  const gap::Replay replay(measured, model::parseModel(json, "small-model.json"));
  std::vector<std::size_t> free_numbers;
  for (const gap::Hypothesis& h : gap::hypothesesFor(replay, {"beam-divergence"}))
    if (h.name == "beam-divergence") free_numbers.push_back(h.parameters.size());
  EXPECT_EQ(free_numbers, (std::vector<std::size_t>{0, 2}));
}

// Every surface may mirror, so second bounces are traced once, and only their power depends on how much of it does.
TEST(Hypotheses, NumbersThatChangeOnlyThePowerShareOneGeometry) {
  const SmallWorld world;
  const auto measured = world.measuredBy(SmallWorld::modelWith({}), 0.4);
  const auto keyWith = [&](const nlohmann::json& multipath) {
    return gap::geometryKey({.model = SmallWorld::modelWith({{"multipath", multipath}})}, measured.samples.front());
  };
  EXPECT_EQ(keyWith({{"specular_fraction", 0.1}}), keyWith({{"specular_fraction", 0.4}}));
  EXPECT_NE(keyWith({{"specular_fraction", 0.1}}), keyWith(nlohmann::json::object()));
  EXPECT_NE(keyWith({{"specular_fraction", 0.1}}), keyWith({{"specular_fraction", 0.1}, {"max_bounces", 3}}));
}

TEST(Hypotheses, ACauseBesideAnotherMakesTheWorldThatBothMakeTogether) {
  const SmallWorld world;
  const auto measured = world.measuredBy(SmallWorld::modelWith({}), 0.4);
  const gap::Replay replay(measured, SmallWorld::modelWith({}));
  const auto effect = [&](const std::string& name) { return gap::hypothesesFor(replay, {name}).front(); };
  const gap::Hypothesis fog = effect("atmospheric-attenuation"), loss = effect("detection-loss");
  const gap::Hypothesis added = gap::beside(fog, {500.0}, loss);
  EXPECT_EQ(added.name, "detection-loss");
  EXPECT_EQ(gap::worldOf(replay, added, {0.1}).model.json,
            gap::worldOf(replay, gap::together(fog, loss), {500.0, 0.1}).model.json);
  EXPECT_NE(gap::worldOf(replay, added, {0.1}).model.json, gap::worldOf(replay, loss, {0.1}).model.json);
}

/// A world, and how uneven the layers seem to be in it.
struct SeenUneven {
  explicit SeenUneven(const model::LidarModel& truth)
      : measured(world.measuredBy(truth, 0.4)), replay(measured, SmallWorld::modelWith({})) {}

  SmallWorld world;
  model::Experiment measured;
  gap::Replay replay;
  gap::Hypothesis uneven = gap::hypothesesFor(replay, {"photo-response-nonuniformity"}).front();
};

/// Gains of the layers as the hypothesis has them at the strength that the data show.
std::vector<double> gainsSeenIn(const model::LidarModel& truth) {
  const SeenUneven seen_uneven(truth);
  const gap::Hypothesis& uneven = seen_uneven.uneven;
  const gap::World seen = gap::worldOf(seen_uneven.replay, uneven, {uneven.parameters.front().start});
  for (const model::ActiveEffect& effect : seen.model.effects)
    if (effect.name == uneven.name) return effect.parameters.lists.at("gain_per_layer");
  return {};
}

TEST(Hypotheses, AFactorThatAllLayersShareIsNoUnevenness) {
  for (const double gain : gainsSeenIn(SmallWorld::modelWith({}, {{"/sensor/emitter/peak_power_w", 55.0}})))
    EXPECT_NEAR(gain, 1.0, 0.01);
}

// Layers that look over everything receive nothing, with any emitter.
TEST(Hypotheses, AFactorThatAllLayersShareWhichSeeAnythingIsNoUnevenness) {
  std::vector<double> gains(16, NAN);
  for (std::size_t layer = 0; layer < 6; ++layer) gains[layer] = layer % 2 == 0 ? 0.49 : 0.51;
  const std::vector<double> uneven = gap::unevenPartOf(gains);
  for (std::size_t layer = 0; layer < 6; ++layer) EXPECT_NEAR(uneven[layer], 1.0, 0.03);
  for (std::size_t layer = 6; layer < 16; ++layer) EXPECT_TRUE(std::isnan(uneven[layer]));
}

TEST(Hypotheses, OneLayerAloneIsNotUneven) {
  EXPECT_DOUBLE_EQ(gap::unevenPartOf({NAN, 0.5, NAN})[1], 1.0);
  EXPECT_TRUE(std::isnan(gap::unevenPartOf({NAN, NAN})[0]));
}

// Student's t of the logarithms of these four gains is 9.55; one in 410 of three degrees of freedom is as far from 0.
TEST(Hypotheses, LayersThatAllGainNearlyTheSameAreHardlyUneven) {
  const auto nearlyEven =
      SmallWorld::modelWith({{"photo-response-nonuniformity", {{"gain_per_layer", {1.2, 1.35, 1.25, 1.3}}}}});
  EXPECT_NEAR(SeenUneven(nearlyEven).uneven.improbable_nats, std::log(410.0), 1.0);
  const auto uneven =
      SmallWorld::modelWith({{"photo-response-nonuniformity", {{"gain_per_layer", {1.2, 0.85, 1.1, 0.9}}}}});
  EXPECT_LT(SeenUneven(uneven).uneven.improbable_nats, 0.5);
  EXPECT_EQ(gap::hypothesesFor(SeenUneven(uneven).replay, {"detection-loss"}).front().improbable_nats, 0.0);
}

// Surfaces that mirror where nothing stands in the mirror take a share of the light, as dirt and a weak emitter do.
TEST(Hypotheses, MirrorsAreTriedOnlyWhereTheyShowAnything) {
  const auto mirrorsIn = [](const SmallWorld& world, const SmallWorld::Effects& effects) {
    const auto measured = world.measuredBy(SmallWorld::modelWith(effects), 0.4);
    const gap::Replay replay(measured, SmallWorld::modelWith(effects));
    const auto all = gap::hypothesesFor(replay, {"multipath"});
    return std::count_if(all.begin(), all.end(), [](const gap::Hypothesis& h) { return h.name == "multipath"; });
  };
  const SmallWorld::Effects panes = {{"transmission", nlohmann::json::object()}};
  EXPECT_EQ(mirrorsIn(SmallWorld(), {}), 0);
  EXPECT_EQ(mirrorsIn(SmallWorld(), panes), 0);
  SmallWorld glazed;
  glazed.behindAPane(5.0);
  EXPECT_GT(mirrorsIn(glazed, panes), 0);  // the wall shows the pane its back
}

// Their mean is one only by chance, and four gains that scatter by 0.15 may well have one of 1.02.
TEST(Hypotheses, AnUnevennessIsSeenAsItIsAndBesideAWeakEmitterWithoutTheFactorOfThat) {
  const std::vector<double> gains = {1.15, 0.9, 1.08, 0.95};
  const SmallWorld::Effects uneven = {{"photo-response-nonuniformity", {{"gain_per_layer", gains}}}};
  const std::vector<double> seen = gainsSeenIn(SmallWorld::modelWith(uneven));
  const std::vector<double> dimmed =
      gainsSeenIn(SmallWorld::modelWith(uneven, {{"/sensor/emitter/peak_power_w", 15.0}}));
  ASSERT_EQ(seen.size(), gains.size());
  ASSERT_EQ(dimmed.size(), gains.size());
  const double shared = std::pow(1.15 * 0.9 * 1.08 * 0.95, 0.25);
  for (std::size_t layer = 0; layer < gains.size(); ++layer) {
    EXPECT_NEAR(seen[layer], gains[layer], 0.01) << layer;
    EXPECT_NEAR(dimmed[layer], gains[layer] / shared, 0.015) << layer;
  }
}

/// Ten boards side by side, each so much farther than in front of the sensor.
nlohmann::json boardsAt(nlohmann::json experiment, const std::vector<double>& offsets_m) {
  constexpr double kAway_m = 8.0, kApart_deg = 4.0;
  const nlohmann::json wall = experiment["scene"][0];
  experiment["scene"] = nlohmann::json::array();
  for (std::size_t b = 0; b < offsets_m.size(); ++b) {
    const double azimuth_rad = (18.0 - kApart_deg * static_cast<double>(b)) * core::kRadPerDeg;
    nlohmann::json board = wall;
    board["id"] = "board-" + std::to_string(b);
    board["shape"]["width_m"] = 0.5;
    board["pose"]["position_m"] = {kAway_m + offsets_m[b], kAway_m * std::tan(azimuth_rad), 0.0};
    experiment["scene"].push_back(board);
  }
  for (auto& sample : experiment["samples"]) sample.erase("patch");
  return experiment;
}

// More poses than eight would cost minutes; the one that is off most must be among them, wherever it stands in the
// file.
TEST(Hypotheses, ThePosesOfTheObjectsThatDeviateMostAreTried) {
  const SmallWorld world;
  const auto model = SmallWorld::modelWith({});
  std::vector<double> offsets_m(10, 0.1);
  offsets_m.back() = 0.3;
  const auto real = model::parseExperiment(boardsAt(world.recorded(), offsets_m), world.folder() / "real.json");
  core::SilentProgress progress;
  model::simulatePackage(real, model, world.folder() / "boards", 4711, progress);
  core::writeJson(world.folder() / "boards" / "experiment.json",
                  boardsAt(world.recorded(), std::vector<double>(offsets_m.size(), 0.0)));
  const auto measured = model::readExperiment(world.folder() / "boards");
  const gap::Replay replay(measured, model);
  std::set<std::string> distances;
  for (const gap::Hypothesis& hypothesis : gap::hypothesesFor(replay, {})) {
    if (hypothesis.kind == gap::CauseKind::kReference && hypothesis.name.ends_with("/position_m/0"))
      distances.insert(hypothesis.name);
  }
  EXPECT_EQ(distances.size(), 8U);
  EXPECT_TRUE(distances.contains("/scene/9/pose/position_m/0"));
}

}  // namespace
