#include "model/lidar_model.h"

#include <gtest/gtest.h>

#include "tests/model/lab.h"

namespace model {
namespace {

std::string refusalOf(const nlohmann::json& json) {
  return lab::refusal([&] { (void)parseModel(json, "model.json"); });
}

TEST(LidarModel, EffectsStandInTheOrderOfTheChain) {
  lab::Case setup;
  setup.effects = {{"angle-clipping", nlohmann::json::object()},
                   {"range-offset", {{"offset_m", 0.1}}},
                   {"beam-divergence", nlohmann::json::object()},
                   {"atmospheric-attenuation", {{"visibility_m", 500}}}};
  const LidarModel model = lab::modelOf(setup);
  ASSERT_EQ(model.effects.size(), 4u);
  EXPECT_EQ(model.effects[0].name, "beam-divergence");
  EXPECT_EQ(model.effects[1].name, "atmospheric-attenuation");
  EXPECT_TRUE(model.has("range-offset"));
  EXPECT_FALSE(model.has("speckle"));
}

TEST(LidarModel, FaultsAreNamed) {
  nlohmann::json json = lab::modelJson({});
  json["effects"] = {{"atmospheric-atenuation", nlohmann::json::object()}};
  EXPECT_NE(refusalOf(json).find("/effects/atmospheric-atenuation: is not an effect of this library.\n  Did you mean "
                                 "'atmospheric-attenuation'?"),
            std::string::npos);
  json["effects"] = {{"atmospheric-attenuation", {{"visibilty_m", 100}}}};
  EXPECT_NE(refusalOf(json).find("Did you mean 'visibility_m'?"), std::string::npos);
  json["effects"] = {{"atmospheric-attenuation", {{"visibility_m", 1}}}};
  EXPECT_NE(refusalOf(json).find("/effects/atmospheric-attenuation/visibility_m: is 1; it must be at least 20"),
            std::string::npos);
  json = lab::modelJson({});
  json["rays_per_beam"] = {0, 5};
  EXPECT_NE(refusalOf(json).find("/rays_per_beam"), std::string::npos);
  json["rays_per_beam"] = {5};
  EXPECT_NE(refusalOf(json).find("/rays_per_beam: has 1 elements"), std::string::npos);
  json = lab::modelJson({});
  json["format"] = "fidelis-sensor";
  EXPECT_NE(refusalOf(json).find("/format"), std::string::npos);
}

TEST(LidarModel, SensorsOfAModelMatchThoseOfTheExperimentByName) {
  nlohmann::json json = lab::modelJson({});
  json["sensors"] = {{"a", json["sensor"]}, {"b", json["sensor"]}};
  json.erase("sensor");
  const LidarModel model = parseModel(json, "model.json");
  EXPECT_NO_THROW((void)model.sensor("b"));
  EXPECT_NE(lab::refusal([&] { (void)model.sensor("c"); }).find("has no sensor 'c'"), std::string::npos);
}

TEST(LidarModel, AnEffectMayActOnSomeSensorsOnly) {
  nlohmann::json json = lab::modelJson({});
  json["sensors"] = {{"a", json["sensor"]}, {"b", json["sensor"]}};
  json.erase("sensor");
  json["effects"] = {{"beam-divergence", nlohmann::json::object()},
                     {"range-offset", {{"offset_m", 0.1}, {"sensors", {"b"}}}}};
  const LidarModel model = parseModel(json, "model.json");
  EXPECT_EQ(model.effectsOf("a").size(), 1u);
  ASSERT_EQ(model.effectsOf("b").size(), 2u);
  EXPECT_EQ(model.effectsOf("b")[1].name, "range-offset");
  const LidarModel more = withEffect(model, {"range-walk", {}, {"a"}});
  EXPECT_EQ(parseModel(more.json, "model.json").effectsOf("a").size(), 2u);

  json["effects"]["range-offset"]["sensors"] = {"c"};
  EXPECT_NE(refusalOf(json).find("/effects/range-offset/sensors: names 'c', which is no sensor of this model."),
            std::string::npos);
}

TEST(LidarModel, OneMoreEffectIsAddedAtItsPlaceAndInTheJson) {
  lab::Case setup;
  setup.effects = {{"beam-divergence", nlohmann::json::object()}, {"range-offset", {{"offset_m", 0.1}}}};
  EffectParameters parameters;
  parameters.numbers["visibility_m"] = 300;
  const LidarModel more = withEffect(lab::modelOf(setup), {"atmospheric-attenuation", parameters, {}});
  ASSERT_EQ(more.effects.size(), 3u);
  EXPECT_EQ(more.effects[1].name, "atmospheric-attenuation");
  const LidarModel again = parseModel(more.json, "model.json");
  EXPECT_EQ(again.effects[1].parameters.number("visibility_m"), 300.0);
  parameters.numbers["visibility_m"] = 400;
  const LidarModel other = withEffect(more, {"atmospheric-attenuation", parameters, {}});
  EXPECT_EQ(other.effects.size(), 3u);
  EXPECT_EQ(other.effects[1].parameters.number("visibility_m"), 400.0);
  EffectParameters shifted;
  shifted.lists["position_m"] = {0.1, 0, -0.2};
  const LidarModel mounted = withEffect(other, {"mounting-error", shifted, {}});
  EXPECT_EQ(mounted.json["effects"]["mounting-error"]["position_m"], nlohmann::json({0.1, 0.0, -0.2}));
}

}  // namespace
}  // namespace model
