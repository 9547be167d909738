#include "specs/rules.h"

#include <gmock/gmock.h>

#include "tests/specs/small_project.h"
#include "tests/support/paths.h"

namespace specs {
namespace {

/// A specification in which every rule holds; each test breaks one.
class ARule : public ::testing::Test {
 protected:
  ARule() {
    test_support::TemporaryFolder folder;
    auto store = ProjectStore::create(folder / "demo.fidelis");
    test_specs::fill(store);
    spec = store.specification();
    for (auto& item : spec.requirements) item.text = "text";
    for (auto& item : spec.tests) item.text = "text";
    for (auto& item : spec.experiment_data) item.text = "text";
    for (auto& item : spec.reference_data) {
      item.text = "text";
      item.device = "tape measure";
    }
  }
  std::vector<std::string> broken(const RuleOptions& options = {}) const {
    std::vector<std::string> rules;
    for (const RuleFinding& finding : checkSpecification(spec, options)) rules.push_back(finding.rule);
    return rules;
  }
  void unlink(const std::string& to) {
    std::erase_if(spec.links, [&](const Link& link) { return link.to == to; });
  }
  Specification spec;
};

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST_F(ARule, HoldsInAWellKeptSpecification) { EXPECT_THAT(broken(), IsEmpty()); }

TEST_F(ARule, AcceptedRequirementsNeedATestThatCounts) {
  spec.tests[0].status = Status::Rejected;
  EXPECT_THAT(broken(), ElementsAre("requirement-untested", "requirement-untested", "accepted-on-rejected"));
  spec.requirements[0].status = spec.requirements[1].status = Status::UnderReview;
  EXPECT_THAT(broken(), IsEmpty());
}

TEST_F(ARule, ATestNeedsARequirement) {
  unlink("RangeError_Fog_3");
  EXPECT_THAT(broken(), Contains("test-without-requirement"));
}

TEST_F(ARule, ATestOnMeasuredDataNeedsBothDataRequirements) {
  unlink("RangeError_Fog_4");
  EXPECT_THAT(broken(), ElementsAre("test-without-experiment-data"));
  unlink("RangeError_Fog_5");
  EXPECT_THAT(broken(), ElementsAre("test-without-experiment-data", "test-without-reference-data"));
  spec.tests[0].experiment = "";  // an inspection measures nothing
  EXPECT_THAT(broken(), IsEmpty());
}

TEST_F(ARule, ReferenceDataMayFollowFromExperimentData) {
  unlink("RangeError_Fog_5");
  spec.links.push_back({"RangeError_Fog_4", "RangeError_Fog_5"});
  EXPECT_THAT(broken(), IsEmpty());
}

TEST_F(ARule, LinksHaveEndsDirectionAndNoCircle) {
  spec.links.push_back({"RangeError_Fog_1", "Nobody_Knows_1"});
  EXPECT_THAT(broken(), ElementsAre("link-dangling"));
  spec.links.back() = {"RangeError_Fog_4", "RangeError_Fog_1"};
  EXPECT_THAT(broken(), Contains("link-direction"));
  spec.links.back() = {"RangeError_Fog_2", "RangeError_Fog_1"};
  EXPECT_THAT(broken(), ElementsAre("link-circle", "link-circle"));
  spec.links.back() = {"RangeError_Fog_1", "RangeError_Fog_3", true};
  EXPECT_THAT(broken(), ElementsAre("link-suspect"));
}

TEST_F(ARule, IdsAreWellFormedAndUnique) {
  spec.requirements[0].id = "RangeError_Fog_2";
  EXPECT_THAT(broken(), Contains("id-doubled"));
  spec.requirements[0].id = "fog";
  EXPECT_THAT(broken(), Contains("id-format"));
}

TEST_F(ARule, RelevantRowsNeedARequirement) {
  unlink("RangeError_Fog_1");
  EXPECT_THAT(broken(), ElementsAre("row-without-requirement"));  // 7 + 9
  EXPECT_THAT(broken({.relevant_from = 17}), IsEmpty());
}

TEST_F(ARule, RequirementsFollowFromRowsThatAreThere) {
  spec.cepra.rows.back().gone = true;
  EXPECT_THAT(broken(), Contains("row-gone"));
  unlink("RangeError_Fog_2");
  EXPECT_THAT(broken(), Contains("requirement-without-origin"));
}

TEST_F(ARule, ScoresHaveARationale) {
  spec.cepra.rows.back().impact.rationale = "";
  EXPECT_THAT(broken(), ElementsAre("score"));
}

TEST_F(ARule, DataRequirementsSayWithWhatAndHowWell) {
  spec.experiment_data[0].device = "";
  spec.reference_data[0].uncertainty = "";
  spec.tests[0].expression = "";
  spec.requirements[0].text = "";
  EXPECT_THAT(broken(), ElementsAre("test-undecidable", "text-missing", "device-missing", "uncertainty-missing"));
}

TEST_F(ARule, FilesOfTestsAreLookedForFromTheProject) {
  test_support::TemporaryFolder folder;
  EXPECT_THAT(broken({.folder = folder.path()}), ElementsAre("test-file-missing", "test-file-missing"));
  std::filesystem::create_directories(folder / "experiments/range-sweep");
  std::filesystem::create_directories(folder / "models");
  folder.write("models/demo.json", "{}");
  EXPECT_THAT(broken({.folder = folder.path()}), IsEmpty());
}

TEST(Rules, HaveUniqueNames) {
  std::set<std::string_view> names;
  for (const Rule& rule : allRules()) EXPECT_TRUE(names.insert(rule.uid).second) << rule.uid;
}

TEST(Rules, AFindingIsOneLineWithItsRemedy) {
  EXPECT_EQ(toString(RuleFinding{"text-missing", Severity::Warning, "A_B_1", "has no text.", "Write one."}),
            "A_B_1: warning: has no text. Write one. [text-missing]");
}

}  // namespace
}  // namespace specs
