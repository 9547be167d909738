#include "specs/project_store.h"

#include <cmath>
#include <gmock/gmock.h>
#include <limits>

#include "core/error.h"
#include "specs/fields.h"
#include "tests/specs/small_project.h"
#include "tests/support/paths.h"

namespace specs {
namespace {

using test_specs::kEve;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

class AStore : public ::testing::Test {
 protected:
  AStore() { test_specs::fill(store); }
  ProjectStore again() const { return ProjectStore::open(store.file()); }

  /// What an InputError says, or "" if none is thrown.
  static std::string complaint(const std::function<void()>& work) {
    try {
      work();
    } catch (const core::InputError& error) {
      return error.what();
    }
    return "";
  }

  test_support::TemporaryFolder folder;
  ProjectStore store = ProjectStore::create(folder / "demo.fidelis");
};

TEST_F(AStore, KeepsEveryFieldOfEveryKind) {
  const auto test = again().find<AcceptanceTest>("RangeError_Fog_3").value();
  EXPECT_EQ(test.expression, "abs(d_bias) <= 0.005 * range_m");
  EXPECT_THAT(test.samples, ElementsAre("r10", "odd; sample", "validation"));
  EXPECT_EQ(test.frames, 20);
  EXPECT_EQ(test.options, (std::map<std::string, std::string>{{"rays", "3;5"}, {"note", "a=b"}}));
  EXPECT_EQ(again().find<Requirement>("RangeError_Fog_2")->text, "The bias, in m,\nis \"small\"; see <1>.");
  EXPECT_THAT(again().find<Requirement>("RangeError_Fog_1")->effects, ElementsAre("atmospheric-attenuation"));
  EXPECT_EQ(again().find<ExperimentData>("RangeError_Fog_4")->device, "Ibeo LUX 2010");
  EXPECT_EQ(again().find<ReferenceData>("RangeError_Fog_5")->uncertainty, "± 2 mm (95 %)");
  EXPECT_EQ(again().find<Requirement>("RangeError_Fog_3"), std::nullopt) << "a test is no requirement";
}

TEST_F(AStore, GivesBackTheGraphAndItsOrigin) {
  const auto graph = again().graph();
  ASSERT_TRUE(graph);
  EXPECT_TRUE(percollect::sameContent(*graph, test_specs::smallGraph()));
  EXPECT_TRUE(std::equal(graph->nodes().begin(), graph->nodes().end(), test_specs::smallGraph().nodes().begin(),
                         [](const auto& a, const auto& b) { return percollect::sameContent(a, b); }));
  EXPECT_EQ(again().graphImport()->when, kEve.when);
}

TEST_F(AStore, GivesBackTheRelevanceTable) {
  cepra::Table expected = cepra::buildTable(test_specs::smallGraph());
  expected.rows.back().occurrence = {.value = 7, .rationale = "fog is common", .expert = "eve"};
  expected.rows.back().impact = {.value = 9, .rationale = "objects are missed", .expert = "adam"};
  EXPECT_EQ(again().cepra(), expected);
  expected.rows.back().suspect = "title changed";
  expected.rows.back().gone = true;
  store.saveCepra(expected, kEve);
  EXPECT_EQ(again().cepra(), expected);
  EXPECT_EQ(store.originsOf("RangeError_Fog_1").size(), 1u) << "links survive a new table";
  EXPECT_THAT(store.history(expected.rows.back().key).back().what, HasSubstr("gone from the graph"));
}

TEST_F(AStore, DoesNotDropARowFromWhichARequirementFollows) {
  cepra::Table without = store.cepra();
  const std::string key = without.rows.back().key;
  without.rows.pop_back();
  EXPECT_THAT(complaint([&] { store.saveCepra(without, kEve); }), HasSubstr("RangeError_Fog_1 follows from it"));
  EXPECT_NE(store.cepra().find(key), nullptr);
  store.unlink(key, "RangeError_Fog_1", kEve);
  store.saveCepra(without, kEve);
  EXPECT_EQ(store.cepra(), without);
}

TEST_F(AStore, AnUndoneRemovalComesBackAsItself) {
  const auto before = store.find<AcceptanceTest>("RangeError_Fog_3").value();
  store.storeRun({.verdicts = {{.test = before.id, .verdict = Verdict::Failed}}});
  const auto links = store.links();
  store.remove(before.id, kEve);
  EXPECT_EQ(store.find<AcceptanceTest>(before.id), std::nullopt);
  EXPECT_EQ(store.links().size(), links.size() - 3);
  EXPECT_TRUE(store.latestVerdicts().empty());
  EXPECT_EQ(store.add(before, kEve), before);
  EXPECT_EQ(store.latestVerdicts().at(before.id).verdict, Verdict::Failed);
}

TEST_F(AStore, RenamingKeepsLinksAndVerdicts) {
  store.storeRun({.verdicts = {{.test = "RangeError_Fog_3", .verdict = Verdict::Passed}}});
  auto test = store.find<AcceptanceTest>("RangeError_Fog_3").value();
  test.id = "RangeError_Aerosols_1";
  test.status = Status::Rejected;
  store.update(test, {.who = "adam", .when = "later"});
  EXPECT_THAT(store.followersOf("RangeError_Fog_2"),
              ElementsAre(ItemReference{Kind::AcceptanceTest, "RangeError_Aerosols_1", "Range bias at 10 m"}));
  EXPECT_EQ(store.latestVerdicts().count("RangeError_Aerosols_1"), 1u);
  EXPECT_THAT(store.history("RangeError_Aerosols_1").back(),
              (Change{"RangeError_Aerosols_1", "adam", "later",
                      "id: RangeError_Fog_3 -> RangeError_Aerosols_1; status: accepted -> rejected"}));
}

TEST_F(AStore, RefusesIdsThatAreTakenMalformedOrUnknown) {
  Requirement requirement{{.id = "RangeError_Fog_3"}};
  EXPECT_THAT(complaint([&] { store.add(requirement, kEve); }), HasSubstr("taken already"));
  requirement.id = "fog";
  EXPECT_THAT(complaint([&] { store.add(requirement, kEve); }), HasSubstr("<Phenomenon>_<Causes>_<No.>"));
  EXPECT_THAT(complaint([&] { store.remove("RangeError_Fig_3", kEve); }),
              HasSubstr("Did you mean 'RangeError_Fog_3'?"));
  requirement.id = "RangeError_Fog_9";
  requirement.uid = "nobody";
  EXPECT_THAT(complaint([&] { store.update(requirement, kEve); }), HasSubstr("no such requirement any more"));
}

TEST_F(AStore, LinksOnlyWhatMayFollowAndNeverInACircle) {
  EXPECT_THAT(complaint([&] {
                store.link({"RangeError_Fog_3", "RangeError_Fog_1"}, kEve);
              }),
              HasSubstr("no link may lead from acceptance test to requirement"));
  EXPECT_THAT(complaint([&] { store.link({"RangeError_Fog_2", "RangeError_Fog_1"}, kEve); }), HasSubstr("circle"));
  EXPECT_THAT(complaint([&] { store.link({"RangeError_Fog_1", "RangeError_Fog_1"}, kEve); }), HasSubstr("circle"));
  EXPECT_THAT(complaint([&] { store.unlink("RangeError_Fog_1", "RangeError_Fog_3", kEve); }),
              HasSubstr("no such link"));
  store.link({"RangeError_Fog_1", "RangeError_Fog_2", true}, kEve);
  EXPECT_THAT(store.links(), ::testing::Contains(Link{"RangeError_Fog_1", "RangeError_Fog_2", true}));
}

TEST_F(AStore, KeepsRunsWithEverythingTheyRestOn) {
  TestRun run{.started_at = "2026-01-02T03:04:05Z", .program_version = "0.1.0"};
  run.verdicts.push_back({.test = "RangeError_Fog_3",
                          .verdict = Verdict::Failed,
                          .text = "d_bias is too large",
                          .samples = {{.sample = "r10",
                                       .verdict = Verdict::Failed,
                                       .values = {{"d_bias", 0.1}, {"d_cavm", std::numeric_limits<double>::infinity()}},
                                       .value = 0.1,
                                       .limit = 0.05,
                                       .text = "0.1 > 0.05"},
                                      {.sample = "r15", .verdict = Verdict::Error, .text = "no detections"}},
                          .used = {{"experiment.json", "ab"}, {"model.json", "cd"}},
                          .evaluation = "{\"a\": 1}",
                          .report = "out.html"});
  EXPECT_EQ(store.storeRun(run), "run-1");
  run.id = "run-1";
  EXPECT_EQ(again().findRun("run-1"), run);
  EXPECT_THAT(complaint([&] { store.storeRun(run); }), HasSubstr("stored already"));
  run.id = "";
  run.verdicts[0].verdict = Verdict::Passed;
  EXPECT_EQ(store.storeRun(run), "run-2");
  EXPECT_EQ(store.latestRuns(1).front().id, "run-2");
  EXPECT_EQ(store.latestRuns().size(), 2u);
  EXPECT_EQ(store.latestVerdicts().at("RangeError_Fog_3").verdict, Verdict::Passed);
}

TEST_F(AStore, NotANumberSurvives) {
  store.storeRun({.verdicts = {{.test = "RangeError_Fog_3", .samples = {{.values = {{"d", std::nan("")}}}}}}});
  EXPECT_TRUE(std::isnan(store.findRun("run-1")->verdicts[0].samples[0].values.at("d")));
}

TEST_F(AStore, AnActionIsAllOrNothing) {
  const Specification before = store.specification();
  EXPECT_NE(complaint([&] {
              store.inOneAction([&] {
                store.remove("RangeError_Fog_3", kEve);
                store.add(Requirement{{.id = "RangeError_Fog_1"}}, kEve);  // taken
              });
            }),
            "");
  EXPECT_EQ(store.specification().tests, before.tests);
  EXPECT_EQ(store.specification().links, before.links);
}

TEST_F(AStore, AFailedStepWithinAnActionUndoesOnlyItself) {
  store.inOneAction([&] {
    store.remove("RangeError_Fog_5", kEve);
    EXPECT_NE(complaint([&] {
                store.inOneAction([&] {
                  store.remove("RangeError_Fog_4", kEve);
                  store.remove("RangeError_Fog_5", kEve);
                });
              }),
              "");
  });
  EXPECT_TRUE(again().find<ExperimentData>("RangeError_Fog_4"));
  EXPECT_FALSE(again().find<ReferenceData>("RangeError_Fog_5"));
}

TEST_F(AStore, TellsThatSomebodyElseHasWritten) {
  const int version = store.dataVersion();
  ProjectStore other = again();
  EXPECT_EQ(store.dataVersion(), version);
  other.remove("RangeError_Fog_5", kEve);
  EXPECT_NE(store.dataVersion(), version);
}

TEST(ProjectStore, TheSameActionsGiveTheSameUids) {
  test_support::TemporaryFolder a;
  test_support::TemporaryFolder b;
  ProjectStore first = ProjectStore::create(a / "p.fidelis");
  ProjectStore second = ProjectStore::create(b / "p.fidelis");
  test_specs::fill(first);
  test_specs::fill(second);
  EXPECT_EQ(first.specification().tests, second.specification().tests);
  const std::string uid = first.all<AcceptanceTest>().front().uid;
  EXPECT_THAT(uid, ::testing::MatchesRegex("[0-9a-f]{8}-[0-9a-f]{4}-8[0-9a-f]{3}-a[0-9a-f]{3}-[0-9a-f]{12}"));
}

TEST(ListsInAText, RoundTripWhateverTheyHold) {
  for (const std::vector<std::string>& list : std::vector<std::vector<std::string>>{
           {}, {""}, {"a"}, {"a", "b"}, {"a; b", "c\\", ";"}, {"", ""}, {" a ", "\\.", "x\ny"}, {"a", ""}, {"\\;"}}) {
    EXPECT_EQ(splitList(joinList(list)), list) << joinList(list);
  }
  EXPECT_THAT(splitList("  a ;b;  c d ; "), ElementsAre("a", "b", "c d"));
}

}  // namespace
}  // namespace specs
