#include "acceptance/evaluate.h"

#include <cmath>
#include <fstream>
#include <gmock/gmock.h>

#include "core/file.h"
#include "core/parallel.h"
#include "tests/acceptance/small_project.h"

namespace acceptance {
namespace {

using acceptance_test::SmallProject;
using specs::Verdict;
using testing::HasSubstr;

TestTask taskOf(const SmallProject& project, const specs::AcceptanceTest& test) {
  return {.test = test, .requirements = {}, .folder = project.folder().path(), .model = {}, .seed = {}};
}

TestResult evaluated(const SmallProject& project, const specs::AcceptanceTest& test) {
  core::SilentProgress progress;
  return evaluate(taskOf(project, test), progress);
}

TestResult evaluated(const SmallProject& project, const std::string& expression) {
  return evaluated(project, SmallProject::rangeTest("RangeError_1", expression));
}

TEST(Evaluate, SelectsTheValidationSamplesAndSimulatesCentreAndCorners) {
  const SmallProject project;
  const TestResult result = evaluated(project, "abs(d_bias) <= 0.005 * range_m");
  EXPECT_EQ(result.verdict, Verdict::Passed) << result.text;
  ASSERT_EQ(result.samples.size(), 2u);
  EXPECT_EQ(result.samples[0].id, "r8");
  EXPECT_EQ(result.samples[0].n_sim, (std::vector<std::size_t>{40, 40, 40}));  // centre, -2 mm, +2 mm
  EXPECT_EQ(result.samples[0].n_real, 40u);
  EXPECT_DOUBLE_EQ(result.samples[0].values.at("detection_rate_real"), 1.0);
  EXPECT_DOUBLE_EQ(result.samples[0].values.at("detection_rate_sim"), 1.0);
  EXPECT_DOUBLE_EQ(result.samples[1].decisive->limit, 0.05);
  EXPECT_TRUE(result.synthetic);
  EXPECT_EQ(result.unit, "m");
}

// A measurement that is b too long makes the simulation b too short: mean(sim) - mean(real) = -b. The p-box is 4 mm
// wide (± 2 mm) beside its sampling noise, and the range noise of 40 detections is 10 mm / sqrt(40) = 1.6 mm.
TEST(Evaluate, FindsTheOffsetOfTheMeasurementAsBiasWithItsSign) {
  const SmallProject project({.offset_m = 0.30});
  const TestResult result = evaluated(project, "abs(d_bias) <= 0.005 * range_m");
  EXPECT_EQ(result.verdict, Verdict::Failed);
  for (const SampleResult& sample : result.samples) {
    EXPECT_NEAR(sample.values.at("d_bias"), -0.30, 0.002 + 5 * 0.0016) << sample.id;
    EXPECT_NEAR(sample.values.at("d_plus") - sample.values.at("d_minus"), -sample.values.at("d_bias"), 1e-12);
  }
  EXPECT_THAT(result.text, HasSubstr("2 of 2 samples fail"));
  EXPECT_THAT(result.text, HasSubstr("is not <="));
  EXPECT_EQ(result.decisiveSample()->id, "r8");  // the tighter limit
}

TEST(Evaluate, SamplesMayBeNamedByRoleOrId) {
  const SmallProject project;
  specs::AcceptanceTest test = SmallProject::rangeTest("RangeError_1", "n_real >= 1");
  test.samples = {"prediction", "r8"};
  const TestResult result = evaluated(project, test);
  ASSERT_EQ(result.samples.size(), 2u);
  EXPECT_EQ(result.samples[0].id, "r8");
  EXPECT_EQ(result.samples[1].id, "r12");
  test.samples = {"r80"};
  EXPECT_THAT(evaluated(project, test).text, HasSubstr("Did you mean 'r8'?"));
  test.samples = {"calibration"};
  EXPECT_THAT(evaluated(project, test).text, HasSubstr("has no sample of role calibration"));
}

TEST(Evaluate, AGateKeepsOnlyItsRegionOnBothSides) {
  const SmallProject project;
  specs::AcceptanceTest test = SmallProject::rangeTest("RangeError_1", "n_real >= 1");
  test.gate = "front";  // 0.5 m around the wall
  EXPECT_EQ(evaluated(project, test).samples[0].n_real, 40u);
  test.gate = "wall";  // the object itself, 0.1 m around it
  EXPECT_EQ(evaluated(project, test).samples[0].n_real, 40u);
  const SmallProject far({.offset_m = 0.3});
  const TestResult outside = evaluated(far, test);
  EXPECT_EQ(outside.samples[0].n_real, 0u);
  EXPECT_EQ(outside.samples[0].n_sim[0], 40u);
  test.gate = "frnt";
  EXPECT_THAT(evaluated(project, test).text, HasSubstr("Did you mean 'front'?"));
}

TEST(Evaluate, AMeasurementWithoutDetectionsCannotDecideARangeButACount) {
  const SmallProject project;
  project.folder().write("wall/measurements/r8.csv", "frame,layer,azimuth_rad,elevation_rad,echo,range_m\n");
  const TestResult range = evaluated(project, "abs(d_bias) <= 1");
  EXPECT_EQ(range.verdict, Verdict::Error);
  EXPECT_THAT(range.text, HasSubstr("r8: the measurement has no detection to compare with"));
  EXPECT_EQ(evaluated(project, "n_real >= 1").verdict, Verdict::Failed);
}

TEST(Evaluate, ASimulationWithoutDetectionsFailsWhereTheMeasurementHasSome) {
  const SmallProject project;
  std::string experiment = core::readFile(project.folder() / "wall/experiment.json");
  const std::string bright = "\"reflectivity\": 0.5";
  experiment.replace(experiment.find(bright), bright.size(), "\"reflectivity\": 0.0");
  project.folder().write("wall/experiment.json", experiment);
  const TestResult result = evaluated(project, "abs(d_bias) <= 1");
  EXPECT_EQ(result.verdict, Verdict::Failed);
  EXPECT_THAT(result.samples[0].text, HasSubstr("has 40 detections, the simulation has none"));
}

TEST(Evaluate, WhatAUserMustRepairIsAnErrorWithItsPlace) {
  const SmallProject project;
  EXPECT_THAT(evaluated(project, "abs(d_bais) <= 1").text, HasSubstr("Did you mean 'd_bias'?"));
  EXPECT_EQ(evaluated(project, "abs(d_bais) <= 1").verdict, Verdict::Error);
  specs::AcceptanceTest test = SmallProject::rangeTest("RangeError_1", "d_bias <= 1");
  test.measurand = "rnge";
  EXPECT_THAT(evaluated(project, test).text, HasSubstr("Did you mean 'range'?"));
  test = SmallProject::rangeTest("RangeError_1", "d_bias <= 1");
  test.measurand = "epw";  // the measurement has no such column
  EXPECT_THAT(evaluated(project, test).text, HasSubstr("measurement: has no column 'epw_m'"));
  test = SmallProject::rangeTest("RangeError_1", "d_bias <= 1");
  test.experiment = "wal";
  EXPECT_EQ(evaluated(project, test).verdict, Verdict::Error);
  test = SmallProject::rangeTest("RangeError_1", "d_bias <= 1");
  test.options["shft"] = "one";
  EXPECT_THAT(evaluated(project, test).text, HasSubstr("option 'shft'"));
  test = SmallProject::rangeTest("RangeError_1", "d_bias <= 1");
  test.model = "";
  EXPECT_THAT(evaluated(project, test).text, HasSubstr("names no model"));
  project.folder().write("wall/measurements/r10.csv", "frame,range_m\n0,ten\n");
  EXPECT_THAT(evaluated(project, "d_bias <= 1").text, HasSubstr("r10.csv:2"));
}

// Ranks have no differences: their bias would be a number without a meaning. Ranks can be compared by their CDF.
TEST(Evaluate, AMetricOfDifferencesIsRefusedForAMeasurandOfRanks) {
  const SmallProject project;
  std::string experiment = core::readFile(project.folder() / "wall/experiment.json");
  const std::string ratio = R"("scale": "ratio")";
  experiment.replace(experiment.find(ratio), ratio.size(), R"("scale": "ordinal")");
  project.folder().write("wall/experiment.json", experiment);
  const TestResult refused = evaluated(project, "abs(d_bias) <= 1");
  EXPECT_EQ(refused.verdict, Verdict::Error);
  EXPECT_THAT(refused.text, HasSubstr("d_bias needs an interval scale, and the measurand 'range' is ordinal"));
  const TestResult allowed = evaluated(project, "ks_statistic <= 1");
  EXPECT_EQ(allowed.verdict, Verdict::Passed) << allowed.text;
  EXPECT_TRUE(std::isnan(allowed.samples[0].values.at("d_avm")));
}

// 40 detections of 10 mm noise: two such samples differ by 2 mm in shape although nothing is wrong with the model.
TEST(Evaluate, ALimitBelowWhatChanceAloneGivesIsRemarked) {
  const SmallProject project;
  const TestResult tight = evaluated(project, "d_cavm <= 0.0001 && abs(d_bias) <= 1");
  ASSERT_EQ(tight.samples[0].remarks.size(), 1u);
  EXPECT_THAT(tight.samples[0].remarks[0], HasSubstr("the limit of d_cavm, 0.0001 m, is below"));
  EXPECT_THAT(tight.samples[0].remarks[0], HasSubstr("n = 40"));
  EXPECT_TRUE(evaluated(project, "d_cavm <= 0.1").samples[0].remarks.empty());
  EXPECT_TRUE(evaluated(project, "abs(d_bias) <= 0.0001").samples[0].remarks.empty());  // a bias may be 0
}

TEST(Evaluate, ATestWithoutExperimentIsSkipped) {
  const SmallProject project;
  specs::AcceptanceTest test = SmallProject::rangeTest("RangeError_1", "");
  test.experiment = "";
  EXPECT_EQ(evaluated(project, test).verdict, Verdict::Skipped);
}

TEST(Evaluate, NotesEveryFileWithItsHashOnce) {
  const SmallProject project;
  const TestResult result = evaluated(project, "n_real >= 1");
  std::vector<std::string> paths;
  for (const specs::UsedFile& file : result.used) {
    paths.push_back(file.path);
    EXPECT_EQ(file.sha256, core::sha256(core::readFile(project.folder() / file.path)));
  }
  EXPECT_THAT(paths, testing::UnorderedElementsAre("wall/experiment.json", "wall/measurements/r8.csv",
                                                   "wall/measurements/r10.csv", "model.json"));
}

TEST(Evaluate, FramesOfTheTestLimitTheSimulation) {
  const SmallProject project;
  specs::AcceptanceTest test = SmallProject::rangeTest("RangeError_1", "frames_sim <= 10 && frames_real >= 40");
  test.frames = 10;
  const TestResult result = evaluated(project, test);
  EXPECT_EQ(result.verdict, Verdict::Passed) << result.text;
  EXPECT_EQ(result.samples[0].n_sim[0], 10u);
}

TEST(Evaluate, IsTheSameForAnyNumberOfThreads) {
  const SmallProject project;
  core::limitThreads(1);
  const TestResult one = evaluated(project, "abs(d_bias) <= 1");
  core::limitThreads(2);
  const TestResult two = evaluated(project, "abs(d_bias) <= 1");
  core::limitThreads(0);
  ASSERT_EQ(one.samples.size(), two.samples.size());
  for (std::size_t i = 0; i < one.samples.size(); ++i) {
    EXPECT_EQ(one.samples[i].values, two.samples[i].values);
    EXPECT_EQ(one.samples[i].figure, two.samples[i].figure);
  }
}

TEST(ExpressionVariables, AreAllUnderstoodByAnExpression) {
  const SmallProject project;
  for (const Variable& variable : expressionVariables()) {
    if (variable.name.starts_with("d_avm_max")) continue;  // slow, and computed as any other
    specs::AcceptanceTest test = SmallProject::rangeTest("RangeError_1", variable.name + " >= -1000");
    test.samples = {"r8"};
    test.frames = 5;
    const TestResult result = evaluated(project, test);
    if (variable.name.starts_with("kl") || variable.name.starts_with("js")) {
      EXPECT_THAT(result.text, HasSubstr("not defined here"))
          << variable.name;  // 1 cm steps are too coarse for densities
    } else {
      EXPECT_EQ(result.verdict, Verdict::Passed) << variable.name << ": " << result.text;
    }
  }
}

}  // namespace
}  // namespace acceptance
