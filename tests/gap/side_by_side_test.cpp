#include <gtest/gtest.h>

#include "core/json_object.h"
#include "gap/causes/layer_gains.h"
#include "gap/causes/split.h"
#include "gap/diagnosis.h"
#include "gap/report/json.h"
#include "model/simulate.h"
#include "tests/gap/small_world.h"

// Two sensors that measured the same set-ups side by side: what both see alike belongs to the reference or to the
// world, what one sees alone to that sensor.
namespace {

using nlohmann::json;
using test_support::SmallWorld;

/// The small world with the sensors "left" and "right", both of which measure every set-up of the ladder.
class SideBySide {
 public:
  [[nodiscard]] static model::LidarModel modelWith(const SmallWorld::Effects& effects) {
    json value = SmallWorld::modelWith({}).json;
    value["sensors"] = {{"left", value["sensor"]}, {"right", value["sensor"]}};
    value["sensors"]["right"]["emitter"]["peak_power_w"] = 35;
    value.erase("sensor");
    for (const auto& [name, parameters] : effects) value["effects"][name] = parameters;
    return model::parseModel(value, "two.json");
  }

  /// Measured by `truth`; the wall stands `offset_m` (by set-up) farther than recorded.
  [[nodiscard]] model::Experiment measuredBy(const model::LidarModel& truth,
                                             const std::map<std::string, double>& offset_m = {}) const {
    core::SilentProgress progress;
    const auto real = model::parseExperiment(experiment(offset_m), folder_ / "experiment.json");
    model::simulatePackage(real, truth, folder_ / "measured", 4711, progress);
    core::writeJson(folder_ / "measured" / "experiment.json", experiment({}));
    return model::readExperiment(folder_ / "measured");
  }

 private:
  [[nodiscard]] static json experiment(const std::map<std::string, double>& offset_m) {
    json value = SmallWorld().recorded(offset_m);
    const json model = modelWith({}).json;
    value["sensors"] = model["sensors"];
    value.erase("sensor");
    json samples = json::array();
    for (const json& sample : value["samples"]) {
      for (const char* sensor : {"left", "right"}) {
        json own = sample;
        own["setup"] = sample["id"];
        own["sensor"] = sensor;
        own["id"] = sample["id"].get<std::string>() + "-" + sensor;
        own["frames"] = 12;
        own["measurements"] = "measurements/" + own["id"].get<std::string>() + ".csv";
        samples.push_back(own);
      }
    }
    value["samples"] = samples;
    return value;
  }

