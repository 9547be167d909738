#include "percollect/references.h"

#include <gmock/gmock.h>

#include "tests/percollect/small_graph.h"

using percollect::parseReferences;
using percollect::Reference;
using testing::HasSubstr;

namespace {

Reference only(const std::string& text) {
  const auto references = parseReferences(text);
  EXPECT_EQ(references.size(), 1u) << text;
  return references.empty() ? Reference{} : references.front();
}

Reference withoutRaw(Reference reference) {
  reference.raw.clear();
  return reference;
}

}  // namespace

TEST(References, OfTheXmlReleaseHaveNoAuthor) {
  EXPECT_EQ(withoutRaw(only("[sp8, https://a.org/x]")), (Reference{.parent = "sp8", .url = "https://a.org/x"}));
  EXPECT_EQ(withoutRaw(only("[sp8, http://a.org/x, see p. 3, and p. 4]")),
            (Reference{.parent = "sp8", .url = "http://a.org/x", .note = "see p. 3, and p. 4"}));
}

TEST(References, OfTheJsonReleaseMayHaveCommasInTitleAndNote) {
  EXPECT_EQ(withoutRaw(only("[12, Holder et al., Radar, lidar, and more, https://a.org/x,p. 1, p. 2]")),
            (Reference{.parent = "12",
                       .author = "Holder et al.",
                       .title = "Radar, lidar, and more",
                       .url = "https://a.org/x",
                       .note = "p. 1, p. 2"}));
}

TEST(References, AreSeparatedByAnythingOrNothing) {
  EXPECT_EQ(parseReferences("[1, http://a]\n      [1, http://b][2, http://c]").size(), 3u);
  EXPECT_EQ(parseReferences("").size(), 0u);
  EXPECT_EQ(parseReferences("[]").size(), 0u);
}

TEST(References, SurviveAMissingLastBracket) { EXPECT_EQ(only("[1, A, T, http://a, note").note, "note"); }

TEST(References, WithoutAddressKeepEverything) {
  EXPECT_EQ(withoutRaw(only("[1, A, T, more]")), (Reference{.parent = "1", .author = "A", .title = "T, more"}));
}

TEST(References, ThatFitNoEdgeAreNoted) {
  auto data = test_support::smallGraphData({"e:a", "e:b", "d:c"}, {{"a", "b"}, {"b", "c"}});
  data.nodes[2].references_text = "loose [a, http://a][z, http://z";
  data.nodes[2].references = parseReferences(data.nodes[2].references_text);
  std::string all;
  for (const auto& finding : percollect::checkReferences(percollect::Graph(data))) all += toString(finding) + "\n";
  EXPECT_THAT(all, HasSubstr("node c: note: a reference names a ('a'), which is no direct effect"));
  EXPECT_THAT(all, HasSubstr("node c: note: a reference names 'z', which is no node"));
  EXPECT_THAT(all, HasSubstr("node c: note: the edge to its effect b has no reference"));
  EXPECT_THAT(all, HasSubstr("lack their last bracket"));
  EXPECT_THAT(all, HasSubstr("text outside of brackets in the references: 'loose'"));
}
