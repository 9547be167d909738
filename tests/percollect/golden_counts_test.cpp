#include <algorithm>
#include <array>
#include <cctype>
#include <gtest/gtest.h>
#include <numeric>
#include <optional>

#include "percollect/chains.h"
#include "percollect/read_graph.h"
#include "tests/support/paths.h"

using percollect::ChainEnd;
using percollect::countChains;
using percollect::countGraph;
using percollect::Graph;
using percollect::GraphCounts;
using percollect::readGraph;

namespace {

/// The counts that the published releases are documented to have: nodes and edges reachable from the phenomena, chains
/// from a phenomenon to a leaf, and the longest of them, counted in edges.
struct Golden {
  const char* release;
  const char* tree;
  std::size_t nodes, edges, phenomena;
  std::optional<std::size_t> leaves;
  std::vector<std::uint64_t> chains;  ///< per phenomenon, in descending order; or one sum
  std::size_t longest_path;
  std::array<std::size_t, 3> kinds;  ///< effects, design parameters, system-independent causes; zeros: not documented
};

const std::vector<Golden> kGolden{
    {"lidarlimbs-2021-xml", "lidarlimbs", 137, 270, 3, {}, {16868, 14498, 7409}, 16, {61, 28, 48}},
    {"json/lidarlimbs-2021-12-17.json", "lidarlimbs", 138, 271, 3, 62, {38887}, 16, {}},
    {"json/lidarlimbs-2022-10-14.json", "lidarlimbs", 137, 272, 3, 61, {44427}, 16, {}},
    {"json/lidarlimbs-2025.json", "lidarlimbs", 103, 209, 3, 49, {670, 245, 6}, 9, {40, 19, 44}},
    {"radarrami-2021-xml", "radarrami", 52, 68, 3, 22, {45, 16, 1}, 9, {28, 13, 11}},
    {"json/radarrami-2025.json", "radarrami", 105, 167, 3, 45, {130, 44, 41}, 9, {53, 26, 26}},
    {"json/cameracopse.json", "cameracopse", 42, 38, 10, 12, {21}, 4, {}},
    {"json/ultrasonicunderwood.json", "ultrasonicunderwood", 43, 45, 8, 23, {41}, 5, {}},
};

std::vector<std::uint64_t> chainsPerPhenomenon(const Graph& graph) {
  std::vector<std::uint64_t> counts;
  for (const std::size_t start : graph.phenomena()) counts.push_back(countChains(graph, {.phenomenon = start}).value);
  std::sort(counts.rbegin(), counts.rend());
  return counts;
}

std::uint64_t sumOf(const std::vector<std::uint64_t>& values) {
  return std::accumulate(values.begin(), values.end(), std::uint64_t{0});
}

std::size_t walkedChains(const Graph& graph, const percollect::ChainSelection& selection) {
  std::size_t walked = 0;
  percollect::eachChain(graph, selection, [&](std::span<const std::size_t>) {
    ++walked;
    return true;
  });
  return walked;
}

class Releases : public testing::TestWithParam<Golden> {};

}  // namespace

TEST_P(Releases, HaveTheDocumentedCounts) {
  FIDELIS_NEEDS_SHARED(shared);
  const Golden& golden = GetParam();
  const Graph graph = readGraph(shared / "data/percollect" / golden.release).graph;
  const GraphCounts counts = countGraph(graph);
  EXPECT_EQ(graph.tree(), golden.tree);
  EXPECT_EQ(counts.nodes, golden.nodes);
  EXPECT_EQ(counts.edges, golden.edges);
  EXPECT_EQ(counts.phenomena, golden.phenomena);
  EXPECT_EQ(counts.leaves, golden.leaves.value_or(counts.leaves));
  EXPECT_EQ(counts.chains.value, sumOf(golden.chains));
  EXPECT_FALSE(counts.chains.saturated);
  if (golden.chains.size() > 1) {
    EXPECT_EQ(chainsPerPhenomenon(graph), golden.chains);
  }
  EXPECT_EQ(counts.longest_path, golden.longest_path);
  if (golden.kinds[0] > 0) {
    EXPECT_EQ((std::array{counts.effects, counts.design_parameters, counts.system_independent}), golden.kinds);
  }
}

// The lazy walk and the dynamic programming are two independent ways to the same number.
TEST_P(Releases, WalkAsManyChainsAsAreCounted) {
  FIDELIS_NEEDS_SHARED(shared);
  const Graph graph = readGraph(shared / "data/percollect" / GetParam().release).graph;
  for (const ChainEnd end : {ChainEnd::Leaf, ChainEnd::AnyCause}) {
    EXPECT_EQ(walkedChains(graph, {.end = end}), countChains(graph, {.end = end}).value);
  }
}

INSTANTIATE_TEST_SUITE_P(PerCollect, Releases, testing::ValuesIn(kGolden), [](const auto& test) {
  std::string name = test.param.release;
  std::replace_if(
      name.begin(), name.end(), [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); }, '_');
  return name;
});

TEST(LatestLidarRelease, Has1401ChainsIfEveryCauseEndsOne) {
  FIDELIS_NEEDS_SHARED(shared);
  const Graph graph = readGraph(shared / "data/percollect/json/lidarlimbs-2025.json").graph;
  EXPECT_EQ(countChains(graph, {.end = ChainEnd::AnyCause}).value, 1401u);
}
