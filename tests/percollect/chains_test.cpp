#include "percollect/chains.h"

#include <gmock/gmock.h>
#include <limits>

#include "tests/percollect/small_graph.h"

using percollect::ChainEnd;
using percollect::ChainSelection;
using percollect::countChains;
using percollect::Graph;
using test_support::smallGraph;
using testing::ElementsAre;

namespace {

std::vector<std::string> chainsOf(const Graph& graph, const ChainSelection& selection = {}, std::uint64_t skip = 0,
                                  std::size_t at_most = 1000) {
  std::vector<std::string> chains;
  percollect::eachChain(
      graph, selection,
      [&](std::span<const std::size_t> chain) {
        std::string text;
        for (const std::size_t i : chain) text += graph.node(i).id;
        chains.push_back(text);
        return chains.size() < at_most;
      },
      skip);
  return chains;
}

/// Two phenomena, a node with two parents, and a cause with a cause of its own.
///
///   p ─► a ─► c ─► x          d is a design parameter below the system-independent cause x
///   p ─► b ─► c    x ─► d     q ─► b
Graph diamond() {
  return smallGraph({"e:p", "e:q", "e:a", "e:b", "e:c", "s:x", "d:d"},
                    {{"p", "a"}, {"p", "b"}, {"a", "c"}, {"b", "c"}, {"c", "x"}, {"x", "d"}, {"q", "b"}});
}

/// A ladder in which every step doubles the number of chains: 2^steps.
Graph ladder(std::size_t steps) {
  std::vector<std::string> nodes{"e:0"};
  std::vector<std::pair<std::string, std::string>> edges;
  for (std::size_t i = 1; i <= steps; ++i) {
    const std::string from = std::to_string(i - 1), to = std::to_string(i);
    nodes.insert(nodes.end(), {"e:l" + to, "e:r" + to, "e:" + to});
    edges.insert(edges.end(), {{from, "l" + to}, {from, "r" + to}, {"l" + to, to}, {"r" + to, to}});
  }
  return smallGraph(nodes, edges);
}

}  // namespace

TEST(Chains, RunFromPhenomenaToLeavesInOrder) {
  EXPECT_THAT(chainsOf(diamond()), ElementsAre("pacxd", "pbcxd", "qbcxd"));
  EXPECT_EQ(countChains(diamond()).value, 3u);
}

TEST(Chains, EndAtEveryCauseIfAsked) {
  const ChainSelection selection{.end = ChainEnd::AnyCause};
  EXPECT_THAT(chainsOf(diamond(), selection), ElementsAre("pacx", "pacxd", "pbcx", "pbcxd", "qbcx", "qbcxd"));
  EXPECT_EQ(countChains(diamond(), selection).value, 6u);
}

TEST(Chains, CanBeRestrictedToAPhenomenonAndToANodeOnTheWay) {
  const Graph graph = diamond();
  EXPECT_THAT(chainsOf(graph, {.phenomenon = graph.find("p")}), ElementsAre("pacxd", "pbcxd"));
  EXPECT_THAT(chainsOf(graph, {.through = graph.find("b")}), ElementsAre("pbcxd", "qbcxd"));
  EXPECT_EQ(countChains(graph, {.phenomenon = graph.find("p"), .through = graph.find("b")}).value, 1u);
  EXPECT_THAT(chainsOf(graph, {.end = ChainEnd::AnyCause, .through = graph.find("d")}),
              ElementsAre("pacxd", "pbcxd", "qbcxd"));
}

TEST(Chains, SkippedOnesAreExactlyTheFirst) {
  for (const ChainEnd end : {ChainEnd::Leaf, ChainEnd::AnyCause}) {
    const auto all = chainsOf(diamond(), {.end = end});
    for (std::size_t skip = 0; skip <= all.size() + 1; ++skip) {
      const auto begin = all.begin() + static_cast<std::ptrdiff_t>(std::min(skip, all.size()));
      EXPECT_EQ(chainsOf(diamond(), {.end = end}, skip), std::vector<std::string>(begin, all.end())) << skip;
    }
  }
}

TEST(Chains, VisitorStopsTheWalk) { EXPECT_THAT(chainsOf(diamond(), {}, 1, 1), ElementsAre("pbcxd")); }

// 2^63 still fits, 2^64 is one more than the largest number.
TEST(Chains, CountsDoNotOverflow) {
  EXPECT_EQ(countChains(ladder(63)), (percollect::ChainCount{std::uint64_t{1} << 63, false}));
  EXPECT_EQ(countChains(ladder(64)), (percollect::ChainCount{std::numeric_limits<std::uint64_t>::max(), true}));
  EXPECT_EQ(countChains(ladder(500)), (percollect::ChainCount{std::numeric_limits<std::uint64_t>::max(), true}));
}

// One by one this would take a century: only skipping whole subtrees ends before the test's time limit.
TEST(Chains, APageInTheMiddleOfQuintillionsComesAtOnce) {
  const Graph graph = ladder(62);
  const auto last = chainsOf(graph, {}, (std::uint64_t{1} << 62) - 1);
  EXPECT_EQ(last.size(), 1u);
  EXPECT_EQ(last.front().find('l'), std::string::npos);  // the last chain always goes right
  EXPECT_EQ(chainsOf(graph, {}, std::uint64_t{1} << 61, 3).size(), 3u);
}

TEST(Chains, LongPathsDoNotExhaustTheStack) {
  std::vector<std::string> nodes;
  std::vector<std::pair<std::string, std::string>> edges;
  percollect::GraphData data;
  for (std::size_t i = 0; i < 200'000; ++i) {
    percollect::Node node;
    node.id = std::to_string(i);
    data.nodes.push_back(node);
    if (i > 0) data.edges.push_back({i - 1, i});
  }
  data.phenomena = {0};
  const Graph graph(data);
  EXPECT_EQ(countGraph(graph).longest_path, 199'999u);
  EXPECT_EQ(chainsOf(graph).size(), 1u);
}

TEST(ChainsThrough, MarksWhatLiesAboveAndBelowButNotBeside) {
  const Graph graph = diamond();
  const auto around = percollect::chainsThrough(graph, *graph.find("b"));
  EXPECT_THAT(around.effects, ElementsAre(0, 1));    // p, q
  EXPECT_THAT(around.causes, ElementsAre(4, 5, 6));  // c, x, d
  EXPECT_EQ(around.edges.size(), 5u);                // p-b, b-c, c-x, x-d, q-b; not those over a
}
