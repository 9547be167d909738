#include "gap/hypotheses.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <map>

#include "gap/fit.h"
#include "tests/gap/small_world.h"

// A number of the model file is searched in the unit that the ending of its name says.
namespace {

using test_support::SmallWorld;

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

}  // namespace
