#include <cmath>
#include <gmock/gmock.h>
#include <set>
#include <tinyxml2.h>

#include "acceptance/html_report.h"
#include "acceptance/junit.h"
#include "acceptance/result_json.h"
#include "acceptance/run.h"
#include "tests/acceptance/small_project.h"

namespace acceptance {
namespace {

using acceptance_test::SmallProject;
using testing::HasSubstr;
using testing::Not;
using tinyxml2::XMLElement;

/// A run with a passed, a failed, an erroneous and a skipped test.
RunResult mixedRun(const SmallProject& project) {
  project.addTest("RangeError_Offset_1", "abs(d_bias) <= 1 && d_cavm <= 1");
  project.addTest("RangeError_Offset_2", "abs(d_bias) <= 0.0001 * range_m");
  project.addTest("RangeError_Offset_3", "abs(d_bais) <= 1 && \"<>&\" < 1");
  specs::ProjectStore store = project.open();
  specs::AcceptanceTest inspection = SmallProject::rangeTest("RangeError_Offset_4", "");
  inspection.experiment = "";
  inspection.title = "look <at> it & think";
  store.add(inspection, acceptance_test::kSomebody);
  core::SilentProgress progress;
  return runTests(store, {}, progress);
}

std::vector<const XMLElement*> childrenOf(const XMLElement* element, const char* name) {
  std::vector<const XMLElement*> children;
  for (auto* child = element->FirstChildElement(name); child; child = child->NextSiblingElement(name)) {
    children.push_back(child);
  }
  return children;
}

TEST(JunitXml, TellsFailureErrorAndSkippedApartAndCountsThem) {
  const SmallProject project({.offset_m = 0.1});
  const std::string xml = junitXml(mixedRun(project));
  tinyxml2::XMLDocument document;
  ASSERT_EQ(document.Parse(xml.c_str()), tinyxml2::XML_SUCCESS) << document.ErrorStr();
  const XMLElement* root = document.RootElement();
  EXPECT_STREQ(root->Name(), "testsuites");
  EXPECT_EQ(root->IntAttribute("tests"), 6);  // two samples in the two tests that ran
  EXPECT_EQ(root->IntAttribute("failures"), 2);
  EXPECT_EQ(root->IntAttribute("errors"), 1);
  EXPECT_EQ(root->IntAttribute("skipped"), 1);
  const auto suites = childrenOf(root, "testsuite");
  ASSERT_EQ(suites.size(), 4u);
  EXPECT_EQ(suites[0]->FirstChildElement("testcase")->FirstChildElement("failure"), nullptr);
  EXPECT_NE(suites[1]->FirstChildElement("testcase")->FirstChildElement("failure"), nullptr);
  EXPECT_NE(suites[2]->FirstChildElement("testcase")->FirstChildElement("error"), nullptr);
  EXPECT_NE(suites[3]->FirstChildElement("testcase")->FirstChildElement("skipped"), nullptr);
}

TEST(JunitXml, NamesEachCaseOnceAndGivesItItsNumbers) {
  const SmallProject project({.offset_m = 0.1});
  const std::string xml = junitXml(mixedRun(project), "report.html");
  tinyxml2::XMLDocument document;
  ASSERT_EQ(document.Parse(xml.c_str()), tinyxml2::XML_SUCCESS);
  std::set<std::string> names;
  for (const XMLElement* suite : childrenOf(document.RootElement(), "testsuite")) {
    for (const XMLElement* one : childrenOf(suite, "testcase")) {
      EXPECT_TRUE(names.insert(one->Attribute("name")).second);
      EXPECT_THAT(one->Attribute("classname"), testing::StartsWith("small.RangeError_Offset_"));
      EXPECT_THAT(one->FirstChildElement("system-out")->GetText(), HasSubstr("[[ATTACHMENT|report.html]]"));
    }
  }
  std::map<std::string, std::string> properties;
  const XMLElement* failed = childrenOf(document.RootElement(), "testsuite")[1]->FirstChildElement("testcase");
  for (const XMLElement* property : childrenOf(failed->FirstChildElement("properties"), "property")) {
    properties[property->Attribute("name")] = property->Attribute("value");
  }
  EXPECT_EQ(properties["requirement"], "RangeError_Requirement_1");
  EXPECT_EQ(properties["expression"], "abs(d_bias) <= 0.0001 * range_m");
  EXPECT_NEAR(std::stod(properties["limit"]), 0.0008, 1e-12);
  EXPECT_NEAR(std::stod(properties["value"]), 0.1, 0.01);
  EXPECT_EQ(properties["unit"], "m");
}

TEST(ResultJson, HasTheDocumentedKeys) {
  const SmallProject project({.offset_m = 0.1});
  const nlohmann::ordered_json json = toJson(mixedRun(project));
  EXPECT_EQ(json.at("format"), "fidelis-acceptance");
  EXPECT_EQ(json.at("counts").at("failed"), 1);
  const auto& test = json.at("tests").at(1);
  EXPECT_EQ(test.at("verdict"), "failed");
  EXPECT_EQ(test.at("requirements").at(0), "RangeError_Requirement_1");
  EXPECT_EQ(test.at("experiment").at("synthetic"), true);
  EXPECT_EQ(test.at("model").at("path"), "model.json");
  const auto& relation = test.at("samples").at(0).at("relations").at(0);
  EXPECT_EQ(relation.at("order"), "<=");
  EXPECT_DOUBLE_EQ(relation.at("margin").get<double>(),
                   relation.at("limit").get<double>() - relation.at("value").get<double>());
  EXPECT_FALSE(test.at("samples").at(0).contains("figure"));
  EXPECT_EQ(json.at("tests").at(3).at("samples").size(), 0u);
}

TEST(HtmlReport, IsWellFormedAndShowsVerdictNumbersFiguresAndHashes) {
  const SmallProject project({.offset_m = 0.1});
  const RunResult run = mixedRun(project);
  const std::string html = htmlReport(run);
  tinyxml2::XMLDocument document;
  EXPECT_EQ(document.Parse(html.c_str()), tinyxml2::XML_SUCCESS) << document.ErrorStr();
  for (const char* word : {"PASSED", "FAILED", "ERROR", "SKIPPED", "look &lt;at&gt; it &amp; think", "<svg"}) {
    EXPECT_THAT(html, HasSubstr(word));
  }
  for (const specs::UsedFile& file : run.tests[0].used) EXPECT_THAT(html, HasSubstr(file.sha256));
  EXPECT_THAT(html, Not(HasSubstr(project.folder().path().string() + "/wall/measurements")));
}

TEST(HtmlReport, SaysThatTheDataAreSyntheticOnlyIfTheyAre) {
  const SmallProject synthetic;
  synthetic.addTest("RangeError_Offset_1", "n_real >= 1");
  const SmallProject measured({.offset_m = 0.0, .source = "measured on the roof, 2024"});
  measured.addTest("RangeError_Offset_1", "n_real >= 1");
  core::SilentProgress progress;
  EXPECT_THAT(htmlReport(runTests(synthetic.open(), {}, progress)), HasSubstr("Synthetic data."));
  EXPECT_THAT(htmlReport(runTests(measured.open(), {}, progress)), Not(HasSubstr("Synthetic data.")));
}

}  // namespace
}  // namespace acceptance
