#include "proposals/propose.h"

#include <algorithm>
#include <gmock/gmock.h>

#include "acceptance/evaluate.h"
#include "core/error.h"
#include "core/json_object.h"
#include "proposals/separating_test.h"
#include "tests/proposals/demo_project.h"
#include "tests/support/thrown_message.h"

namespace proposals {
namespace {

using test_proposals::DemoProject;
using test_proposals::kEve;
using test_proposals::kFogNode;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

class Propose : public ::testing::Test {
 protected:
  Proposed propose(const GapReport& of, const Sources& sources = {}) {
    core::SilentProgress progress;
    return proposals::propose(of, {specification, graph, project.folder().path()}, sources, progress);
  }

  DemoProject project;
  specs::Specification specification = project.open().specification();
  percollect::Graph graph = project.open().graph().value();
  GapReport report = readGapReport(project.report());
};

TEST_F(Propose, NamesTheRowsThatEndAtTheCausesNodeItsOwnChainFirst) {
  std::set<std::string> expected, proposed;
  for (const cepra::Row& row : specification.cepra.rows) {
    if (row.lastEffect().id == kFogNode) expected.insert(row.key);
  }
  const Proposed all = propose(report);
  for (const specs::Proposal& proposal : all.proposals) {
    if (!proposal.test) proposed.insert(proposal.row);
  }
  ASSERT_EQ(expected.size(), 3u);  // missed detections, ranges and pulse widths in fog
  EXPECT_EQ(proposed, expected);
  EXPECT_EQ(specification.cepra.find(all.proposals[0].row)->phenomenon().id, report.causes[0].chain.back());
  EXPECT_TRUE(all.notes.empty()) << all.notes.front();
}

TEST_F(Propose, TheRationaleHoldsTheEvidenceAndNoDate) {
  const specs::Proposal row = propose(report).proposals.front();
  for (const char* part : {"foggy-sweep", "demo-lidar", "visibility_m = ", "Held-out shrink ", "Synthetic data."}) {
    EXPECT_THAT(row.rationale, HasSubstr(part));
  }
  EXPECT_THAT(row.rationale, HasSubstr(report.verdict.text));
  EXPECT_THAT(row.rationale, HasSubstr(report.sha256.substr(0, 16)));
  EXPECT_THAT(row.rationale, ::testing::Not(::testing::ContainsRegex("20[0-9][0-9]-[0-9][0-9]")));
}

// The promise of the proposed test, kept by the acceptance run itself on files.
TEST_F(Propose, TheTestFailsWithTheModelAsItWasAndPassesWithTheCause) {
  const auto proposed = propose(report).proposals;
  ASSERT_TRUE(proposed.back().test);
  const specs::AcceptanceTest& test = *proposed.back().test;
  EXPECT_EQ(test.measurand, "epw");
  EXPECT_THAT(test.samples, ::testing::ElementsAreArray(report.held_out));
  EXPECT_THAT(proposed.back().requirements, ElementsAre("EchoPulseWidthError_Fog_1"));
  core::writeJson(project.folder() / "with-cause.json", report.proposed_model);
  const auto verdict = [&](const char* model) {
    core::SilentProgress progress;
    acceptance::TestTask task;
    task.test = test;
    task.test.id = "Proposed_1";
    task.folder = project.folder().path();
    task.model = project.folder() / model;
    return acceptance::evaluate(task, progress).verdict;
  };
  EXPECT_EQ(verdict("model.json"), specs::Verdict::Failed);
  EXPECT_EQ(verdict("with-cause.json"), specs::Verdict::Passed);
}

TEST_F(Propose, WithoutAProposedModelTheLimitLiesBetweenTheReportsMeansAndSaysSo) {
  report.proposed_model = nullptr;
  const auto epw =
      std::find_if(report.gaps.begin(), report.gaps.end(), [](const auto& gap) { return gap.name == "epw"; });
  ASSERT_NE(epw, report.gaps.end());
  epw->bias = 0.366;
  epw->bias_after = 0.001;
  const auto proposed = propose(report).proposals;
  ASSERT_TRUE(proposed.back().test);
  EXPECT_EQ(proposed.back().test->expression, "abs(d_bias) <= 0.18");  // half of 0.366 and 0.001, two digits
  EXPECT_THAT(proposed.back().rationale, HasSubstr("not judged by re-simulation yet"));
}

TEST_F(Propose, TheSameReportProposesTheSameThingOnce) {
  auto store = project.open();
  const auto first = store.addProposals(propose(report).proposals, kEve);
  EXPECT_EQ(first.size(), 4u);
  EXPECT_TRUE(store.addProposals(propose(report).proposals, kEve).empty());
  EXPECT_EQ(store.proposals().size(), 4u);
}

TEST_F(Propose, AVerdictThatNamesNoEffectProposesNothingAndSaysWhy) {
  report.verdict.kind = gap::VerdictKind::kReference;
  const Proposed nothing = propose(report);
  EXPECT_TRUE(nothing.proposals.empty());
  EXPECT_THAT(nothing.notes, ElementsAre(HasSubstr("the verdict is 'reference'")));
}

TEST_F(Propose, AnExperimentThatTheProjectDoesNotKnowLeavesTheTestOutAndSaysHow) {
  report.experiment = "elsewhere";
  const Proposed proposed = propose(report);
  EXPECT_EQ(proposed.proposals.size(), 3u);
  EXPECT_THAT(proposed.notes, ElementsAre(HasSubstr("experiment 'elsewhere'")));
}

TEST_F(Propose, AModelOfAnotherIdIsRefused) {
  report.model = "another";
  EXPECT_THAT(test_support::thrownMessage(
                  [&] { (void)propose(report, {.experiment = {}, .model = project.folder() / "model.json"}); }),
              HasSubstr("the report is of 'another'"));
}

// Ids of the library mean something in LidarLimbs only; in other trees the tag binds.
TEST_F(Propose, AGraphWithoutTheEffectGivesANoteInPlaceOfRows) {
  report.causes[0].name = report.verdict.names[0] = "speckle";
  report.causes[0].chain.clear();
  EXPECT_THAT(propose(report).notes, ::testing::Contains(HasSubstr("fidelis-effect:speckle")));
}

TEST(RoundBetween, KeepsTwoDigitsWhereTheyLieBetween) {
  EXPECT_EQ(roundBetween(0.0, 0.366), 0.18);
  EXPECT_EQ(roundBetween(1.001, 1.002), 1.0015);
  const double above = roundBetween(0.02, std::numeric_limits<double>::infinity());
  EXPECT_GT(above, 0.02);
  EXPECT_LT(above, 1.0);
}

}  // namespace
}  // namespace proposals
