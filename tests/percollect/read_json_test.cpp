#include <gmock/gmock.h>

#include "percollect/read_graph.h"
#include "tests/support/paths.h"
#include "tests/support/thrown_message.h"

using percollect::NodeKind;
using percollect::readGraph;
using test_support::TemporaryFolder;
using test_support::thrownMessage;
using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

namespace {

std::string nodeJson(const std::string& id, const std::string& parents, const std::string& more = "") {
  return "  {\"id\": \"" + id + "\", \"parentIds\": [" + parents + "], \"title\": \"T" + id +
         "\", \"decomBlock\": \"Emission\",\n   \"description\": \"\", \"references\": \"\", \"nodeType\": \"effect\"" +
         more + "}";
}

class JsonRelease : public testing::Test {
 protected:
  std::filesystem::path write(const std::vector<std::string>& nodes) {
    std::string text = "[\n";
    for (std::size_t i = 0; i < nodes.size(); ++i) text += nodes[i] + (i + 1 < nodes.size() ? ",\n" : "\n");
    return folder_.write("tree.json", text + "]\n");
  }
  std::string error(const std::vector<std::string>& nodes) {
    const auto file = write(nodes);
    return thrownMessage([&] { (void)readGraph(file); });
  }
  std::vector<std::string> findings(const std::vector<std::string>& nodes) {
    std::vector<std::string> texts;
    for (const auto& finding : readGraph(write(nodes)).findings) texts.push_back(toString(finding));
    return texts;
  }
  TemporaryFolder folder_;
};

}  // namespace

TEST_F(JsonRelease, KnowsTheLineOfEveryNode) {
  const auto graph =
      readGraph(write({nodeJson("0", ""), nodeJson("1", "\"0\"", ", \"x\": \"[{\\\"\\n\""), nodeJson("2", "\"1\"")}))
          .graph;
  EXPECT_EQ(graph.node(0).line, 2);
  EXPECT_EQ(graph.node(1).line, 4);
  EXPECT_EQ(graph.node(2).line, 6);
}

TEST_F(JsonRelease, KeepsKeysThatItDoesNotKnow) {
  const auto graph =
      readGraph(
          write({nodeJson("0", "", ", \"FMCWspecific\": \"true\", \"weight\": 0.5, \"list\": [1, {\"a\": null}]")}))
          .graph;
  EXPECT_EQ(graph.node(0).labels.at("FMCWspecific"), "true");
  EXPECT_EQ(graph.node(0).extra.at("weight"), "0.5");
  EXPECT_EQ(graph.node(0).extra.at("list"), "[1,{\"a\":null}]");
}

TEST_F(JsonRelease, AcceptsTheWordEffectInAnyCaseWithAWarning) {
  std::string node = nodeJson("0", "");
  node.replace(node.find("\"effect\""), 8, "\"Effect\"");
  EXPECT_THAT(findings({node}), Contains(HasSubstr("tree.json:2, node 0: warning: \"nodeType\" is 'Effect'")));
  EXPECT_EQ(readGraph(write({node})).graph.node(0).kind, NodeKind::Effect);
}

TEST_F(JsonRelease, ReportsUnknownBlocksSelfParentsAndDoubledParents) {
  std::string odd = nodeJson("1", "\"0\", \"1\", \"0\"");
  odd.replace(odd.find("Emission"), 8, "PIC");
  const auto texts = findings({nodeJson("0", ""), odd});
  EXPECT_THAT(texts, Contains(HasSubstr("node 1: warning: the block 'PIC' is none")));
  EXPECT_THAT(texts, Contains(HasSubstr("node 1: warning: the node names itself as its parent")));
  EXPECT_THAT(texts, Contains(HasSubstr("node 1: warning: the parent 0 is named twice")));
}

TEST_F(JsonRelease, RefusesDanglingParentsCyclesAndDoubledIdsWithTheirPlace) {
  EXPECT_THAT(error({nodeJson("0", ""), nodeJson("1", "\"9\"")}),
              AllOf(HasSubstr("tree.json:4, node 1: its parent 9 does not exist"), HasSubstr("Correct")));
  EXPECT_THAT(error({nodeJson("0", ""), nodeJson("1", "\"0\", \"2\""), nodeJson("2", "\"1\"")}),
              AllOf(HasSubstr("tree.json:4, node 1"), HasSubstr("1 -> 2 -> 1")));
  EXPECT_THAT(error({nodeJson("0", ""), nodeJson("0", "")}), HasSubstr("tree.json:4, node 0: the id is used twice"));
}

TEST_F(JsonRelease, RefusesWhatIsNoListOfNodes) {
  EXPECT_THAT(thrownMessage([&] { (void)readGraph(folder_.write("a.json", "{\"id\": \"0\"}")); }),
              HasSubstr("a list of nodes, [ ... ], was expected"));
  EXPECT_THAT(error({nodeJson("0", ""), "7"}), HasSubstr("tree.json:4: is a number; a node"));
  EXPECT_THAT(thrownMessage([&] { (void)readGraph(folder_.write("b.json", "[]")); }), HasSubstr("has no phenomenon"));
  EXPECT_THAT(thrownMessage([&] { (void)readGraph(folder_.write("c.json", " \n")); }), HasSubstr("is empty"));
  EXPECT_THAT(thrownMessage([&] { (void)readGraph(folder_ / "nowhere.json"); }), HasSubstr("cannot be read"));
}

// Two published revisions had a raw line break inside a text.
TEST_F(JsonRelease, RefusesRawLineBreaksInTextsWithTheirLine) {
  std::string node = nodeJson("0", "");
  node.replace(node.find("\"description\": \"\""), 17, "\"description\": \"a\nb\"");
  EXPECT_THAT(error({node}), AllOf(HasSubstr("tree.json:3"), HasSubstr("not valid JSON")));
}

TEST_F(JsonRelease, RefusesMissingAndWronglyTypedKeys) {
  EXPECT_THAT(error({"{\"id\": \"0\", \"parentIds\": [], \"nodeType\": \"effect\"}"}),
              HasSubstr("\"title\" is missing"));
  EXPECT_THAT(error({"{\"title\": \"x\"}"}), HasSubstr("tree.json:2: the node has no \"id\""));
  EXPECT_THAT(error({"{\"id\": \"0\", \"title\": 3}"}), HasSubstr("node 0: \"title\" is no text"));
  EXPECT_THAT(error({"{\"id\": \"0\", \"title\": \"x\", \"nodeType\": \"effect\", \"parentIds\": \"1\"}"}),
              HasSubstr("\"parentIds\" is no list of texts"));
  EXPECT_THAT(error({"{\"id\": \"0\", \"title\": \"x\", \"nodeType\": \"cause\", \"parentIds\": []}"}),
              HasSubstr("\"nodeType\" is 'cause'; known are"));
}

TEST_F(JsonRelease, RefusesNumbersThatNoDoubleHolds) {
  EXPECT_THAT(error({nodeJson("0", "", ", \"x\": 1e999")}), HasSubstr("not valid JSON"));
}
