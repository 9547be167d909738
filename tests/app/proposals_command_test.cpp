#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "core/json_object.h"
#include "tests/proposals/demo_project.h"
#include "tests/support/program.h"

namespace {

using nlohmann::json;
using test_support::runFidelis;
using ::testing::HasSubstr;

/// From the diagnosis to an accepted row, with the program alone.
class ProposalsCommand : public ::testing::Test {
 protected:
  ProposalsCommand() {
    const auto run = runFidelis({"gap", demo.folder() / "foggy-sweep", "--model", demo.folder() / "model.json",
                                 "--project", project, "--json", report, "--write-model", better});
    EXPECT_EQ(run.status, 0) << run.messages;
    gap_text = run.out;
  }
  test_support::ProgramRun cepra(std::vector<std::string> words) const {
    words.insert(words.begin(), "cepra");
    words.insert(words.end(), {"--project", project});
    return runFidelis(words);
  }

  test_proposals::DemoProject demo;
  std::string project = demo.file();
  std::string report = demo.folder() / "gap.json";
  std::string better = demo.folder() / "better.json";
  std::string gap_text;
};

// What the flips say is what 'fidelis accept' finds with each of the two models.
TEST_F(ProposalsCommand, TheFlipsOfTheReportAreThoseOfTwoAcceptanceRuns) {
  const auto verdicts = [&](const std::string& model) {
    std::map<std::string, std::string> found;
    const auto run = runFidelis({"accept", project, "--model", model, "--json", "-"});
    const json result = json::parse(run.out);
    for (const json& test : result.at("tests")) found[test.at("id")] = test.at("verdict");
    return found;
  };
  const auto before = verdicts(demo.folder() / "model.json");
  const auto after = verdicts(better);
  std::set<std::string> expected, listed;
  for (const auto& [id, verdict] : before) {
    if (after.at(id) != verdict && id.find("Fog") != std::string::npos) expected.insert(id);
  }
  const json made = core::readJson(report);
  for (const json& flip : made.at("acceptance_flips")) {
    listed.insert(flip.at("test"));
    EXPECT_EQ(flip.at("before"), before.at(flip.at("test")));
    EXPECT_EQ(flip.at("after"), after.at(flip.at("test")));
  }
  EXPECT_EQ(listed, expected);
  EXPECT_FALSE(expected.empty());
  EXPECT_THAT(gap_text, HasSubstr("EchoPulseWidthError_Fog_2: failed -> passed"));
}

TEST_F(ProposalsCommand, ARowIsProposedListedAccepted) {
  const auto proposed = cepra({"propose", report, "--author", "adam", "--json", "-"});
  ASSERT_EQ(proposed.status, 0) << proposed.messages;
  const json list = json::parse(proposed.out).at("proposals");
  ASSERT_EQ(list.size(), 4u);
  EXPECT_EQ(list[0].at("state"), "open");
  EXPECT_EQ(list[0].at("proposed").at("who"), "adam");
  EXPECT_EQ(list[3].at("kind"), "acceptance test");
  EXPECT_THAT(cepra({"proposals"}).out, HasSubstr("P1    open"));

  const auto accepted = cepra({"accept", "P1", "--author", "eve"});
  ASSERT_EQ(accepted.status, 0) << accepted.messages;
  EXPECT_THAT(accepted.out, HasSubstr("P1 accepted: occurrence of"));
  const auto store = specs::ProjectStore::open(project);
  const auto row = store.cepra().find(list[0].at("row").get<std::string>())->occurrence;
  EXPECT_EQ(row.value, list[0].at("occurrence").get<int>());
  EXPECT_EQ(row.expert, "eve");
  EXPECT_THAT(cepra({"proposals", "--state", "accepted"}).out, HasSubstr("accepted by eve"));
}

TEST_F(ProposalsCommand, ProposingAgainSaysThatItIsKnown) {
  ASSERT_EQ(cepra({"propose", report}).status, 0);
  const auto again = cepra({"propose", report});
  EXPECT_EQ(again.status, 0);
  EXPECT_THAT(again.messages, HasSubstr("0 proposed, 4 known from this report already"));
}

TEST_F(ProposalsCommand, DismissalNeedsItsReason) {
  ASSERT_EQ(cepra({"propose", report}).status, 0);
  EXPECT_EQ(cepra({"dismiss", "P1"}).status, 2);
  EXPECT_EQ(cepra({"dismiss", "P1", "--because", " "}).status, 2);
  const auto done = cepra({"dismiss", "P1", "P2", "--because", "denser than any fog here"});
  EXPECT_EQ(done.status, 0) << done.messages;
  EXPECT_THAT(cepra({"proposals", "--state", "dismissed"}).out, HasSubstr("denser than any fog here"));
}

TEST_F(ProposalsCommand, MistakesAreNamed) {
  EXPECT_THAT(cepra({"accept", "P1"}).messages, HasSubstr("'fidelis cepra propose REPORT'"));
  const auto no_report = cepra({"propose", demo.folder() / "model.json"});
  EXPECT_EQ(no_report.status, 2);
  EXPECT_THAT(no_report.messages, HasSubstr("fidelis-gap"));
  EXPECT_THAT(cepra({"proposals"}).messages, HasSubstr("no proposals"));
}

}  // namespace
