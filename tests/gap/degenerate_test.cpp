#include <cmath>
#include <gtest/gtest.h>

#include "core/file.h"
#include "core/json_object.h"
#include "gap/diagnosis.h"
#include "gap/report/json.h"
#include "model/simulate.h"
#include "tests/gap/small_world.h"
#include "tests/support/thrown_message.h"

// Data that are broken, do not fit, or are too few: a clear error, or a verdict that says why nobody should rely on it.
namespace {

using nlohmann::json;
using test_support::SmallWorld;
using test_support::thrownMessage;

/// The small world measured in fog, to be spoilt.
class Degenerate : public ::testing::Test {
 protected:
  Degenerate() : experiment_(world_.measuredBy(inFog(), 0.4)), json_(experiment_.json) {}

  static model::LidarModel inFog() {
    return SmallWorld::modelWith({{"atmospheric-attenuation", {{"visibility_m", 300}}}});
  }
  [[nodiscard]] gap::Diagnosis diagnosed(const model::LidarModel& model = SmallWorld::modelWith({})) const {
    core::SilentProgress progress;
    return gap::diagnose(model::parseExperiment(json_, experiment_.file), model, {.library = kFewEffects}, progress);
  }
  [[nodiscard]] std::string complaint(const model::LidarModel& model = SmallWorld::modelWith({})) const {
    return thrownMessage([&] { (void)diagnosed(model); });
  }
  void keepSamples(const std::vector<std::size_t>& wanted) {
    json kept = json::array();
    for (const std::size_t s : wanted) kept.push_back(json_["samples"][s]);
    json_["samples"] = kept;
  }
  /// Rewrites a measurement file line by line: header (row -1) and rows; nothing returned drops the line.
  template <typename Change>
  void rewrite(std::size_t sample, Change change) {
    const auto file = experiment_.folder() / json_["samples"][sample]["measurements"].get<std::string>();
    std::istringstream in(core::readFile(file));
    std::string line, out;
    for (int row = -1; std::getline(in, line); ++row) {
      if (change(row, line)) out += line + "\n";
    }
    core::writeFile(file, out);
  }
  void empty(std::size_t sample) {
    rewrite(sample, [](int row, const std::string&) { return row < 0; });
  }

