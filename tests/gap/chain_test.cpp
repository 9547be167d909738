#include "gap/chain.h"

#include <gtest/gtest.h>

#include "percollect/read_graph.h"
#include "tests/support/paths.h"

namespace {

// fog -> attenuation (bound to the effect) -> low power -> missed detection; and a longer way through noise.
const char* const kGraph = R"([
  {"id":"0","parentIds":[],"title":"Missed detection","decomBlock":"Detection identification","description":"","references":"","nodeType":"effect","tags":[]},
  {"id":"1","parentIds":["0"],"title":"Low power","decomBlock":"Reception","description":"","references":"","nodeType":"effect","tags":[]},
  {"id":"2","parentIds":["1","3"],"title":"Attenuation","decomBlock":"Signal propagation","description":"","references":"","nodeType":"effect","tags":["fidelis-effect:atmospheric-attenuation"]},
  {"id":"3","parentIds":["1"],"title":"Detour","decomBlock":"Reception","description":"","references":"","nodeType":"effect","tags":[]},
  {"id":"4","parentIds":["2"],"title":"Fog","decomBlock":"Signal propagation","description":"","references":"","nodeType":"systemIndependent","tags":[]}
])";

TEST(CauseChain, LeadsTheShortestWayFromTheBoundNodeToThePhenomenon) {
  const test_support::TemporaryFolder folder;
  const auto graph = percollect::readGraph(folder.write("own.json", kGraph)).graph;
  const gap::CauseChain chain = gap::chainOf(graph, "atmospheric-attenuation", {});
  EXPECT_EQ(chain.ids, (std::vector<std::string>{"2", "1", "0"}));
  EXPECT_EQ(chain.titles.back(), "Missed detection");
}

// Ids mean something in their own tree only: 4 of this graph is not 4 of LidarLimbs.
TEST(CauseChain, IdsOfTheLibraryAreNotLookedUpInForeignTrees) {
  const test_support::TemporaryFolder folder;
  const auto graph = percollect::readGraph(folder.write("own.json", kGraph)).graph;
  EXPECT_TRUE(gap::chainOf(graph, "range-walk", {"4"}).ids.empty());
}

TEST(CauseChain, LidarLimbsIdsLeadToItsPhenomenon) {
  FIDELIS_NEEDS_SHARED(shared);
  const auto graph = percollect::readGraph(shared / "data/percollect/json/lidarlimbs-2025.json").graph;
  const gap::CauseChain chain = gap::chainOf(graph, "atmospheric-attenuation", {"87", "92"});
  EXPECT_EQ(chain.ids, (std::vector<std::string>{"87", "54", "39", "0"}));
}

}  // namespace
