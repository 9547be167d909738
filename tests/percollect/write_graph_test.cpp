#include "percollect/write_graph.h"

#include <gmock/gmock.h>

#include "percollect/difference.h"
#include "percollect/read_graph.h"
#include "percollect/references.h"
#include "tests/percollect/small_graph.h"
#include "tests/support/paths.h"
#include "tests/support/thrown_message.h"

using percollect::Graph;
using percollect::GraphData;
using percollect::readGraph;
using percollect::writeJsonRelease;
using percollect::writeXmlRelease;
using test_support::TemporaryFolder;
using test_support::thrownMessage;
using testing::HasSubstr;

namespace {

const std::vector<std::string> kReleases{"lidarlimbs-2021-xml",
                                         "radarrami-2021-xml",
                                         "json/lidarlimbs-2021-12-17.json",
                                         "json/lidarlimbs-2022-10-14.json",
                                         "json/lidarlimbs-2025.json",
                                         "json/radarrami-2025.json",
                                         "json/cameracopse.json",
                                         "json/ultrasonicunderwood.json"};

Graph throughJson(const Graph& graph) {
  const TemporaryFolder folder;
  writeJsonRelease(graph, folder / "graph.json");
  return readGraph(folder / "graph.json", {.tree = graph.tree()}).graph;
}

Graph throughXml(const Graph& graph) {
  const TemporaryFolder folder;
  writeXmlRelease(graph, folder / "data");
  return readGraph(folder / "data", {.tree = graph.tree()}).graph;
}

/// A graph with everything that could get lost on the way.
Graph awkwardGraph() {
  GraphData data = test_support::smallGraphData({"e:1", "e:2", "s:3", "d:4", "d:5"},
                                                {{"1", "2"}, {"1", "4"}, {"2", "3"}, {"3", "4"}});
  data.nodes[0].title = "<\"Quotes\" & 'apostrophes'> \xc3\xbc \xce\xbb \xe2\x80\x9c";
  data.nodes[1].description = "two\nlines,\ttab, \\n, \r\n and a blank at the end ";
  data.nodes[1].references_text = "[1, http://a.org/?x=1&y=2, note]\n       [1, http://b.org]";
  data.nodes[1].references = percollect::parseReferences(data.nodes[1].references_text);
  data.nodes[2].tags = {"one, two", "\"three\"", ""};
  data.nodes[2].labels = {{"FMCWspecific", "true"}, {"two words", "x"}, {"id", "taken"},    {"adBlock", "taken"},
                          {"tags", "taken"},        {"xmlish", "y"},    {"labels", "taken"}};
  data.nodes[3].extra = {{"weight", "0.5"}, {"list", "[1,{\"a\":null}]"}, {"parentIds", "7"}};
  data.nodes[4].placement_parent = "2";  // an orphan
  return Graph(std::move(data));
}

}  // namespace

TEST(WriteGraph, PublishedReleasesComeBackEqualFromJson) {
  FIDELIS_NEEDS_SHARED(shared);
  for (const std::string& release : kReleases) {
    const Graph graph = readGraph(shared / "data/percollect" / release).graph;
    const Graph back = throughJson(graph);
    EXPECT_TRUE(difference(graph, back).empty()) << release;
    EXPECT_EQ(back.orphans(), graph.orphans()) << release;
    if (release.ends_with(".json")) {
      EXPECT_TRUE(sameContent(graph, back)) << release;
    }
  }
}

TEST(WriteGraph, PublishedReleasesComeBackEqualFromXml) {
  FIDELIS_NEEDS_SHARED(shared);
  for (const std::string& release : kReleases) {
    const Graph graph = readGraph(shared / "data/percollect" / release).graph;
    const Graph back = throughXml(graph);
    EXPECT_TRUE(difference(graph, back).empty()) << release;
    EXPECT_TRUE(sameContent(graph, back)) << release;  // all published ids are in natural order
  }
}

TEST(WriteGraph, NothingAwkwardIsLostInEitherFormat) {
  const Graph graph = awkwardGraph();
  EXPECT_TRUE(sameContent(graph, throughJson(graph)));
  EXPECT_TRUE(sameContent(graph, throughXml(graph)));
  EXPECT_TRUE(sameContent(graph, throughJson(throughXml(throughJson(graph)))));
}

TEST(WriteGraph, SameGraphGivesSameBytes) {
  const TemporaryFolder folder;
  writeJsonRelease(awkwardGraph(), folder / "a.json");
  writeJsonRelease(throughJson(awkwardGraph()), folder / "b.json");
  const auto hashOf = [&](const std::string& name) { return readGraph(folder / name).graph.data().sha256; };
  EXPECT_EQ(hashOf("a.json"), hashOf("b.json"));
}

TEST(WriteGraph, AnEditedGraphIsWrittenOverItsOldFiles) {
  const TemporaryFolder folder;
  writeXmlRelease(awkwardGraph(), folder.path());
  GraphData data = awkwardGraph().data();
  data.nodes[0].title = "Edited";
  writeXmlRelease(Graph(data), folder.path());
  EXPECT_EQ(readGraph(folder.path()).graph.node(0).title, "Edited");
}

TEST(WriteGraph, RefusesWhatXmlCannotHoldBeforeItTouchesAFile) {
  const TemporaryFolder folder;
  const auto errorFor = [&](auto edit) {
    GraphData data = awkwardGraph().data();
    edit(data);
    return thrownMessage([&] { writeXmlRelease(Graph(data), folder / "out"); });
  };
  EXPECT_THAT(errorFor([](GraphData& data) { data.nodes[4].title = "bell \a"; }), HasSubstr("control character 7"));
  EXPECT_THAT(errorFor([](GraphData& data) { data.nodes[4].id = "../5"; }), HasSubstr("cannot be the name"));
  EXPECT_THAT(errorFor([](GraphData& data) { data.nodes[4].id = "root"; }), HasSubstr("cannot be the name"));
  EXPECT_FALSE(std::filesystem::exists(folder / "out"));
}

TEST(WriteGraph, RefusesAFolderWithOtherNodeFiles) {
  const TemporaryFolder folder;
  folder.write("old_node.xml", "<basic_node/>");
  EXPECT_THAT(thrownMessage([&] { writeXmlRelease(awkwardGraph(), folder.path()); }),
              HasSubstr("old_node.xml: is no node of this graph"));
  EXPECT_FALSE(std::filesystem::exists(folder / "root_node.xml"));
}