  inline static const std::vector<std::string> kFewEffects = {"atmospheric-attenuation", "detection-loss", "speckle"};
  SmallWorld world_;
  model::Experiment experiment_;
  json json_;
};

testing::AssertionResult says(const std::vector<std::string>& texts, const std::string& part) {
  for (const std::string& text : texts) {
    if (text.find(part) != std::string::npos) return testing::AssertionSuccess();
  }
  return testing::AssertionFailure() << "nowhere '" << part << "' among " << json(texts).dump();
}

TEST_F(Degenerate, EnoughDataHaveNoLimitsAndNoNotes) {
  const gap::Diagnosis diagnosis = diagnosed();
  EXPECT_TRUE(diagnosis.verdict.limits.empty());
  EXPECT_TRUE(diagnosis.notes.empty());
  EXPECT_GT(diagnosis.verdict.confidence, 0.5);
}

// A patch may bring an object: numbers of objects in the scene hold in that sample only.
TEST(DegenerateScenes, AnObjectThatOneSampleAloneHasIsNamedAndMovedThere) {
  SmallWorld world;
  const auto withASign = [&](double sign_at_m) {
    json experiment = world.recorded();
    json sign = experiment["scene"][0];
    sign["id"] = "sign";
    sign["shape"] = {{"type", "rectangle"}, {"width_m", 1.0}, {"height_m", 1.0}};
    sign["pose"]["position_m"][0] = sign_at_m;
    experiment["samples"][3]["patch"].push_back({{"op", "add"}, {"path", "/scene/-"}, {"value", sign}});
    return experiment;
  };
  core::SilentProgress progress;
  const auto real = model::parseExperiment(withASign(6.2), world.folder() / "experiment.json");
  model::simulatePackage(real, SmallWorld::modelWith({}), world.folder() / "measured", 4711, progress);
  core::writeJson(world.folder() / "measured" / "experiment.json", withASign(6.0));
  const gap::Diagnosis diagnosis = gap::diagnose(model::readExperiment(world.folder() / "measured"),
                                                 SmallWorld::modelWith({}), {.library = {"range-offset"}}, progress);
  EXPECT_EQ(diagnosis.verdict.names, std::vector<std::string>{"/scene/1/pose/position_m/0"});
  EXPECT_NEAR(diagnosis.causes.front().parameters.front().value, 0.2, 0.02);
}

// A measured pulse brings its width: to scale the number beside it is refused by the reader of models.
TEST_F(Degenerate, AMeasuredPulseBesideItsWidthIsDiagnosedAsAnyOther) {
  std::string pulse = "time_ns,power\n";
  for (int i = -40; i <= 40; ++i) {
    const double t_ns = 0.25 * i;
    pulse += std::to_string(t_ns) + "," + std::to_string(std::exp(-4.0 * std::log(2.0) * t_ns * t_ns / 20.25)) + "\n";
  }
  core::writeFile(world_.folder() / "pulse.csv", pulse);
  json measured_pulse = SmallWorld::modelWith({}).json;
  measured_pulse["sensor"]["emitter"]["pulse_shape"] = {{"file", "pulse.csv"}};
  const auto model = model::parseModel(measured_pulse, world_.folder() / "model.json");
  EXPECT_EQ(diagnosed(model).verdict.names, std::vector<std::string>{"atmospheric-attenuation"});
}

TEST_F(Degenerate, OneSampleIsNeverBelievedAndSaysSo) {
  keepSamples({3});
  const gap::Diagnosis diagnosis = diagnosed();
  EXPECT_TRUE(diagnosis.weak_hold_out);
  EXPECT_LE(diagnosis.verdict.confidence, 0.5);
  EXPECT_TRUE(says(diagnosis.verdict.limits, "one sample only"));
  EXPECT_NE(diagnosis.verdict.text.find("one sample only"), std::string::npos);
  EXPECT_EQ(gap::reportJson(diagnosis)["verdict"]["limits"].size(), diagnosis.verdict.limits.size());
}

TEST_F(Degenerate, OneFrameInEverySampleIsNeverBelieved) {
  for (std::size_t s = 0; s < json_["samples"].size(); ++s) {
    json_["samples"][s]["frames"] = 1;
    rewrite(s, [](int row, const std::string& line) { return row < 0 || line.rfind("0,", 0) == 0; });
  }
  const gap::Diagnosis diagnosis = diagnosed();
  EXPECT_LE(diagnosis.verdict.confidence, 0.5);
  EXPECT_TRUE(says(diagnosis.verdict.limits, "1 frame"));
}

// The wall is there, but one beam alone looks at it: neither "nothing is missing" nor a cause is to be relied upon.
TEST_F(Degenerate, ASingleBeamIsNeverBelieved) {
  auto model = SmallWorld::modelWith({});
  const json scan = {{{"elevation_deg", 0.4}, {"azimuth_deg", {{"from", 0}, {"to", 0}, {"step", 1.0}}}}};
  auto model_json = model.json;
  model_json["/sensor/scan/layers"_json_pointer] = json_["/sensor/scan/layers"_json_pointer] = scan;
  model = model::parseModel(model_json, "small-model.json");
  model_json["effects"]["atmospheric-attenuation"] = {{"visibility_m", 300}};
  core::SilentProgress progress;
  const auto folder = world_.folder() / "one-beam";
  model::simulatePackage(model::parseExperiment(json_, experiment_.file), model::parseModel(model_json, "truth.json"),
                         folder, 4711, progress);
  const gap::Diagnosis diagnosis =
      gap::diagnose(model::readExperiment(folder), model, {.library = kFewEffects}, progress);
  EXPECT_LE(diagnosis.verdict.confidence, 0.5);
  EXPECT_TRUE(says(diagnosis.verdict.limits, "beams meet a surface"));
}

TEST_F(Degenerate, WithoutPredictionSamplesOthersAreHeldOut) {
  for (json& sample : json_["samples"]) sample["role"] = "validation";
  const gap::Diagnosis diagnosis = diagnosed();
  EXPECT_FALSE(diagnosis.held_out.empty());
  EXPECT_FALSE(diagnosis.weak_hold_out);
  EXPECT_EQ(diagnosis.verdict.names, std::vector<std::string>{"atmospheric-attenuation"});
}

TEST_F(Degenerate, OnlyPredictionSamplesAreSaidToBeFittedAllTheSame) {
  for (json& sample : json_["samples"]) sample["role"] = "prediction";
  EXPECT_TRUE(says(diagnosed().notes, "role prediction"));
}

TEST_F(Degenerate, AColumnThatOneSampleLacksIsSaidToBeLeftOut) {
  rewrite(2, [](int, std::string& line) {  // frame,time_s,layer,azimuth_rad,elevation_rad,echo,range_m,epw_m,intensity
    const auto last = line.rfind(',');
    line.erase(last);
    return true;
  });
  const gap::Diagnosis diagnosis = diagnosed();
  EXPECT_TRUE(says(diagnosis.notes, "intensity is not compared in any sample"));
  EXPECT_TRUE(says(diagnosis.notes, json_["samples"][2]["id"].get<std::string>()));
}

TEST_F(Degenerate, UnequalFrameCountsAreNoGap) {
  SmallWorld other;
  const auto model = SmallWorld::modelWith({});
  const auto experiment = other.measuredBy(model, 0.4);
  json unequal = experiment.json;
  for (std::size_t s : {0U, 3U}) {
    unequal["samples"][s]["frames"] = s == 0 ? 4 : 11;
    const int frames = unequal["samples"][s]["frames"];
    const auto file = experiment.folder() / unequal["samples"][s]["measurements"].get<std::string>();
    std::istringstream in(core::readFile(file));
    std::string line, out;
    for (int row = -1; std::getline(in, line); ++row) {
      if (row < 0 || std::stoi(line) < frames) out += line + "\n";
    }
    core::writeFile(file, out);
  }
  core::SilentProgress progress;
  EXPECT_EQ(gap::diagnose(model::parseExperiment(unequal, experiment.file), model, {.library = kFewEffects}, progress)
                .verdict.kind,
            gap::VerdictKind::kNone);
}

TEST_F(Degenerate, AnEmptySampleAmongManyIsSaidAndWeighedAsSeeingNothing) {
  empty(1);
  const gap::Diagnosis diagnosis = diagnosed();
  EXPECT_TRUE(diagnosis.present);
  EXPECT_TRUE(says(diagnosis.notes, "No detection in sample " + json_["samples"][1]["id"].get<std::string>()));
}

TEST_F(Degenerate, EmptyHeldOutSamplesAreNeverBelieved) {
  for (std::size_t s = 0; s < json_["samples"].size(); ++s) {
    if (json_["samples"][s]["role"] == "prediction") empty(s);
  }
  const gap::Diagnosis diagnosis = diagnosed();
  EXPECT_LE(diagnosis.verdict.confidence, 0.5);
  EXPECT_TRUE(says(diagnosis.verdict.limits, "held-out samples hold no detection"));
}

TEST_F(Degenerate, AMeasurementWithoutASingleDetectionIsAnError) {
  for (std::size_t s = 0; s < json_["samples"].size(); ++s) empty(s);
  EXPECT_NE(complaint().find("no sample holds a single detection"), std::string::npos);
}

TEST_F(Degenerate, AFrameBeyondTheStatedNumberIsAnErrorThatNamesTheSample) {
  json_["samples"][1]["frames"] = 7;
  EXPECT_NE(complaint().find("sample '" + json_["samples"][1]["id"].get<std::string>() + "' states 7 frames"),
            std::string::npos);
}

TEST_F(Degenerate, ANumberThatIsNoneIsAnErrorThatNamesTheLine) {
  rewrite(0, [](int row, std::string& line) {
    if (row == 4) line.replace(line.rfind(',') + 1, std::string::npos, "nan");
    return true;
  });
  EXPECT_NE(complaint().find(".csv:6"), std::string::npos);
}

TEST_F(Degenerate, AModelWithOtherLayersThanTheSensorThatMeasuredIsAnError) {
  auto model = SmallWorld::modelWith({}).json;
  model["/sensor/scan/layers"_json_pointer].push_back(
      {{"elevation_deg", 2.0}, {"azimuth_deg", {{"from", 20}, {"to", -20}, {"step", 1.0}}}});
  EXPECT_NE(complaint(model::parseModel(model, "m.json")).find("has 5 layers, the experiment's 4"), std::string::npos);
}

TEST_F(Degenerate, AModelWithOtherBeamsThanTheSensorThatMeasuredIsAnError) {
  auto model = SmallWorld::modelWith({}).json;
  model["/sensor/scan/layers/2/azimuth_deg/step"_json_pointer] = 2.0;
  EXPECT_NE(complaint(model::parseModel(model, "m.json")).find("fires 21 beams in layer 2, the experiment's 41"),
            std::string::npos);
}

TEST_F(Degenerate, DetectionsWhereTheSceneHasNothingAreSaid) {
  json_["scene"][0]["pose"]["position_m"][0] = 10;
  for (json& sample : json_["samples"]) {
    sample["patch"][0]["value"] = sample["patch"][0]["value"].get<double>() + 60.0;
  }
  const gap::Diagnosis diagnosis = diagnosed();
  EXPECT_TRUE(says(diagnosis.notes, "where the scene has no surface"));
  EXPECT_TRUE(says(diagnosis.verdict.limits, "where the scene has no surface"));
  EXPECT_LE(diagnosis.verdict.confidence, 0.5) << diagnosis.verdict.text;
}

// Fog that throws back most echoes is no scene that does not fit.
TEST_F(Degenerate, EchoesOfTheCauseThatIsNamedAreNoLimit) {
  const auto model = SmallWorld::modelWith({});
  const auto foggy =
      world_.measuredBy(SmallWorld::modelWith({{"atmospheric-backscatter", {{"visibility_m", 40}}}}), 0.4);
  std::size_t near = 0, all = 0;
  for (const model::Sample& sample : foggy.samples) {
    for (const double range_m : model::readMeasurements(foggy, sample).range_m) {
      near += range_m < 7.0 ? 1 : 0;  // no wall stands there
      ++all;
    }
  }
  ASSERT_GT(near, all / 2);
  core::SilentProgress progress;
  const gap::Diagnosis diagnosis =
      gap::diagnose(foggy, model, {.library = {"atmospheric-backscatter", "false-alarm"}}, progress);
  EXPECT_EQ(diagnosis.verdict.names, std::vector<std::string>{"atmospheric-backscatter"});
  EXPECT_GT(diagnosis.verdict.confidence, 0.5);
  EXPECT_TRUE(diagnosis.verdict.limits.empty()) << diagnosis.verdict.text;
  EXPECT_FALSE(says(diagnosis.notes, "where the scene has no surface"));
}

TEST_F(Degenerate, WithoutDirectionsSamplesAreComparedAsAWholeAndThatIsSaid) {
  for (std::size_t s = 0; s < json_["samples"].size(); ++s) {
    rewrite(s, [](int, std::string& line) {
      std::vector<std::string> cells;
      std::istringstream in(line);
      for (std::string cell; std::getline(in, cell, ',');) cells.push_back(cell);
      // without layer, azimuth and elevation; the file may or may not have a time
      const std::size_t first = cells.size() - 7;
      cells.erase(cells.begin() + static_cast<std::ptrdiff_t>(first),
                  cells.begin() + static_cast<std::ptrdiff_t>(first) + 3);
      line.clear();
      for (const std::string& cell : cells) line += (line.empty() ? "" : ",") + cell;
      return true;
    });
  }
  const gap::Diagnosis diagnosis = diagnosed();
  EXPECT_TRUE(says(diagnosis.notes, "Directions were not recorded"));
  EXPECT_TRUE(diagnosis.present);
}

}  // namespace
