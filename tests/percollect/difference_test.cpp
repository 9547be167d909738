#include "percollect/difference.h"

#include <gmock/gmock.h>
#include <map>

#include "percollect/read_graph.h"
#include "tests/percollect/small_graph.h"
#include "tests/support/paths.h"

using percollect::ChangeKind;
using percollect::Difference;
using percollect::difference;
using percollect::Graph;
using percollect::GraphData;
using testing::ElementsAre;

namespace {

GraphData base() {
  GraphData data = test_support::smallGraphData({"e:1", "e:2", "s:3", "d:4"}, {{"1", "2"}, {"2", "3"}, {"2", "4"}});
  const std::vector<std::string> titles{"Missed detection", "Low received power", "Fog density", "Aperture diameter"};
  for (std::size_t i = 0; i < titles.size(); ++i) data.nodes[i].title = titles[i];
  return data;
}

std::vector<std::string> changesAfter(const std::function<void(GraphData&)>& edit) {
  GraphData data = base();
  edit(data);
  std::vector<std::string> list;
  for (const auto& change : difference(Graph(base()), Graph(data)).changes) {
    list.push_back(std::string(toString(change.kind)) + " " + change.old_id + ">" + change.new_id);
  }
  return list;
}

}  // namespace

TEST(Difference, OfEqualGraphsIsEmpty) {
  EXPECT_THAT(changesAfter([](GraphData&) {}), ElementsAre());
}

TEST(Difference, NamesEachKindOfChangeOnce) {
  EXPECT_THAT(changesAfter([](GraphData& d) { d.nodes[2].title = "Fog density of the air"; }),
              ElementsAre("renamed 3>3"));
  EXPECT_THAT(changesAfter([](GraphData& d) { d.nodes[2].id = "30"; }), ElementsAre("renumbered 3>30"));
  EXPECT_THAT(changesAfter([](GraphData& d) { d.edges[1].parent = 0; }), ElementsAre("re-parented 3>3"));
  EXPECT_THAT(changesAfter([](GraphData& d) { d.nodes[2].description = "x"; }), ElementsAre("description changed 3>3"));
  EXPECT_THAT(changesAfter([](GraphData& d) { d.nodes[2].block = "x"; }), ElementsAre("block changed 3>3"));
  EXPECT_THAT(changesAfter([](GraphData& d) { d.nodes[3].kind = percollect::NodeKind::SystemIndependent; }),
              ElementsAre("kind changed 4>4"));
  EXPECT_THAT(changesAfter([](GraphData& d) { d.nodes[3].references = {{.parent = "2", .url = "http://a"}}; }),
              ElementsAre("references changed 4>4"));
  EXPECT_THAT(changesAfter([](GraphData& d) { d.nodes[3].tags = {"x"}; }), ElementsAre("tags changed 4>4"));
  EXPECT_THAT(changesAfter([](GraphData& d) { d.nodes[3].labels["x"] = "y"; }), ElementsAre("labels changed 4>4"));
  EXPECT_THAT(changesAfter([](GraphData& d) {
                d.nodes.pop_back();
                d.edges.pop_back();
              }),
              ElementsAre("removed 4>"));
}

TEST(Difference, AnIdThatMeansSomethingElseIsOneRemovedAndOneAdded) {
  EXPECT_THAT(changesAfter([](GraphData& d) { d.nodes[2].title = "Emitter wavelength"; }),
              ElementsAre("removed 3>", "added >3"));
}

TEST(Difference, SwappedIdsAreTwoRenumberedNodes) {
  EXPECT_THAT(changesAfter([](GraphData& d) { std::swap(d.nodes[2].id, d.nodes[3].id); }),
              ElementsAre("renumbered 3>4", "renumbered 4>3"));
}

// Upstream states what its move from XML to JSON did: all ids new, titles 1:1, two nodes without effects (em5, re4)
// dropped, sp53 attached to sp45.
TEST(Difference, TellsTheStoryOfTheMoveFromXmlToJson) {
  FIDELIS_NEEDS_SHARED(shared);
  const auto folder = shared / "data/percollect";
  const Graph before = percollect::readGraph(folder / "lidarlimbs-2021-xml").graph;
  const Graph after = percollect::readGraph(folder / "json/lidarlimbs-2021-12-17.json").graph;
  const Difference changes = difference(before, after);
  std::map<ChangeKind, std::vector<std::string>> ids;
  for (const auto& change : changes.changes) ids[change.kind].push_back(change.old_id);
  EXPECT_EQ(ids[ChangeKind::Renumbered].size(), 138u);
  EXPECT_THAT(ids[ChangeKind::Removed], ElementsAre("em5", "re4"));
  EXPECT_THAT(ids[ChangeKind::Reparented], ElementsAre("sp53"));
  EXPECT_TRUE(ids[ChangeKind::Added].empty());
  EXPECT_TRUE(ids[ChangeKind::Renamed].empty());
}
