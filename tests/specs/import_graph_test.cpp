#include "specs/import_graph.h"

#include <gmock/gmock.h>

#include "core/error.h"
#include "tests/specs/small_project.h"
#include "tests/support/paths.h"

namespace specs {
namespace {

using test_specs::kEve;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class ImportGraph : public ::testing::Test {
 protected:
  static percollect::Graph changed(const std::function<void(percollect::GraphData&)>& change) {
    percollect::GraphData data = test_specs::smallGraph().data();
    data.sha256 = "6a";
    change(data);
    return percollect::Graph(std::move(data));
  }
  test_support::TemporaryFolder folder;
  ProjectStore store = ProjectStore::create(folder / "demo.fidelis");
};

TEST_F(ImportGraph, TheFirstTimeBringsTheTable) {
  const ImportedGraph imported = importGraph(store, test_specs::smallGraph(), kEve);
  EXPECT_TRUE(imported.first);
  EXPECT_EQ(imported.rows, cepra::countRows(test_specs::smallGraph()));
  EXPECT_EQ(store.cepra(), cepra::buildTable(test_specs::smallGraph()));
}

TEST_F(ImportGraph, TheSameReleaseAgainChangesNothing) {
  test_specs::fill(store);
  const cepra::Table before = store.cepra();
  EXPECT_TRUE(importGraph(store, test_specs::smallGraph(), kEve).unchanged);
  EXPECT_EQ(store.cepra(), before);
}

TEST_F(ImportGraph, ARenamedEffectKeepsItsScoresButMakesRowAndLinkSuspect) {
  test_specs::fill(store);
  const cepra::Row scored = store.cepra().rows.back();
  const auto graph =
      changed([](percollect::GraphData& data) { data.nodes[1].title = "Attenuation by \"aerosols\"; fog"; });
  const ImportedGraph imported = importGraph(store, graph, kEve);
  EXPECT_FALSE(imported.difference.empty());
  EXPECT_THAT(imported.suspect, Contains(scored.key));
  EXPECT_THAT(imported.suspect_links, ElementsAre(Link{scored.key, "RangeError_Fog_1", true}));
  const cepra::Row after = *store.cepra().find(scored.key);
  EXPECT_EQ(after.occurrence, scored.occurrence);
  EXPECT_TRUE(after.isSuspect());
  EXPECT_THAT(store.links(), Contains(Link{scored.key, "RangeError_Fog_1", true}));
}

TEST_F(ImportGraph, ARowWithARequirementNeverVanishes) {
  test_specs::fill(store);
  const std::string key = store.cepra().rows.back().key;
  const auto graph = changed([](percollect::GraphData& data) {  // the effect becomes a cause: its path is no more
    data.nodes[1].kind = percollect::NodeKind::SystemIndependent;
  });
  importGraph(store, graph, kEve);
  ASSERT_NE(store.cepra().find(key), nullptr);
  EXPECT_TRUE(store.cepra().find(key)->gone);
  EXPECT_EQ(store.followersOf(key).front().id, "RangeError_Fog_1");
}

TEST_F(ImportGraph, AnotherTreeIsRefusedAndNothingIsTouched) {
  test_specs::fill(store);
  const auto graph = changed([](percollect::GraphData& data) { data.tree = "other"; });
  try {
    importGraph(store, graph, kEve);
    FAIL();
  } catch (const core::InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("holds the graph 'small', not 'other'"));
  }
  EXPECT_EQ(store.graphImport()->sha256, "5f");
}

}  // namespace
}  // namespace specs
