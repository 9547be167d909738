#include <gtest/gtest.h>

#include "core/file.h"
#include "gap/diagnosis.h"
#include "gap/report/json.h"
#include "tests/gap/small_world.h"
#include "tests/support/thrown_message.h"

// The model under test is a recording or a command. Here both hold what the built-in lidar reported under another seed,
// so that the direct diagnosis is the oracle of the one by way of a proxy.
namespace {

using nlohmann::json;
using test_support::SmallWorld;
using test_support::thrownMessage;

class BlackBox : public ::testing::Test {
 protected:
  /// What `as` reports of the small world, as the model under test.
  [[nodiscard]] model::LidarModel recordingOf(const model::Experiment& experiment, const model::LidarModel& as,
                                              const json& more = json::object()) const {
    core::SilentProgress progress;
    model::simulatePackage(experiment, as, world_.folder() / "recording", 99, progress);
    json file = {{"format", "fidelis-model"}, {"version", 1}, {"id", "theirs"}, {"recorded", "recording"}};
    file.update(more);
    return model::parseModel(file, world_.folder() / "theirs.json");
  }
  static gap::Diagnosis diagnosed(const model::Experiment& experiment, const model::LidarModel& model,
                                  std::optional<model::LidarModel> proxy = std::nullopt) {
    core::SilentProgress progress;
    return gap::diagnose(experiment, model, {.library = kFewEffects, .proxy = std::move(proxy)}, progress);
  }
  static model::LidarModel plain() { return SmallWorld::modelWith({}); }
  static model::LidarModel inFog() {
    return SmallWorld::modelWith({{"atmospheric-attenuation", {{"visibility_m", 400}}}});
  }

