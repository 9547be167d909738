#include "cepra/table.h"

#include <gmock/gmock.h>
#include <limits>
#include <map>
#include <set>

#include "percollect/read_graph.h"
#include "tests/percollect/small_graph.h"
#include "tests/support/paths.h"

using cepra::buildTable;
using cepra::countRows;
using cepra::Row;
using cepra::Table;
using percollect::NodeKind;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

namespace {

std::vector<std::string> pathOf(const Row& row) {
  std::vector<std::string> titles;
  for (const auto& effect : row.effects) titles.push_back(effect.title);
  return titles;
}

std::vector<std::string> titlesOf(const std::vector<cepra::Cause>& causes) {
  std::vector<std::string> titles;
  for (const auto& cause : causes) titles.push_back(cause.title);
  return titles;
}

Table tableOf(const std::filesystem::path& shared, const std::string& release) {
  return buildTable(percollect::readGraph(shared / "data/percollect" / release).graph);
}

/// The row of a table with this path; an empty row if there is none.
Row rowWithPath(const Table& table, const std::vector<std::string>& path) {
  for (const Row& row : table.rows) {
    if (pathOf(row) == path) return row;
  }
  ADD_FAILURE() << "no such row";
  return {};
}

}  // namespace

// p has a cause of its own and an effect below it: a row each. b has neither: a row without causes.
TEST(BuildTable, MakesARowWhereverAnEffectHasACauseOrNoFurtherEffect) {
  const auto graph = test_support::smallGraph({"e:p", "e:a", "e:b", "d:x", "s:y"},
                                              {{"p", "x"}, {"p", "a"}, {"a", "y"}, {"a", "x"}, {"p", "b"}});
  const Table table = buildTable(graph);
  ASSERT_EQ(table.rows.size(), 3u);
  EXPECT_THAT(pathOf(table.rows[0]), ElementsAre("p"));
  EXPECT_THAT(pathOf(table.rows[1]), ElementsAre("p", "a"));
  EXPECT_THAT(titlesOf(table.rows[1].causesOfKind(NodeKind::DesignParameter)), ElementsAre("x"));
  EXPECT_THAT(titlesOf(table.rows[1].causesOfKind(NodeKind::SystemIndependent)), ElementsAre("y"));
  EXPECT_THAT(pathOf(table.rows[2]), ElementsAre("p", "b"));
  EXPECT_THAT(table.rows[2].causes, IsEmpty());
  EXPECT_EQ(countRows(graph), 3u);
}

// A path goes over effects only: what lies below a cause belongs to no row.
TEST(BuildTable, DoesNotWalkThroughCauses) {
  const auto graph = test_support::smallGraph({"e:p", "s:x", "e:hidden"}, {{"p", "x"}, {"x", "hidden"}});
  EXPECT_EQ(buildTable(graph).rows.size(), 1u);
}

TEST(BuildTable, CountsRowsWithoutBuildingThemAndWithoutOverflow) {
  std::vector<std::string> nodes{"e:0"};
  std::vector<std::pair<std::string, std::string>> edges;
  for (int i = 1; i <= 70; ++i) {
    const std::string from = std::to_string(i - 1), to = std::to_string(i);
    nodes.insert(nodes.end(), {"e:l" + to, "e:r" + to, "e:" + to});
    edges.insert(edges.end(), {{from, "l" + to}, {from, "r" + to}, {"l" + to, to}, {"r" + to, to}});
  }
  EXPECT_EQ(countRows(test_support::smallGraph(nodes, edges)), std::numeric_limits<std::size_t>::max());
}

TEST(BuildTable, PublishedReleasesHaveTheDocumentedRows) {
  FIDELIS_NEEDS_SHARED(shared);
  const std::map<std::string, std::size_t> documented{{"lidarlimbs-2021-xml", 3925},
                                                      {"json/lidarlimbs-2021-12-17.json", 3925},
                                                      {"json/lidarlimbs-2022-10-14.json", 4149},
                                                      {"json/lidarlimbs-2025.json", 88},
                                                      {"radarrami-2021-xml", 21},
                                                      {"json/radarrami-2025.json", 66},
                                                      {"json/cameracopse.json", 13},
                                                      {"json/ultrasonicunderwood.json", 19}};
  for (const auto& [release, rows] : documented) {
    const auto graph = percollect::readGraph(shared / "data/percollect" / release).graph;
    const Table table = buildTable(graph);
    EXPECT_EQ(table.rows.size(), rows) << release;
    EXPECT_EQ(countRows(graph), rows) << release;
    std::set<std::string> keys;
    for (const Row& row : table.rows) keys.insert(row.key);
    EXPECT_EQ(keys.size(), rows) << release;
  }
}

