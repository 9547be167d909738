#include "percollect/graph.h"

#include <gmock/gmock.h>

#include "tests/percollect/small_graph.h"
#include "tests/support/thrown_message.h"

using percollect::Graph;
using percollect::GraphData;
using test_support::smallGraph;
using test_support::smallGraphData;
using test_support::thrownMessage;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

TEST(Graph, KeepsChildrenAndParentsInTheOrderOfTheEdges) {
  const Graph graph = smallGraph({"e:a", "e:b", "d:c"}, {{"a", "c"}, {"a", "b"}, {"b", "c"}});
  EXPECT_THAT(graph.children(0), ElementsAre(2, 1));
  EXPECT_THAT(graph.parents(2), ElementsAre(0, 1));
  EXPECT_THAT(graph.parentsFirst(), ElementsAre(0, 1, 2));
}

TEST(Graph, RefusesACycleAndListsItsNodes) {
  // "top" leads into the circle and "leaf" hangs from it; neither belongs to it.
  const auto data = smallGraphData({"e:top", "e:a", "e:b", "e:c", "d:leaf"},
                                   {{"top", "b"}, {"a", "b"}, {"b", "c"}, {"c", "a"}, {"c", "leaf"}});
  EXPECT_THAT(thrownMessage([&] { Graph graph(data); }),
              AllOf(HasSubstr("small.json:2, node a"), HasSubstr("a -> b -> c -> a"), HasSubstr("Remove one")));
}

TEST(Graph, RefusesDoubledIdsAndNamesBothNodes) {
  auto data = smallGraphData({"e:a", "e:b"}, {});
  data.nodes[1].id = "a";
  EXPECT_THAT(thrownMessage([&] { Graph graph(data); }),
              AllOf(HasSubstr("small.json:2, node a"), HasSubstr("used twice"), HasSubstr("small.json:1")));
}

TEST(Graph, RefusesEdgesToNowhereToItselfOrGivenTwice) {
  const auto withEdge = [](percollect::Edge edge) {
    GraphData data = smallGraphData({"e:a", "e:b"}, {{"a", "b"}});
    data.edges.push_back(edge);
    return thrownMessage([&] { Graph graph(data); });
  };
  EXPECT_THAT(withEdge({0, 7}), HasSubstr("does not exist"));
  EXPECT_THAT(withEdge({1, 1}), HasSubstr("own cause"));
  EXPECT_THAT(withEdge({0, 1}), HasSubstr("given twice"));
}

TEST(Graph, FindsNodesAndNamesTheNearestIdWhenItCannot) {
  const Graph graph = smallGraph({"e:noise", "d:gain"}, {{"noise", "gain"}});
  EXPECT_EQ(graph.find("gain"), 1u);
  EXPECT_EQ(graph.find("loss"), std::nullopt);
  EXPECT_EQ(graph.findTitle("noise"), 0u);
  EXPECT_THAT(thrownMessage([&] { (void)graph.indexOf("nois"); }), HasSubstr("Did you mean 'noise'?"));
}

TEST(Graph, ListsWhatNoPhenomenonReaches) {
  auto data = smallGraphData({"e:a", "d:b", "d:alone"}, {{"a", "b"}});
  EXPECT_THAT(Graph(data).orphans(), ElementsAre(2));
}