  inline static const std::vector<std::string> kFewEffects = {"atmospheric-attenuation", "detection-loss", "range-walk",
                                                              "dynamic-threshold", "cover-contamination"};
  SmallWorld world_;
};

TEST_F(BlackBox, ARecordingGetsTheCauseAndTheShrinkOfTheDirectDiagnosis) {
  const auto experiment = world_.measuredBy(inFog(), 0.4);
  const gap::Diagnosis direct = diagnosed(experiment, plain());
  const gap::Diagnosis foreign = diagnosed(experiment, recordingOf(experiment, plain()), plain());
  ASSERT_EQ(direct.verdict.names, std::vector<std::string>{"atmospheric-attenuation"});
  EXPECT_EQ(foreign.verdict.names, direct.verdict.names);
  EXPECT_NEAR(foreign.shrink.fraction, direct.shrink.fraction, 0.05);
  EXPECT_NEAR(foreign.causes.front().parameters.at(0).value, direct.causes.front().parameters.at(0).value, 20.0);
  ASSERT_TRUE(foreign.approximation);
  EXPECT_LT(foreign.approximation->ratio, 0.1);
  EXPECT_NEAR(foreign.verdict.confidence, direct.verdict.confidence, 0.2);
  EXPECT_TRUE(foreign.proposed_model.is_null());  // their file has no effects
  EXPECT_FALSE(direct.approximation);
  EXPECT_TRUE(gap::reportJson(foreign)["approximation"]["reliable"].get<bool>());
}

TEST_F(BlackBox, SaysNoneWhereOnlyTheNoiseDiffers) {
  const auto experiment = world_.measuredBy(plain(), 0.4);
  const gap::Diagnosis foreign = diagnosed(experiment, recordingOf(experiment, plain()), plain());
  EXPECT_EQ(foreign.verdict.kind, gap::VerdictKind::kNone);
  EXPECT_GT(foreign.p_value, 1e-3);
}

TEST_F(BlackBox, BlamesTheReferenceOfASetUp) {
  const auto experiment = world_.measuredBy(plain(), 0.4, {{"r13", 0.12}, {"r36", -0.08}});
  const gap::Diagnosis foreign = diagnosed(experiment, recordingOf(experiment, plain()), plain());
  EXPECT_EQ(foreign.verdict.names, std::vector<std::string>{"/scene/0/pose/position_m/0"});
  EXPECT_NEAR(foreign.causes.front().setups.at("r13").value, 0.12, 0.01);
}

TEST_F(BlackBox, ACommandIsRunOnceAndDiagnosedLikeItsRecording) {
  const auto experiment = world_.measuredBy(inFog(), 0.4);
  const auto recording = recordingOf(experiment, plain(), {{"proxy", plain().json}});
  (void)world_.folder().write("lidar.sh", "echo run >> runs\ncp recording/measurements/* \"$2/measurements/\"\n");
  json file = {{"format", "fidelis-model"}, {"version", 1}, {"id", "theirs"}, {"proxy", plain().json}};
  file["command"] = {"sh", "lidar.sh"};
  const auto command = model::parseModel(file, world_.folder() / "theirs.json");
  auto by_recording = gap::reportJson(diagnosed(experiment, recording));
  auto by_command = gap::reportJson(diagnosed(experiment, command));
  by_recording.erase("elapsed_s");
  by_command.erase("elapsed_s");
  EXPECT_EQ(by_recording.dump(), by_command.dump());
  EXPECT_EQ(core::readFile(world_.folder() / "runs"), "run\n");
}

// The recording was made with a wall that is much darker than the proxy's: the proxy is farther from the model under
// test than the measurement is.
TEST_F(BlackBox, AProxyThatIsFartherAwayThanTheMeasurementIsNotToBeReliedUpon) {
  const auto experiment = world_.measuredBy(SmallWorld::modelWith({{"range-offset", {{"offset_m", 0.02}}}}), 0.4);
  const auto theirs = SmallWorld::modelWith({}, {{"/sensor/detection/epw_noise_m", 0.05}});
  const auto dim = SmallWorld::modelWith({}, {{"/sensor/emitter/peak_power_w", 8.0}});
  const gap::Diagnosis diagnosis = diagnosed(experiment, recordingOf(experiment, theirs), dim);
  ASSERT_TRUE(diagnosis.approximation);
  EXPECT_FALSE(diagnosis.approximation->reliable());
  EXPECT_NE(diagnosis.approximation->text.find("do not rely upon the causes"), std::string::npos);
  EXPECT_TRUE(diagnosis.verdict.names.empty() || diagnosis.verdict.confidence < 0.35);
}

TEST_F(BlackBox, WithoutAProxyTheExperimentsSensorStandsForTheModel) {
  const auto experiment = world_.measuredBy(inFog(), 0.4);
  const gap::Diagnosis foreign = diagnosed(experiment, recordingOf(experiment, plain()));
  EXPECT_EQ(foreign.approximation->proxy, "theirs-proxy");
  EXPECT_EQ(foreign.verdict.names, std::vector<std::string>{"atmospheric-attenuation"});
}

TEST_F(BlackBox, ARecordingCannotBeAProxy) {
  const auto experiment = world_.measuredBy(plain(), 0.4);
  const auto theirs = recordingOf(experiment, plain());
  EXPECT_NE(thrownMessage([&] { (void)diagnosed(experiment, theirs, theirs); }).find("a proxy"), std::string::npos);
}

TEST_F(BlackBox, AProxyIsReadForAModelThatIsNotOursAndRefusedForTheBuiltInLidar) {
  const auto file = world_.folder().write("near.json", plain().json.dump());
  const auto theirs = model::parseModel(
      {{"format", "fidelis-model"}, {"version", 1}, {"id", "theirs"}, {"recorded", "r"}}, "theirs.json");
  EXPECT_FALSE(gap::chosenProxy("", theirs));
  EXPECT_EQ(gap::chosenProxy(file, theirs)->id, plain().id);
  const std::string refusal = thrownMessage([&] { (void)gap::chosenProxy(file, plain()); });
  EXPECT_NE(refusal.find("near.json: no proxy is needed"), std::string::npos) << refusal;
  EXPECT_NE(refusal.find("is the built-in lidar itself"), std::string::npos) << refusal;
}

TEST_F(BlackBox, AProxyOfAnotherKindThanAModelFileIsRefusedWithItsPlace) {
  const json file = {{"format", "fidelis-model"}, {"version", 1}, {"id", "t"}, {"recorded", "r"}, {"proxy", 3}};
  EXPECT_NE(thrownMessage([&] { (void)model::parseModel(file, "t.json"); }).find("/proxy"), std::string::npos);
}

}  // namespace