TEST(BuildTable, OldLidarReleaseHasTheDocumentedRowsPerPhenomenon) {
  FIDELIS_NEEDS_SHARED(shared);
  std::map<std::string, std::size_t> rows;
  for (const Row& row : tableOf(shared, "lidarlimbs-2021-xml").rows) ++rows[row.phenomenon().id];
  EXPECT_THAT(rows, UnorderedElementsAre(testing::Pair(testing::_, 1714), testing::Pair(testing::_, 1470),
                                         testing::Pair(testing::_, 741)));
}

// The three example rows of Rosenberger 2022, Tab. 7-1.
TEST(BuildTable, OldRadarReleaseGivesTheDissertationsExampleRows) {
  FIDELIS_NEEDS_SHARED(shared);
  const Table table = tableOf(shared, "radarrami-2021-xml");
  const auto path = [](std::vector<std::string> end) {
    std::vector<std::string> all{
        "Object existence error",   "False negative in object list",        "False negative feature",
        "False negative detection", "Not distinguishable from noise floor", "Low received power from object"};
    all.insert(all.end(), end.begin(), end.end());
    return all;
  };
  const std::vector<std::string> reflection{"Material properties of object parts", "Object part surface roughness",
                                            "Object part surface texture", "Size of object parts",
                                            "Pose of object parts"};
  for (const auto& end : std::vector<std::vector<std::string>>{
           {"Occlusion by objects", "Occlusion by object parts", "Specular/diffuse reflection by object parts"},
           {"Specular/diffuse reflection by object parts"}}) {
    const Row row = rowWithPath(table, path(end));
    EXPECT_THAT(titlesOf(row.causesOfKind(NodeKind::SystemIndependent)),
                testing::UnorderedElementsAreArray(reflection));
    EXPECT_THAT(titlesOf(row.causesOfKind(NodeKind::DesignParameter)), ElementsAre("Emitter wavelength"));
  }
  const Row absorption = rowWithPath(table, path({"Attenuation by atm. aerosol particles and accumulated hydrometeors",
                                                  "Absorption by atm. particles"}));
  EXPECT_THAT(titlesOf(absorption.causesOfKind(NodeKind::SystemIndependent)),
              UnorderedElementsAre("Signal distance in atm. particle volume", "Number concentration of atm. particles",
                                   "Refractive index of atm. particles", "Size of atm. particles"));
  EXPECT_THAT(titlesOf(absorption.causesOfKind(NodeKind::DesignParameter)), ElementsAre("Emitter wavelength"));
}

// printf 'tree\0a\0b' | sha256sum
TEST(RowKey, IsAPublicFunctionOfTreeAndIds) {
  EXPECT_EQ(cepra::rowKey("tree", std::vector<std::string>{"a", "b"}), "r13d1acc5b8f9");
}

TEST(RowKey, DependsOnTreeIdsAndTheirLimits) {
  const auto key = [](const std::string& tree, const std::vector<std::string>& ids) {
    return cepra::rowKey(tree, ids);
  };
  const std::set<std::string> keys{key("t", {"a", "b"}), key("u", {"a", "b"}), key("t", {"b", "a"}),
                                   key("t", {"ab"}),     key("t", {"a"}),      key("ta", {"b"})};
  EXPECT_EQ(keys.size(), 6u);
}

TEST(Relevance, IsOccurrencePlusImpactIfBothAreThere) {
  Row row;
  EXPECT_EQ(row.relevance(), std::nullopt);
  row.occurrence.value = 7;
  EXPECT_EQ(row.relevance(), std::nullopt);
  row.impact.value = 9;
  EXPECT_EQ(row.relevance(), 16);
}
