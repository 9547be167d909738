#include "proposals/decide.h"

#include <gmock/gmock.h>

#include "core/error.h"
#include "proposals/propose.h"
#include "specs/rules.h"
#include "tests/proposals/demo_project.h"
#include "tests/support/thrown_message.h"

namespace proposals {
namespace {

using test_proposals::DemoProject;
using test_proposals::kEve;
using ::testing::HasSubstr;
using ::testing::Not;

const specs::Signature kAdam{.who = "adam", .when = "2026-02-03T04:05:06Z"};

class Decide : public ::testing::Test {
 protected:
  Decide() {
    core::SilentProgress progress;
    const auto specification = store.specification();
    const auto graph = store.graph().value();
    const auto proposed =
        propose(readGapReport(project.report()), {specification, graph, project.folder().path()}, {}, progress);
    store.addProposals(proposed.proposals, kEve);
  }
  [[nodiscard]] specs::Proposal proposal(const std::string& id) const {
    const auto all = store.proposals();
    return *specs::findProposal(all, id);
  }
  [[nodiscard]] cepra::Row row(const std::string& id) const { return *store.cepra().find(proposal(id).row); }

  DemoProject project;
  specs::ProjectStore store = project.open();
};

TEST_F(Decide, AcceptingWritesOccurrenceAndEvidenceAndLeavesImpactAndOtherRows) {
  const cepra::Table before = store.cepra();
  const cepra::Row old_row = row("P1");
  accept(store, "P1", Changed::Refuse, kAdam);
  const cepra::Row now = row("P1");
  EXPECT_EQ(now.occurrence.value, proposal("P1").occurrence);
  EXPECT_EQ(now.occurrence.expert, "adam");
  EXPECT_THAT(now.occurrence.rationale, HasSubstr(old_row.occurrence.rationale));
  EXPECT_THAT(now.occurrence.rationale, HasSubstr(proposal("P1").rationale));
  EXPECT_EQ(now.impact, old_row.impact);
  for (const cepra::Row& other : store.cepra().rows) {
    if (other.key == now.key) continue;
    EXPECT_EQ(other, *before.find(other.key));
  }
}

TEST_F(Decide, WhoAndWhenAndWhyAreKept) {
  accept(store, "P1", Changed::Refuse, kAdam);
  dismiss(store, "P2", "  the chamber is denser than any fog here ", kAdam);
  EXPECT_EQ(proposal("P1").state, specs::ProposalState::Accepted);
  EXPECT_EQ(proposal("P2").reason, "the chamber is denser than any fog here");
  EXPECT_EQ(proposal("P2").decided_by, "adam");
  EXPECT_EQ(proposal("P2").decided_at, kAdam.when);
  EXPECT_EQ(proposal("P2").proposed_by, "eve");
  EXPECT_EQ(store.history(proposal("P1").row).back().what, "proposal P1 accepted");
  EXPECT_EQ(store.history(proposal("P2").row).back().what,
            "proposal P2 dismissed: the chamber is denser than any fog here");
}

TEST_F(Decide, DismissingLeavesTheRowAndNeedsAReason) {
  const cepra::Table before = store.cepra();
  EXPECT_THAT(test_support::thrownMessage([&] { dismiss(store, "P1", "  ", kAdam); }), HasSubstr("needs a reason"));
  EXPECT_TRUE(proposal("P1").isOpen());
  dismiss(store, "P1", "no", kAdam);
  EXPECT_EQ(store.cepra(), before);
}

TEST_F(Decide, ARowThatChangedMeanwhileIsNotOverwrittenUnlessConfirmed) {
  cepra::Table table = store.cepra();
  for (cepra::Row& each : table.rows) {
    if (each.key == proposal("P1").row) each.occurrence = {.value = 3, .rationale = "counted", .expert = "carl"};
  }
  store.saveCepra(table, kEve);
  EXPECT_THAT(test_support::thrownMessage([&] { accept(store, "P1", Changed::Refuse, kAdam); }),
              HasSubstr("is 3 by carl now"));
  EXPECT_EQ(row("P1").occurrence.value, 3);
  EXPECT_TRUE(proposal("P1").isOpen());
  accept(store, "P1", Changed::Confirmed, kAdam);
  EXPECT_EQ(row("P1").occurrence.value, proposal("P1").occurrence);
  EXPECT_THAT(row("P1").occurrence.rationale, HasSubstr("counted"));
}

TEST_F(Decide, ADecisionIsTakenOnce) {
  accept(store, "P1", Changed::Refuse, kAdam);
  EXPECT_THAT(test_support::thrownMessage([&] { accept(store, "P1", Changed::Confirmed, kAdam); }),
              HasSubstr("was accepted by adam already"));
  EXPECT_THAT(test_support::thrownMessage([&] { dismiss(store, "P1", "no", kAdam); }), HasSubstr("already"));
}

TEST_F(Decide, AnUnknownProposalNamesTheOpenOnes) {
  EXPECT_THAT(test_support::thrownMessage([&] { accept(store, "P9", Changed::Refuse, kAdam); }),
              HasSubstr("Open are P1, P2, P3, P4."));
}

TEST_F(Decide, AnAcceptedTestIsAddedForReviewAndLinkedToItsRequirements) {
  const std::size_t tests = store.all<specs::AcceptanceTest>().size();
  const specs::Proposal proposed = proposal("P4");
  ASSERT_TRUE(proposed.test);
  accept(store, "P4", Changed::Refuse, kAdam);
  ASSERT_EQ(store.all<specs::AcceptanceTest>().size(), tests + 1);
  for (const specs::AcceptanceTest& test : store.all<specs::AcceptanceTest>()) {
    if (test.expression != proposed.test->expression || test.title != proposed.test->title) continue;
    EXPECT_EQ(test.status, specs::Status::UnderReview);
    EXPECT_EQ(test.author, "adam");
    for (const auto& origin : store.originsOf(test.id))
      EXPECT_THAT(proposed.requirements, ::testing::Contains(origin.id));
    EXPECT_EQ(store.originsOf(test.id).size(), proposed.requirements.size());
    return;
  }
  FAIL() << "the test is not there";
}

// An accepted test breaks no rule: it has requirement, experiment data and reference data.
TEST_F(Decide, TheSpecificationKeepsItsRulesWithAnAcceptedTest) {
  const auto before = specs::checkSpecification(store.specification());
  accept(store, "P4", Changed::Refuse, kAdam);
  EXPECT_EQ(specs::checkSpecification(store.specification()), before);
}

TEST_F(Decide, AFailedActionLeavesEverythingAsItWas) {
  const auto before = store.specification();
  EXPECT_THROW(store.inOneAction([&] {
    accept(store, "P1", Changed::Refuse, kAdam);
    accept(store, "P9", Changed::Refuse, kAdam);
  }),
               core::InputError);
  EXPECT_EQ(store.cepra(), before.cepra);
  EXPECT_EQ(store.proposals(), before.proposals);
}

TEST_F(Decide, ProposalsOutliveTheFileBeingClosed) {
  const auto before = store.proposals();
  EXPECT_EQ(project.open().proposals(), before);
}

}  // namespace
}  // namespace proposals