  test_support::TemporaryFolder folder_;
};

gap::Diagnosis diagnosed(const model::Experiment& experiment, const std::vector<std::string>& library) {
  core::SilentProgress progress;
  return gap::diagnose(experiment, SideBySide::modelWith({}), {.library = library}, progress);
}

TEST(SideBySideDiagnosis, AnOffsetOfOneSensorIsThatSensorsThoughTheReferenceIsShared) {
  const SideBySide world;
  const auto truth = SideBySide::modelWith({{"range-offset", {{"offset_m", 0.06}, {"sensors", {"right"}}}}});
  const gap::Diagnosis diagnosis = diagnosed(world.measuredBy(truth), {"range-offset", "clock-drift"});
  ASSERT_EQ(diagnosis.verdict.names, std::vector<std::string>{"range-offset"});
  const gap::Cause& cause = diagnosis.causes.front();
  EXPECT_EQ(cause.sensors, std::vector<std::string>{"right"});
  EXPECT_NEAR(cause.parameters.front().value, 0.06, 0.003);
  EXPECT_NE(diagnosis.verdict.text.find("range-offset (sensor right only)"), std::string::npos);

  const auto report = gap::reportJson(diagnosis);
  EXPECT_EQ(report["causes"][0]["sensors"].dump(), R"(["right"])");
  const auto proposed = model::parseModel(diagnosis.proposed_model, "proposed.json");
  EXPECT_TRUE(proposed.effectsOf("right").size() == proposed.effectsOf("left").size() + 1);
}

TEST(SideBySideDiagnosis, WhatBothSensorsSeeInOneSetUpIsTheReference) {
  const SideBySide world;
  const auto measured = world.measuredBy(SideBySide::modelWith({}), {{"r13", 0.12}, {"r36", -0.08}});
  const gap::Diagnosis diagnosis = diagnosed(measured, {"range-offset", "clock-drift", "range-walk"});
  EXPECT_EQ(diagnosis.verdict.kind, gap::VerdictKind::kReference);
  EXPECT_EQ(diagnosis.verdict.names, std::vector<std::string>{"/scene/0/pose/position_m/0"});
  EXPECT_TRUE(diagnosis.causes.front().sensors.empty());
}

// One profile for sensors of one kind need not stand twice in the model; the proposed model says which of them it is.
TEST(SideBySideDiagnosis, AModelOfOneUnnamedSensorStandsForBoth) {
  json one = SideBySide::modelWith({}).json, two = one;
  one["sensor"] = one["sensors"]["left"];
  one.erase("sensors");
  two["sensors"]["right"] = two["sensors"]["left"];
  two["effects"]["range-offset"] = {{"offset_m", 0.06}, {"sensors", {"right"}}};
  const SideBySide world;
  const auto measured = world.measuredBy(model::parseModel(two, "two.json"));
  core::SilentProgress progress;
  const gap::Diagnosis diagnosis =
      gap::diagnose(measured, model::parseModel(one, "one.json"), {.library = {"range-offset"}}, progress);
  EXPECT_EQ(diagnosis.verdict.names, std::vector<std::string>{"range-offset"});
  EXPECT_EQ(diagnosis.causes.front().sensors, std::vector<std::string>{"right"});
  EXPECT_EQ(model::parseModel(diagnosis.proposed_model, "proposed.json").effectsOf("left").size(), 1U);
}

// What both sensors see of one set-up has one reference error: fitted to one of them, it is known for the other.
TEST(SideBySideDiagnosis, SamplesOfOneSetUpAreHeldOutTogether) {
  const SideBySide world;
  model::Experiment measured = world.measuredBy(SideBySide::modelWith({}));
  for (model::Sample& sample : measured.samples) sample.role = model::Role::kValidation;
  const gap::Replay replay(measured, SideBySide::modelWith({}));
  const gap::Split split = gap::splitOf(replay, 1);
  const auto held_out = gap::setupsOf(replay, split.held_out.samples);
  EXPECT_EQ(split.held_out.samples.size(), 4U);
  EXPECT_EQ(held_out.size(), 2U);
  for (const gap::SetUp& fitted : gap::setupsOf(replay, split.fitted.samples))
    for (const gap::SetUp& setup : held_out) EXPECT_NE(setup.name, fitted.name);
}

TEST(SideBySideDiagnosis, NoneIsSaidWhereBothSensorsAreAsTheirModels) {
  const SideBySide world;
  const gap::Diagnosis diagnosis =
      diagnosed(world.measuredBy(SideBySide::modelWith({})), {"range-offset", "clock-drift"});
  EXPECT_EQ(diagnosis.verdict.kind, gap::VerdictKind::kNone);
}

// The other sensor's ranges lie anywhere, so that all of them together lie on no comb.
TEST(SideBySideDiagnosis, SeesTheCoarseStepsOfOneSensorInItsOwnRanges) {
  const SideBySide world;
  const auto measured =
      world.measuredBy(SideBySide::modelWith({{"quantisation", {{"range_step_m", 0.23}, {"sensors", {"right"}}}}}));
  const gap::Replay replay(measured, SideBySide::modelWith({}));
  for (const gap::Hypothesis& hypothesis : gap::hypothesesFor(replay, {"quantisation"})) {
    if (hypothesis.name != "quantisation" || !hypothesis.variant.empty()) continue;
    const bool of_right = hypothesis.sensors == std::vector<std::string>{"right"};
    EXPECT_EQ(hypothesis.seen_in_values, of_right);
    if (of_right) {
      EXPECT_NEAR(hypothesis.parameters.front().start, 0.23, 1e-3);
    }
  }
  EXPECT_EQ(diagnosed(measured, {"quantisation", "pulse-jitter"}).causes.front().sensors,
            std::vector<std::string>{"right"});
}

TEST(LayerGains, AreThoseOfTheDataForTheSensorThatHasThem) {
  const SideBySide world;
  const auto truth = SideBySide::modelWith(
      {{"photo-response-nonuniformity", {{"gain_per_layer", {1.2, 0.9, 1.05, 0.85}}, {"sensors", {"left"}}}}});
  const auto measured = world.measuredBy(truth);
  const gap::Replay replay(measured, SideBySide::modelWith({}));
  const auto left = gap::layerGains(replay, {"left"}), right = gap::layerGains(replay, {"right"});
  ASSERT_EQ(left.size(), 4U);
  EXPECT_NEAR(left[0], 1.2, 0.01);
  EXPECT_NEAR(left[1], 0.9, 0.01);
  EXPECT_NEAR(left[2], 1.05, 0.01);
  EXPECT_NEAR(left[3], 0.85, 0.01);
  for (const double gain : right) EXPECT_NEAR(gain, 1.0, 0.01);

  const gap::Diagnosis diagnosis = diagnosed(measured, {"photo-response-nonuniformity", "atmospheric-attenuation"});
  EXPECT_EQ(diagnosis.verdict.names, std::vector<std::string>{"photo-response-nonuniformity"});
  EXPECT_EQ(diagnosis.causes.front().sensors, std::vector<std::string>{"left"});
}

TEST(LayerGains, ThatBothSensorsShareAreOneCauseOfBoth) {
  const SideBySide world;
  const auto truth =
      SideBySide::modelWith({{"photo-response-nonuniformity", {{"gain_per_layer", {1.2, 0.9, 1.05, 0.85}}}}});
  const auto measured = world.measuredBy(truth);
  const gap::Diagnosis diagnosis = diagnosed(measured, {"photo-response-nonuniformity", "atmospheric-attenuation"});
  EXPECT_EQ(diagnosis.verdict.names, std::vector<std::string>{"photo-response-nonuniformity"});
  EXPECT_TRUE(diagnosis.causes.front().sensors.empty());
}

}  // namespace
