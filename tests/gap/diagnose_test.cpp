#include <algorithm>
#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <map>
#include <string>

#include "core/detection_files/detection_file.h"
#include "core/error.h"
#include "core/parallel.h"
#include "core/physics.h"
#include "gap/diagnosis.h"
#include "gap/report/json.h"
#include "model/simulate.h"
#include "tests/gap/small_world.h"

// The measurement is made by our own model, with other noise: these cases are easier than foreign ones and show that
// each kind of verdict is reached for its reason. The shared cases come from an independent generator.
namespace {

using test_support::SmallWorld;

gap::Diagnosis diagnosed(const model::Experiment& experiment, const model::LidarModel& model,
                         std::vector<std::string> library = {}) {
  core::SilentProgress progress;
  return gap::diagnose(experiment, model, {.library = std::move(library)}, progress);
}

/// The same experiment with other roles of some samples, by their ids.
model::Experiment withRoles(model::Experiment experiment, const std::map<std::string, model::Role>& roles) {
  for (model::Sample& sample : experiment.samples)
    if (const auto role = roles.find(sample.id); role != roles.end()) sample.role = role->second;
  return experiment;
}

/// One effect, with the one number that it has.
void expectEffect(const gap::Diagnosis& diagnosis, const std::string& name, double value, double tolerance) {
  ASSERT_EQ(diagnosis.verdict.kind, gap::VerdictKind::kEffect);
  EXPECT_EQ(diagnosis.verdict.names, std::vector<std::string>{name});
  ASSERT_EQ(diagnosis.causes.front().parameters.size(), 1U);
  EXPECT_NEAR(diagnosis.causes.front().parameters[0].value, value, tolerance);
}

TEST(Diagnose, SaysNoneWhereOnlyTheNoiseDiffers) {
  const SmallWorld world;
  const auto model = SmallWorld::modelWith({});
  const gap::Diagnosis diagnosis = diagnosed(world.measuredBy(model, 0.4), model);
  EXPECT_EQ(diagnosis.verdict.kind, gap::VerdictKind::kNone);
  EXPECT_FALSE(diagnosis.present);
  EXPECT_TRUE(diagnosis.verdict.names.empty());
  EXPECT_TRUE(diagnosis.proposed_model.is_null());
}

// A fifth of the scan measures 2.8 mm more, the rest 0.7 mm less. That is less than the standard error of a beam's
// mean, and no gap of all beams together; of that fifth it is eight standard errors.
TEST(Diagnose, SaysThatTheyDifferWhereOneStratumAloneShowsIt) {
  const SmallWorld world;
  const auto model = SmallWorld::modelWith({});
  model::Experiment experiment = world.measuredBy(model, 0.4);
  experiment.measurands.front().resolution = 0.002;  // of the range: what is wrong matters
  for (const model::Sample& sample : experiment.samples) {
    core::Detections measured = model::readMeasurements(experiment, sample);
    for (std::size_t i = 0; i < measured.size(); ++i) {
      const bool inside = measured.azimuth_rad[i] > 0.09 && measured.azimuth_rad[i] < 0.23;
      measured.range_m[i] += inside ? 0.0028 : -0.0007;
    }
    core::writeDetections(sample.measurements, measured);
  }
  const gap::Diagnosis diagnosis = diagnosed(experiment, model);
  EXPECT_EQ(diagnosis.verdict.kind, gap::VerdictKind::kUnknown);
  EXPECT_EQ(diagnosis.verdict.contradiction, gap::Contradiction::kOneStratum);
  EXPECT_THAT(diagnosis.verdict.text, testing::StartsWith("They differ in one place"));
  ASSERT_FALSE(diagnosis.where.empty());
  EXPECT_EQ(diagnosis.where.front().covariate, "azimuth_deg");
  EXPECT_LT(diagnosis.p_value, 1e-9);
}

TEST(Diagnose, NamesFogAndRecoversItsVisibility) {
  const SmallWorld world;
  const auto truth = SmallWorld::modelWith({{"atmospheric-attenuation", {{"visibility_m", 400}}}});
  const gap::Diagnosis diagnosis = diagnosed(world.measuredBy(truth, 0.4), SmallWorld::modelWith({}));
  expectEffect(diagnosis, "atmospheric-attenuation", 400.0, 20.0);  // 5 %
  EXPECT_GT(diagnosis.shrink.fraction, 0.9);
  EXPECT_TRUE(diagnosis.proposed_model["effects"].contains("atmospheric-attenuation"));
}

/// A number of the named cause.
double numberOf(const gap::Diagnosis& diagnosis, const std::string& name) {
  for (const gap::FittedParameter& parameter : diagnosis.causes.front().parameters)
    if (parameter.name == name) return parameter.value;
  return std::nan("");
}

// Large droplets, and drops among them, send back a third of what the usual ones do (65 sr in place of 18.8). A fog
// that had to be one of the usual ones would be three times thinner than it is.
TEST(Diagnose, RecoversTheVisibilityOfAFogOfOtherDroplets) {
  const SmallWorld world;
  const auto truth =
      SmallWorld::modelWith({{"atmospheric-backscatter", {{"visibility_m", 60}, {"backscatter_1_m_sr", 0.001}}}});
  const gap::Diagnosis diagnosis = diagnosed(world.measuredBy(truth, 0.4), SmallWorld::modelWith({}),
                                             {"atmospheric-backscatter", "atmospheric-attenuation", "exhaust-cloud"});
  EXPECT_EQ(diagnosis.verdict.names, std::vector<std::string>{"atmospheric-backscatter"});
  EXPECT_NEAR(numberOf(diagnosis, "visibility_m"), 60.0, 6.0);
  EXPECT_NEAR(numberOf(diagnosis, "backscatter_1_m_sr"), 0.001, 0.0001);
}

// A cloud of soot takes light and gives hardly any back. With the droplets' albedo it would be seen itself, or be so
// thin that it took nothing.
TEST(Diagnose, NamesACloudThatTakesLightAndSendsNoneBack) {
  const SmallWorld world;
  const auto truth = SmallWorld::modelWith(
      {{"exhaust-cloud", {{"extinction_1_m", 0.05}, {"size_m", 1.5}, {"albedo", 0.002}, {"centre", {5.0, 0.0, 0.0}}}}});
  const gap::Diagnosis diagnosis = diagnosed(world.measuredBy(truth, 0.4), SmallWorld::modelWith({}));
  EXPECT_EQ(diagnosis.verdict.names, std::vector<std::string>{"exhaust-cloud"});
  // Twice the way through the middle is what the light behind it loses.
  EXPECT_NEAR(numberOf(diagnosis, "extinction_1_m") * numberOf(diagnosis, "size_m"), 0.05 * 1.5, 0.1 * 0.05 * 1.5);
  EXPECT_GT(diagnosis.shrink.fraction, 0.9);
}

// Every wall stands 2 cm beside its recorded place, as it may, and that is most of the gap where all data are pooled.
// That the gains of the layers differ by 0.15 % single cells would prove; nothing is gained with it.
TEST(Diagnose, NamesNoCauseThatGainsNothingWhereAllDataArePooled) {
  SmallWorld world;
  world.knownToWithin(0.025);
  const nlohmann::json gains = {{"gain_per_layer", {1.0015, 0.9985, 1.0015, 0.9985}}};
  const auto truth = SmallWorld::modelWith({{"photo-response-nonuniformity", gains}});
  const auto measured = world.measuredBy(
      truth, 0.4, {{"r8", 0.02}, {"r13", -0.02}, {"r19", 0.02}, {"r27", -0.02}, {"r36", -0.02}, {"r46", 0.02}});
  const gap::Diagnosis diagnosis =
      diagnosed(measured, SmallWorld::modelWith({}), {"photo-response-nonuniformity", "range-offset"});
  EXPECT_EQ(diagnosis.verdict.kind, gap::VerdictKind::kNone);
}

// The noise (15 mm) smears the steps over the frames: means of single beams hardly show them, the values do.
TEST(Diagnose, NamesACounterWhoseStepsOnlyTheValuesShow) {
  const SmallWorld world;
  const auto truth = SmallWorld::modelWith({{"quantisation", {{"range_step_m", 0.0437}}}});
  const gap::Diagnosis diagnosis = diagnosed(world.measuredBy(truth, 0.4), SmallWorld::modelWith({}));
  expectEffect(diagnosis, "quantisation", 0.0437, 2e-5);  // half a turn at 47 m is 2e-5 m
  EXPECT_GT(diagnosis.shrink.fraction, 0.05);             // the noise of the pooled data is the larger part
}

// Fog moves every mean; the counter beside it hardly does, and no pair would earn it its place. The values tell.
TEST(Diagnose, NamesACounterBesideTheFogThatHidesIt) {
  const SmallWorld world;
  const auto truth = SmallWorld::modelWith(
      {{"atmospheric-attenuation", {{"visibility_m", 150}}}, {"quantisation", {{"range_step_m", 0.0437}}}});
  const gap::Diagnosis diagnosis = diagnosed(world.measuredBy(truth, 0.4), SmallWorld::modelWith({}));
  EXPECT_THAT(diagnosis.verdict.names, testing::UnorderedElementsAre("atmospheric-attenuation", "quantisation"));
  ASSERT_GE(diagnosis.causes.size(), 2U);
  for (const std::size_t member : {0U, 1U}) {
    const bool fog = diagnosis.causes[member].name == "atmospheric-attenuation";
    EXPECT_NEAR(diagnosis.causes[member].parameters.at(0).value, fog ? 150.0 : 0.0437, fog ? 7.5 : 2e-5);
  }
}

// A warm detector is one whose noise is larger than stated: where a counter stands beside it, two effects go before an
// effect and a wrong number, as they do in any pair.
TEST(Diagnose, NamesAnEffectBesideACounterRatherThanTheNumberThatDoesTheSame) {
  SmallWorld world;
  world.measuredUnder(202);  // a draw in which the number comes a hair nearer, and no pair earns its place by gain
  const auto truth = SmallWorld::modelWith(
      {{"thermal-noise", {{"temperature_degC", 45}}}, {"quantisation", {{"range_step_m", 0.0234}}}});
  const gap::Diagnosis diagnosis =
      diagnosed(world.measuredBy(truth, 0.4), SmallWorld::modelWith({}), {"thermal-noise", "quantisation"});
  EXPECT_THAT(diagnosis.verdict.names, testing::UnorderedElementsAre("thermal-noise", "quantisation"))
      << diagnosis.verdict.text;
}

TEST(Diagnose, FindsASectorOfDirtOnTheCover) {
  const SmallWorld world;
  const auto truth = SmallWorld::modelWith(
      {{"cover-contamination", {{"attenuation", 0.2}, {"azimuth_from_deg", -12.5}, {"azimuth_to_deg", -4.5}}}});
  const gap::Diagnosis diagnosis = diagnosed(world.measuredBy(truth, 0.4), SmallWorld::modelWith({}));
  EXPECT_EQ(diagnosis.verdict.names, std::vector<std::string>{"cover-contamination"});
  const auto azimuth = std::find_if(diagnosis.where.begin(), diagnosis.where.end(),
                                    [](const gap::WhereRow& row) { return row.covariate == "azimuth_deg"; });
  ASSERT_NE(azimuth, diagnosis.where.end());
  EXPECT_NEAR(azimuth->low, -12.0, 1.01);
  EXPECT_NEAR(azimuth->high, -5.0, 1.01);
}

TEST(Diagnose, TellsForeignPulsesFromFalseAlarmsByTheirStrength) {
  const SmallWorld world;
  const auto baseline = SmallWorld::modelWith({});
  const auto foreign = SmallWorld::modelWith({{"crosstalk", {{"rate_1_s", 20000}}}});  // two in a hundred shots
  const gap::Diagnosis of_foreign = diagnosed(world.measuredBy(foreign, 0.4), baseline, {"crosstalk", "false-alarm"});
  EXPECT_EQ(of_foreign.verdict.names, std::vector<std::string>{"crosstalk"});
  EXPECT_NEAR(of_foreign.causes.front().parameters[0].value, 20000, 3000);

  const auto alarms = SmallWorld::modelWith({{"false-alarm", {{"rate_per_beam", 0.02}}}});
  const gap::Diagnosis of_alarms = diagnosed(world.measuredBy(alarms, 0.4), baseline, {"crosstalk", "false-alarm"});
  EXPECT_EQ(of_alarms.verdict.names, std::vector<std::string>{"false-alarm"});
  EXPECT_NEAR(of_alarms.causes.front().parameters[0].value, 0.02, 0.003);
}

TEST(Diagnose, FindsAnEffectThatARecalibratedEmitterHides) {
  const SmallWorld world;
  const auto truth = SmallWorld::modelWith({{"atmospheric-attenuation", {{"visibility_m", 300}}}});
  // 50 W in truth; the modeller took 38 W, with which the mean over all ranges agrees.
  const gap::Diagnosis diagnosis =
      diagnosed(world.measuredBy(truth, 0.4), SmallWorld::modelWith({}, {{"/sensor/emitter/peak_power_w", 38}}));
  EXPECT_EQ(diagnosis.verdict.kind, gap::VerdictKind::kEffect);
  EXPECT_EQ(diagnosis.verdict.names, std::vector<std::string>{"atmospheric-attenuation"});
  // Part of the shrink is the power's, or that of the wall's reflectivity, which is the same here.
  ASSERT_EQ(diagnosis.verdict.beside.size(), 1U);
  EXPECT_NE(diagnosis.verdict.text.find("and " + diagnosis.verdict.beside.front() + " corrected"), std::string::npos);
  const auto report = gap::reportJson(diagnosis);
  ASSERT_EQ(report["verdict"]["beside"].size(), 1U);
  EXPECT_EQ(report["verdict"]["beside"][0], report["causes"][1]["name"]) << "its value and interval are told, too";
}

// The clock is too fast: 1 mm a metre. A late trigger explains most of it, and leaves what grows with the distance.
TEST(Diagnose, NamesNoCauseThatLeavesWhatFollowsALaw) {
  const SmallWorld world;
  const auto truth = SmallWorld::modelWith({{"clock-drift", {{"scale_ppm", 1000}}}});
  const gap::DiagnoseOptions offsets_only{.library = {"range-offset"},
                                          .without = {.references = true, .parameters = true}};
  core::SilentProgress progress;
  const auto diagnosis = gap::diagnose(world.measuredBy(truth, 0.4), SmallWorld::modelWith({}), offsets_only, progress);
  EXPECT_EQ(diagnosis.verdict.kind, gap::VerdictKind::kUnknown);
  ASSERT_TRUE(diagnosis.rest.has_value());
  ASSERT_FALSE(diagnosis.rest->laws.empty());
  EXPECT_EQ(diagnosis.rest->laws.front().terms.front().covariate, "range_m");
}

// A wall whose edge cuts beams in a held-out sample, and fog that is missing.
TEST(Diagnose, TellsBesideItsOwnGapTheOneThatTheModelHasWhenItIsRun) {
  SmallWorld world;
  world.withAWallOf(2.0 * 19.0 * std::tan(12.0 * core::kRadPerDeg + 0.95e-3));
  const model::LidarModel model = SmallWorld::modelWith({});
  const model::Experiment experiment =
      world.measuredBy(SmallWorld::modelWith({{"atmospheric-attenuation", {{"visibility_m", 300}}}}), 0.4);
  const gap::Diagnosis diagnosis = diagnosed(experiment, model, {"atmospheric-attenuation"});
  ASSERT_TRUE(diagnosis.as_run.has_value());
  std::vector<gap::TotalGap> gaps;
  for (std::size_t s = 0; s < experiment.samples.size(); ++s) {
    const model::Sample& sample = experiment.samples[s];
    if (std::count(diagnosis.held_out.begin(), diagnosis.held_out.end(), sample.id) == 0) continue;
    const core::Detections measured = model::readMeasurements(experiment, sample);
    gaps.push_back(
        gap::totalGap(experiment.measurands, measured, model::simulate(experiment, model, s), sample.frames));
  }
  ASSERT_FALSE(gaps.empty());
  EXPECT_NEAR(diagnosis.as_run->before_total, gap::meanOf(gaps).total, 1e-9);
  EXPECT_NE(diagnosis.as_run->before_total, diagnosis.before.total) << "the test must see an edge";
}

// Of tall beams on a wall that leans by 80 degrees three sub-rays return echoes of their own: three of every shot in
// place of one.
TEST(Diagnose, SaysThatMoreRaysTakeAwayWhatTheModelsOwnGridMakesOfObliqueSurfaces) {
  const auto withRays = [](int in_a_row) {
    return SmallWorld::withRays(in_a_row, {{"pulse-broadening", nlohmann::json::object()}}, SmallWorld::tallBeams());
  };
  SmallWorld world;
  model::Experiment experiment = world.leaning(80.0).measuredBy(withRays(51), 0.4);
  std::erase_if(experiment.samples,
                [](const model::Sample& s) { return s.id != "r8" && s.id != "r13" && s.id != "r19"; });
  const gap::Diagnosis diagnosis = diagnosed(experiment, withRays(3), {"range-offset"});
  ASSERT_TRUE(diagnosis.as_run.has_value());
  EXPECT_GT(diagnosis.as_run->before_total, 2.0 * diagnosis.before.total);
  EXPECT_THAT(diagnosis.notes, testing::Contains(testing::HasSubstr("3 × 3 rays per beam")));
}

// A cover that takes 3 % of the light, behind a power that is 2 % too low: both must be right within a per cent, or the
// pair is farther from the data than the model as it was brought.
TEST(Diagnose, FindsAnEffectThatACalibrationHidesButForAPerCent) {
  const SmallWorld world;
  const SmallWorld::Effects dirt = {
      {"cover-contamination", {{"attenuation", 0.03}, {"azimuth_from_deg", -9.0}, {"azimuth_to_deg", 5.0}}}};
  const gap::Diagnosis diagnosis =
      diagnosed(world.measuredBy(SmallWorld::modelWith(dirt), 0.4),
                SmallWorld::modelWith({}, {{"/sensor/emitter/peak_power_w", 49}}),
                {"cover-contamination", "blooming", "exhaust-cloud", "angular-reflection"});
  EXPECT_EQ(diagnosis.verdict.names, std::vector<std::string>{"cover-contamination"});
  ASSERT_FALSE(diagnosis.causes.empty());
  EXPECT_NEAR(diagnosis.causes.front().parameters[0].value, 0.03, 0.004);
}

// Fog explains all but a thousandth of the gap; what it leaves, an offset of all ranges, is far more than noise.
TEST(Diagnose, FindsASecondCauseThatIsAThousandthOfTheGap) {
  const SmallWorld world;
  const SmallWorld::Effects both = {{"atmospheric-attenuation", {{"visibility_m", 200}}},
                                    {"range-offset", {{"offset_m", 0.004}}}};
  const gap::Diagnosis diagnosis = diagnosed(world.measuredBy(SmallWorld::modelWith(both), 0.4),
                                             SmallWorld::modelWith({}), {"atmospheric-attenuation", "range-offset"});
  EXPECT_THAT(diagnosis.verdict.names, testing::UnorderedElementsAre("atmospheric-attenuation", "range-offset"));
}

TEST(Diagnose, SaysParameterWhereTheEchoPulseWidthScattersMoreThanItsProfile) {
  const SmallWorld world;
  const auto truth = SmallWorld::modelWith({}, {{"/sensor/detection/epw_noise_m", 0.09}});
  const gap::Diagnosis diagnosis = diagnosed(world.measuredBy(truth, 0.4), SmallWorld::modelWith({}));
  EXPECT_EQ(diagnosis.verdict.kind, gap::VerdictKind::kParameter);
  EXPECT_EQ(diagnosis.verdict.names, std::vector<std::string>{"/sensor/detection/epw_noise_m"});
}

// Only the duration of the pulses jitters. The effect's other number says nothing and is counted as a choice unless it
// is where it does nothing.
TEST(Diagnose, PutsANumberThatSaysNothingWhereItDoesNothing) {
  const SmallWorld world;
  const auto truth = SmallWorld::modelWith({{"pulse-jitter", {{"duration_stddev_ns", 0.3}}}});
  const auto diagnosis = diagnosed(world.measuredBy(truth, 0.4), SmallWorld::modelWith({}), {"pulse-jitter"});
  ASSERT_EQ(diagnosis.verdict.names, std::vector<std::string>{"pulse-jitter"});
  for (const gap::FittedParameter& parameter : diagnosis.causes.front().parameters) {
    const bool jitters = parameter.name == "duration_stddev_ns";
    EXPECT_NEAR(parameter.value, jitters ? 0.3 : 0.0, jitters ? 0.015 : 0.0) << parameter.name;
  }
}

TEST(Diagnose, BlamesTheReferenceWhereOneSetUpStandsElsewhereThanRecorded) {
  const SmallWorld world;
  const auto model = SmallWorld::modelWith({});
  const gap::Diagnosis diagnosis = diagnosed(world.measuredBy(model, 0.4, {{"r13", 0.12}, {"r36", -0.08}}), model);
  ASSERT_EQ(diagnosis.verdict.kind, gap::VerdictKind::kReference);
  EXPECT_EQ(diagnosis.verdict.names, std::vector<std::string>{"/scene/0/pose/position_m/0"});
  EXPECT_NEAR(diagnosis.causes.front().setups.at("r13").value, 0.12, 0.005);
  EXPECT_NEAR(diagnosis.causes.front().setups.at("r36").value, -0.08, 0.005);
  EXPECT_NEAR(diagnosis.causes.front().setups.at("r19").value, 0.0, 0.005);
}

/// Of a wall that stands 0.3 m behind its recorded place.
gap::Diagnosis diagnosedBehindItsPlace(const SmallWorld::Effects& truth) {
  const SmallWorld world;
  std::map<std::string, double> offsets_m;
  for (const char* setup : {"r8", "r13", "r19", "r27", "r36", "r46"}) offsets_m[setup] = 0.3;
  return diagnosed(world.measuredBy(SmallWorld::modelWith(truth), 0.4, offsets_m), SmallWorld::modelWith({}));
}

TEST(Diagnose, NamesAnEffectBesideAWrongReferenceIfNothingIsLeftWithBoth) {
  const gap::Diagnosis diagnosis = diagnosedBehindItsPlace({{"detection-loss", {{"probability", 0.1}}}});
  EXPECT_EQ(diagnosis.verdict.names, std::vector<std::string>{"detection-loss"});
  EXPECT_EQ(diagnosis.verdict.beside, std::vector<std::string>{"/scene/0/pose/position_m/0"});
}

// Where something else is missing, too, the reference is corrected first.
TEST(Diagnose, ClaimsNoEffectBesideAWrongReferenceThatExplainsHalfOfWhatThatLeaves) {
  const gap::Diagnosis diagnosis = diagnosedBehindItsPlace(
      {{"detection-loss", {{"probability", 0.1}}}, {"pulse-jitter", {{"duration_stddev_ns", 0.2}}}});
  ASSERT_EQ(diagnosis.verdict.kind, gap::VerdictKind::kReference) << diagnosis.verdict.text;
  EXPECT_EQ(diagnosis.verdict.names, std::vector<std::string>{"/scene/0/pose/position_m/0"});
}

/// In alphabetical order.
std::vector<std::string> namedFor(const SmallWorld::Effects& truth) {
  const SmallWorld world;
  const auto measured = world.measuredBy(SmallWorld::modelWith(truth), 0.4);
  std::vector<std::string> names = diagnosed(measured, SmallWorld::modelWith({})).verdict.names;
  std::sort(names.begin(), names.end());
  return names;
}

TEST(Diagnose, NamesBothOfTwoEffectsThoughOneIsSmallBesideTheOther) {
  EXPECT_EQ(
      namedFor({{"atmospheric-attenuation", {{"visibility_m", 400}}}, {"detection-loss", {{"probability", 0.08}}}}),
      (std::vector<std::string>{"atmospheric-attenuation", "detection-loss"}));
}

// Of a hundred shots one is lost, which no few frames show.
TEST(Diagnose, NamesARareLossBesideALargerCause) {
  const SmallWorld world;
  const auto truth =
      SmallWorld::modelWith({{"clock-drift", {{"scale_ppm", 2000}}}, {"detection-loss", {{"probability", 0.008}}}});
  const gap::Diagnosis diagnosis = diagnosed(world.measuredBy(truth, 0.4), SmallWorld::modelWith({}));
  EXPECT_THAT(diagnosis.verdict.names, testing::UnorderedElementsAre("clock-drift", "detection-loss"));
}

// The gate takes the farthest wall only, which is held out: of the samples that are fitted none can tell of it, but the
// map, which all samples made, suggests it.
TEST(Diagnose, NamesASecondCauseThatShowsInHeldOutSamplesOnly) {
  const SmallWorld world;
  const auto truth = SmallWorld::modelWith(
      {{"clock-drift", {{"scale_ppm", 2000}}}, {"range-gating", {{"from_m", 0.0}, {"to_m", 40.0}}}});
  const auto experiment =
      withRoles(world.measuredBy(truth, 0.4), {{"r46", model::Role::kPrediction}, {"r36", model::Role::kValidation}});
  const gap::Diagnosis diagnosis = diagnosed(experiment, SmallWorld::modelWith({}));
  EXPECT_THAT(diagnosis.verdict.names, testing::UnorderedElementsAre("clock-drift", "range-gating"));
  EXPECT_FALSE(diagnosis.weak_hold_out);  // whole samples judge
  EXPECT_THAT(diagnosis.held_out, testing::ElementsAre("r19", "r46"));
  EXPECT_NEAR(diagnosis.as_run->before_total, diagnosis.before.total, 0.1 * diagnosis.before.total);
}

// A calibration that is off by two per cent is in all samples; what it was made up for, in the nearest, held-out one.
TEST(Diagnose, NamesTheEffectBesideACalibrationThatShowsInHeldOutSamplesOnly) {
  const auto narrow = SmallWorld::narrowView();
  const SmallWorld world;
  const auto truth = SmallWorld::modelWith({{"aperture-offset", {{"offset_m", 0.054}}}}, narrow);
  const auto experiment =
      withRoles(world.measuredBy(truth, 0.4), {{"r8", model::Role::kPrediction}, {"r36", model::Role::kValidation}});
  auto recalibrated = narrow;
  recalibrated["/sensor/emitter/peak_power_w"] = 49.0;
  const gap::Diagnosis diagnosis =
      diagnosed(experiment, SmallWorld::modelWith({}, recalibrated), {"aperture-offset", "atmospheric-attenuation"});
  ASSERT_EQ(diagnosis.verdict.names, std::vector<std::string>{"aperture-offset"});
  EXPECT_NEAR(diagnosis.causes.front().parameters[0].value, 0.054, 0.001);
  EXPECT_TRUE(diagnosis.weak_hold_out);
  // How far the gap shrinks is said of the held-out samples all the same.
  EXPECT_THAT(diagnosis.held_out, testing::ElementsAre("r8", "r19"));
}

// Every sample keeps the losses that the library lacks; what the held-out one shows besides is far more.
TEST(Diagnose, NamesTheEffectOfAHeldOutSampleThoughTheOthersKeepARest) {
  const auto narrow = SmallWorld::narrowView();
  const SmallWorld world;
  const auto truth = SmallWorld::modelWith(
      {{"aperture-offset", {{"offset_m", 0.054}}}, {"detection-loss", {{"probability", 0.06}}}}, narrow);
  const auto experiment =
      withRoles(world.measuredBy(truth, 0.4), {{"r8", model::Role::kPrediction}, {"r36", model::Role::kValidation}});
  const gap::Diagnosis diagnosis =
      diagnosed(experiment, SmallWorld::modelWith({}, narrow), {"aperture-offset", "atmospheric-attenuation"});
  ASSERT_EQ(diagnosis.verdict.names, std::vector<std::string>{"aperture-offset"});
  EXPECT_NEAR(diagnosis.causes.front().parameters[0].value, 0.054, 0.001);
  EXPECT_TRUE(diagnosis.weak_hold_out);
}

// The aperture shows on the nearest wall alone, which is fitted; what the held-out ones keep besides, lost detections
// that the library lacks, is a gap beyond doubt as well, but a small one.
TEST(Diagnose, NamesTheEffectOfAFittedSampleThoughTheHeldOutOnesKeepARest) {
  const auto narrow = SmallWorld::narrowView();
  const SmallWorld world;
  const auto truth = SmallWorld::modelWith({{"aperture-offset", {{"offset_m", 0.054}}},
                                            {"atmospheric-attenuation", {{"visibility_m", 800.0}}},
                                            {"detection-loss", {{"probability", 0.06}}}},
                                           narrow);
  const gap::Diagnosis diagnosis = diagnosed(world.measuredBy(truth, 0.4), SmallWorld::modelWith({}, narrow),
                                             {"aperture-offset", "atmospheric-attenuation"});
  EXPECT_THAT(diagnosis.verdict.names, testing::UnorderedElementsAre("aperture-offset", "atmospheric-attenuation"));
}

// Without the haze the aperture explains nothing that is held out: there the lost detections are the whole gap, which
// is a small one beside that of the fitted samples.
TEST(Diagnose, NamesTheEffectOfAFittedSampleThatDoesNothingInTheHeldOutOnes) {
  const auto narrow = SmallWorld::narrowView();
  const SmallWorld world;
  const auto truth = SmallWorld::modelWith(
      {{"aperture-offset", {{"offset_m", 0.056}}}, {"detection-loss", {{"probability", 0.03}}}}, narrow);
  const gap::Diagnosis diagnosis = diagnosed(world.measuredBy(truth, 0.4), SmallWorld::modelWith({}, narrow),
                                             {"aperture-offset", "atmospheric-attenuation"});
  ASSERT_EQ(diagnosis.verdict.names, std::vector<std::string>{"aperture-offset"});
  EXPECT_NEAR(diagnosis.causes.front().parameters[0].value, 0.056, 0.001);
  EXPECT_TRUE(diagnosis.weak_hold_out);
}

// 50.37 mm take a hundredth or two of the light of the nearest wall alone, which no fitted sample sees: with the noise
// of all held-out cells that is no gap beyond doubt, and no even search of the others leads there.
TEST(Diagnose, NamesASmallEffectOfASingleHeldOutSample) {
  const auto narrow = SmallWorld::narrowView();
  const SmallWorld world;
  const auto truth = SmallWorld::modelWith({{"aperture-offset", {{"offset_m", 0.05037}}}}, narrow);
  const auto experiment = withRoles(
      world.measuredBy(truth, 0.4),
      {{"r8", model::Role::kPrediction}, {"r13", model::Role::kPrediction}, {"r36", model::Role::kValidation}});
  const gap::Diagnosis diagnosis =
      diagnosed(experiment, SmallWorld::modelWith({}, narrow), {"aperture-offset", "atmospheric-attenuation"});
  ASSERT_EQ(diagnosis.verdict.names, std::vector<std::string>{"aperture-offset"});
  EXPECT_NEAR(diagnosis.causes.front().parameters[0].value, 0.05037, 0.0003);
  EXPECT_LT(diagnosis.verdict.evidence.gap_z, gap::Yardstick::kClear_z);
  EXPECT_TRUE(diagnosis.weak_hold_out);
}

// What the fog leaves where all data are pooled is that every wall stands 2 cm beside its recorded place, as it may.
// The gains of the layers change nothing of that, but without them what is left in single cells is a gap of its own.
TEST(Diagnose, NamesASecondCauseThatPooledDataHide) {
  SmallWorld world;
  world.knownToWithin(0.025);
  const auto truth =
      SmallWorld::modelWith({{"atmospheric-attenuation", {{"visibility_m", 800}}},
                             {"photo-response-nonuniformity", {{"gain_per_layer", {1.005, 0.995, 1.005, 0.995}}}}});
  const auto measured = world.measuredBy(
      truth, 0.4, {{"r8", 0.02}, {"r13", -0.02}, {"r19", 0.02}, {"r27", -0.02}, {"r36", -0.02}, {"r46", 0.02}});
  const gap::Diagnosis diagnosis =
      diagnosed(measured, SmallWorld::modelWith({}),
                {"atmospheric-attenuation", "photo-response-nonuniformity", "range-offset", "saturation"});
  EXPECT_THAT(diagnosis.verdict.names,
              testing::UnorderedElementsAre("atmospheric-attenuation", "photo-response-nonuniformity"));
}

// The fit of the dirt alone takes lost detections for dirt; where it ends, the residuals beside the losses say.
TEST(Diagnose, NamesASectorOfWeakDirtBesideLostDetections) {
  EXPECT_EQ(
      namedFor({{"cover-contamination", {{"attenuation", 0.02}, {"azimuth_from_deg", -3.4}, {"azimuth_to_deg", 11.4}}},
                {"detection-loss", {{"probability", 0.2}}}}),
      (std::vector<std::string>{"cover-contamination", "detection-loss"}));
}

// A warm detector is a larger `noise_w`, which does as well beside the dirt, but would not be named.
TEST(Diagnose, NamesTwoEffectsWhereAWrongNumberBesideOneWouldDoAsWell) {
  EXPECT_EQ(
      namedFor({{"cover-contamination", {{"attenuation", 0.1}, {"azimuth_from_deg", -3.4}, {"azimuth_to_deg", 11.4}}},
                {"thermal-noise", {{"temperature_degC", 45.0}}}}),
      (std::vector<std::string>{"cover-contamination", "thermal-noise"}));
}

TEST(Diagnose, SaysNoneWhereEverySetUpStandsElsewhereWithinItsTolerance) {
  SmallWorld world;
  world.knownToWithin(0.03);
  const auto model = SmallWorld::modelWith({});
  const std::map<std::string, double> offsets_m = {{"r8", 0.021},   {"r13", -0.018}, {"r19", 0.012},
                                                   {"r27", -0.024}, {"r36", 0.006},  {"r46", -0.009}};
  const gap::Diagnosis diagnosis = diagnosed(world.measuredBy(model, 0.4, offsets_m), model);
  EXPECT_EQ(diagnosis.verdict.kind, gap::VerdictKind::kNone);
}

TEST(Diagnose, NamesAnOffsetCommonToAllSetUpsThoughEachAloneWereWithinItsTolerance) {
  SmallWorld world;
  world.knownToWithin(0.03);
  const auto truth = SmallWorld::modelWith({{"range-offset", {{"offset_m", 0.06}}}});
  const gap::Diagnosis diagnosis = diagnosed(world.measuredBy(truth, 0.4), SmallWorld::modelWith({}));
  EXPECT_EQ(diagnosis.verdict.names, std::vector<std::string>{"range-offset"});
  EXPECT_NEAR(diagnosis.causes.front().parameters.at(0).value, 0.06, 0.006);
}

TEST(Diagnose, SaysUnknownWhereTheCauseIsTakenOutOfTheLibrary) {
  const SmallWorld world;
  const auto truth = SmallWorld::modelWith(
      {{"cover-contamination", {{"attenuation", 0.25}, {"azimuth_from_deg", -6.5}, {"azimuth_to_deg", 4.5}}}});
  const gap::Diagnosis diagnosis =
      diagnosed(world.measuredBy(truth, 0.4), SmallWorld::modelWith({}), {"range-offset", "range-walk"});
  EXPECT_EQ(diagnosis.verdict.kind, gap::VerdictKind::kUnknown);
  EXPECT_TRUE(diagnosis.present);
  EXPECT_TRUE(diagnosis.proposed_model.is_null());
}

TEST(Diagnose, IsTheSameForAnyNumberOfThreads) {
  const SmallWorld world;
  const auto truth = SmallWorld::modelWith({{"range-offset", {{"offset_m", 0.07}}}});
  const auto experiment = world.measuredBy(truth, 0.4);
  const auto report = [&](int threads) {
    core::limitThreads(threads);
    auto json = gap::reportJson(diagnosed(experiment, SmallWorld::modelWith({}), {"range-offset", "detection-loss"}));
    json.erase("elapsed_s");
    return json.dump();
  };
  const std::string one = report(1), two = report(2);
  core::limitThreads(0);
  EXPECT_EQ(one, two);
}

TEST(Diagnose, StopsWhenCancelled) {
  class Impatient final : public core::Progress {
   public:
    void report(double fraction, std::string_view) override { late_ = fraction > 0.1; }
    [[nodiscard]] bool cancelled() const override { return late_; }

   private:
    bool late_ = false;
  } progress;
  const SmallWorld world;
  const auto truth = SmallWorld::modelWith({{"range-offset", {{"offset_m", 0.2}}}});
  const auto experiment = world.measuredBy(truth, 0.4);
  EXPECT_THROW((void)gap::diagnose(experiment, SmallWorld::modelWith({}), {}, progress), core::Cancelled);
}

}  // namespace
