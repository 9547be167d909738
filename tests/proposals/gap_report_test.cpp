#include "proposals/gap_report.h"

#include <gmock/gmock.h>

#include "core/error.h"
#include "core/file.h"
#include "core/json_object.h"
#include "gap/report/json.h"
#include "gap/report/rest_wording.h"
#include "tests/proposals/demo_project.h"
#include "tests/support/thrown_message.h"

namespace proposals {
namespace {

using test_proposals::DemoProject;
using ::testing::HasSubstr;

TEST(GapReport, HoldsWhatTheDiagnosisFound) {
  const DemoProject project;
  const gap::Diagnosis& diagnosis = DemoProject::diagnosis();
  const GapReport report = readGapReport(project.report());
  EXPECT_EQ(report.experiment, "foggy-sweep");
  EXPECT_EQ(report.verdict.names, diagnosis.verdict.names);
  EXPECT_EQ(report.verdict.text, diagnosis.verdict.text);
  EXPECT_EQ(report.shrink->fraction, diagnosis.shrink.fraction);
  EXPECT_EQ(report.held_out, diagnosis.held_out);
  EXPECT_EQ(report.sha256, core::sha256OfFile(project.report()));
  EXPECT_EQ(report.proposed_model, diagnosis.proposed_model);
  ASSERT_EQ(report.causes.size(), diagnosis.causes.size());
  EXPECT_EQ(report.causes[0].parameters[0].value, diagnosis.causes[0].parameters[0].value);
}

// Formats section 6: the total gap is the mean over the held-out samples, and the sum of what measurands and existence
// add.
TEST(GapReport, TotalsOfSamplesAndWeightsOfMeasurandsAddUp) {
  const DemoProject project;
  const GapReport report = readGapReport(project.report());
  ASSERT_EQ(report.samples.size(), report.held_out.size());
  double before = 0.0, after = 0.0;
  for (const gap::SampleTotals& sample : report.samples) {
    before += sample.before / double(report.samples.size());
    after += sample.after / double(report.samples.size());
  }
  EXPECT_NEAR(before, report.totals->first, 1e-9);
  EXPECT_NEAR(after, report.totals->second, 1e-9);
  EXPECT_NEAR(1.0 - after / before, report.shrink->fraction, 1e-9);
}

TEST(GapReport, KnowsWhatIsBesideTheCauseAndWhetherHalfOfTheBeamsJudged) {
  gap::Diagnosis diagnosis = DemoProject::diagnosis();
  EXPECT_FALSE(parseGapReport(gap::reportJson(diagnosis), "a.json").half_of_the_beams_fitted);
  diagnosis.weak_hold_out = true;
  diagnosis.verdict.beside = {"/sensor/emitter/peak_power_w"};
  const GapReport report = parseGapReport(gap::reportJson(diagnosis), "b.json");
  EXPECT_TRUE(report.half_of_the_beams_fitted);
  EXPECT_EQ(report.verdict.beside, diagnosis.verdict.beside);
}

TEST(GapReport, TheTimeItTookIsNoEvidence) {
  const DemoProject project;
  nlohmann::json json = gap::reportJson(DemoProject::diagnosis());
  const std::string once = parseGapReport(json, "a.json").evidence;
  json["elapsed_s"] = 1234.5;
  EXPECT_EQ(parseGapReport(json, "b.json").evidence, once);
  json["verdict"]["text"] = "Another sentence.";
  EXPECT_NE(parseGapReport(json, "b.json").evidence, once);
}

TEST(GapReport, AReportWithoutTheNewerKeysIsReadAndUnknownKeysArePassedOver) {
  nlohmann::json json = gap::reportJson(DemoProject::diagnosis());
  json.erase("proposed_model");
  json["shrink"].erase("samples");
  json["shrink"].erase("existence");
  json["of-a-later-version"] = true;
  const GapReport report = parseGapReport(json, "old.json");
  EXPECT_TRUE(report.proposed_model.is_null());
  EXPECT_TRUE(report.samples.empty());
}

TEST(GapReport, HoldsWhatIsToBeBorneInMind) {
  gap::Diagnosis diagnosis = DemoProject::diagnosis();
  EXPECT_FALSE(parseGapReport(gap::reportJson(diagnosis), "gap.json").approximation);
  diagnosis.notes = {"epw was left out."};
  diagnosis.approximation =
      gap::Approximation{.proxy = "near", .proxy_gap = 4.0, .noise = 1.0, .gap = 3.0, .ratio = 1.5, .text = "Far."};
  const GapReport report = parseGapReport(gap::reportJson(diagnosis), "gap.json");
  EXPECT_EQ(report.notes, diagnosis.notes);
  ASSERT_TRUE(report.approximation);
  EXPECT_EQ(report.approximation->proxy, "near");
  EXPECT_EQ(report.approximation->proxy_gap, 4.0);
  EXPECT_EQ(report.approximation->noise, 1.0);
  EXPECT_EQ(report.approximation->gap, 3.0);
  EXPECT_EQ(report.approximation->text, "Far.");
  EXPECT_FALSE(report.approximation->reliable());
}

TEST(GapReport, HoldsWhatIsLeftUnexplained) {
  gap::Diagnosis diagnosis = DemoProject::diagnosis();
  diagnosis.rest.reset();
  EXPECT_FALSE(parseGapReport(gap::reportJson(diagnosis), "gap.json").rest);
  const gap::Law law{.measurand = "epw",
                     .component = "bias",
                     .unit = "m",
                     .constant = 0.1,
                     .terms = {{"range_m", "1/x", 2.0}},
                     .explained = 0.75,
                     .relative = true};
  diagnosis.rest = gap::Rest{.left = 0.4, .systematic = 0.625, .laws = {law}};
  const GapReport report = parseGapReport(gap::reportJson(diagnosis), "gap.json");
  ASSERT_TRUE(report.rest);
  EXPECT_EQ(report.rest->left, 0.4);
  EXPECT_EQ(report.rest->systematic, 0.625);
  ASSERT_EQ(report.rest->laws.size(), 1U);
  EXPECT_EQ(gap::formulaOf(report.rest->laws[0]), gap::formulaOf(law));
  EXPECT_EQ(report.rest->laws[0].explained, 0.75);
  EXPECT_TRUE(report.rest->laws[0].relative);
}

TEST(GapReport, AnotherFileIsRefusedInWords) {
  const test_support::TemporaryFolder folder;
  const auto metric = folder.write("metric.json", R"({"format": "fidelis-metric", "version": 1})");
  EXPECT_THAT(test_support::thrownMessage([&] { (void)readGapReport(metric); }), HasSubstr("fidelis-gap"));
  nlohmann::json json = gap::reportJson(DemoProject::diagnosis());
  json["verdict"]["kind"] = "efect";
  EXPECT_THAT(test_support::thrownMessage([&] { (void)parseGapReport(json, "gap.json"); }), HasSubstr("/verdict/kind"));
}

}  // namespace
}  // namespace proposals
