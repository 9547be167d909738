#include "cepra/merge.h"

#include <functional>
#include <gmock/gmock.h>

#include "cepra/check.h"
#include "percollect/read_graph.h"
#include "tests/percollect/small_graph.h"
#include "tests/support/paths.h"
#include "tests/support/thrown_message.h"

using cepra::buildTable;
using cepra::Merge;
using cepra::merge;
using cepra::Row;
using cepra::Table;
using percollect::Graph;
using percollect::GraphData;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

namespace {

/// Rows: p > a (cause x), p > b (cause y).
GraphData base() {
  return test_support::smallGraphData({"e:p", "e:a", "e:b", "d:x", "s:y"},
                                      {{"p", "a"}, {"p", "b"}, {"a", "x"}, {"b", "y"}});
}

Table scoredTable() {
  Table table = buildTable(Graph(base()));
  table.rows[0].occurrence = {3, "why a", "O"};
  table.rows[0].impact = {4, "why a", "I"};
  table.rows[1].occurrence = {5, "why b", "O"};
  return table;
}

Merge mergedAfter(const std::function<void(GraphData&)>& edit, const std::set<std::string>& linked = {}) {
  GraphData data = base();
  edit(data);
  return merge(scoredTable(), buildTable(Graph(data)), linked);
}

}  // namespace

TEST(MergeTables, SameReleaseChangesNothing) {
  const Merge result = mergedAfter([](GraphData&) {});
  EXPECT_EQ(result.table, scoredTable());
  EXPECT_EQ(result.kept, 2u);
  EXPECT_THAT(result.suspect, IsEmpty());
  EXPECT_THAT(result.added, IsEmpty());
}

TEST(MergeTables, ANewRowIsAddedWithoutScores) {
  const Merge result = mergedAfter([](GraphData& data) { data.edges.push_back({0, 3}); });
  ASSERT_EQ(result.table.rows.size(), 3u);
  EXPECT_EQ(result.added.size(), 1u);
  EXPECT_FALSE(result.table.find(result.added[0])->hasInput());
  EXPECT_EQ(result.kept, 2u);
}

TEST(MergeTables, AChangedTitleKeepsTheScoresButMakesThemSuspect) {
  const Merge result = mergedAfter([](GraphData& data) { data.nodes[1].title = "a new"; });
  EXPECT_EQ(result.table.rows[0].occurrence, scoredTable().rows[0].occurrence);
  EXPECT_THAT(result.table.rows[0].suspect, HasSubstr("Effect a was 'a' and is 'a new'."));
  EXPECT_THAT(result.suspect, ElementsAre(scoredTable().rows[0].key));
  EXPECT_FALSE(result.table.rows[1].isSuspect());
}

TEST(MergeTables, AChangedCauseKeepsTheScoresButMakesThemSuspect) {
  const Merge result = mergedAfter([](GraphData& data) { data.edges[2].child = 4; });
  EXPECT_EQ(result.table.rows[0].occurrence, scoredTable().rows[0].occurrence);
  EXPECT_EQ(result.table.rows[0].suspect,
            "Causes gone: 'x' (x, designParameter). Causes new: 'y' (y, systemIndependent).");
}

TEST(MergeTables, AnUnscoredRowIsNeverSuspectUnlessLinked) {
  const auto edit = [](GraphData& data) { data.nodes[2].title = "b new"; };
  Table scored = scoredTable();
  scored.rows[1].occurrence = {};
  GraphData data = base();
  edit(data);
  const Table fresh = buildTable(Graph(data));
  EXPECT_THAT(merge(scored, fresh).suspect, IsEmpty());
  EXPECT_THAT(merge(scored, fresh, {scored.rows[1].key}).suspect, ElementsAre(scored.rows[1].key));
}

TEST(MergeTables, ARemovedRowStaysAtTheEndAsSuspect) {
  const Merge result = mergedAfter([](GraphData& data) { data.edges.erase(data.edges.begin()); });
  ASSERT_EQ(result.table.rows.size(), 2u);
  const Row& gone = result.table.rows[1];
  EXPECT_EQ(gone.key, scoredTable().rows[0].key);
  EXPECT_TRUE(gone.gone);
  EXPECT_EQ(gone.relevance(), 7);
  EXPECT_THAT(gone.suspect, HasSubstr("no longer has this path"));
}

TEST(MergeTables, ARemovedRowWithoutInputIsDroppedUnlessLinked) {
  Table scored = scoredTable();
  scored.rows[0].occurrence = scored.rows[0].impact = {};
  GraphData data = base();
  data.edges.erase(data.edges.begin());
  const Table fresh = buildTable(Graph(data));
  EXPECT_THAT(merge(scored, fresh).dropped, ElementsAre(scored.rows[0].key));
  EXPECT_TRUE(merge(scored, fresh, {scored.rows[0].key}).table.rows[1].gone);
}

TEST(MergeTables, ARowThatComesBackIsNoLongerGoneButStillSuspect) {
  GraphData without = base();
  without.edges.erase(without.edges.begin());
  const Table between = merge(scoredTable(), buildTable(Graph(without))).table;
  const Merge back = merge(between, buildTable(Graph(base())));
  ASSERT_EQ(back.table.rows.size(), 2u);
  EXPECT_FALSE(back.table.rows[0].gone);
  EXPECT_EQ(back.table.rows[0].relevance(), 7);
  EXPECT_THAT(back.table.rows[0].suspect, HasSubstr("gone and is back"));
}

TEST(MergeTables, NewIdsWithTheSameTitlesCopyTheScoresAsSuspect) {
  const Merge result = mergedAfter([](GraphData& data) { data.nodes[1].id = "a2"; });
  ASSERT_EQ(result.table.rows.size(), 3u);
  EXPECT_EQ(result.table.rows[0].relevance(), 7);
  EXPECT_THAT(result.table.rows[0].suspect, HasSubstr("same titles but other ids"));
  EXPECT_TRUE(result.table.rows[2].gone);
  EXPECT_THAT(result.table.rows[2].suspect, HasSubstr("copied to row " + result.table.rows[0].key));
}

// Ids that were given to other nodes are the dangerous case: the old key exists and means something else.
TEST(MergeTables, SwappedIdsDoNotSwapTheScoresSilently) {
  const Merge result = mergedAfter([](GraphData& data) { std::swap(data.nodes[1].id, data.nodes[2].id); });
  ASSERT_EQ(result.table.rows.size(), 2u);
  for (const Row& row : result.table.rows) {
    EXPECT_EQ(row.occurrence.rationale, "why " + row.lastEffect().title);
    EXPECT_TRUE(row.isSuspect());
  }
}

TEST(MergeTables, MergingTwiceChangesNothingMore) {
  GraphData data = base();
  data.nodes[1].title = "a new";
  data.edges.erase(data.edges.begin() + 1);
  const Table fresh = buildTable(Graph(data));
  const Table once = merge(scoredTable(), fresh).table;
  EXPECT_EQ(merge(once, fresh).table, once);
}

TEST(MergeTables, TablesOfDifferentTreesAreRefused) {
  Table other = scoredTable();
  other.tree = "radar";
  EXPECT_THAT(test_support::thrownMessage([&] { (void)merge(scoredTable(), other); }),
              HasSubstr("the table is of the tree 'small', the graph of 'radar'"));
}

// From the last release with objects to the one without: whatever was scored is still there, and nothing is bound to
// other titles without being suspect.
TEST(MergeTables, NoScoreIsLostOrSilentlyReboundBetweenPublishedReleases) {
  FIDELIS_NEEDS_SHARED(shared);
  const auto tableOf = [&](const std::string& release) {
    return buildTable(percollect::readGraph(shared / "data/percollect/json" / release).graph);
  };
  Table scored = tableOf("lidarlimbs-2022-10-14.json");
  for (std::size_t i = 0; i < scored.rows.size(); ++i) {
    Row& row = scored.rows[i];
    std::string titles;
    for (const auto& effect : row.effects) titles += effect.title + "|";
    row.occurrence = {static_cast<int>(1 + i % 10), titles, "O"};
  }
  const Merge result = merge(scored, tableOf("lidarlimbs-2025.json"));
  std::set<std::string> rationales;
  std::set<std::string> keys;
  for (const Row& row : result.table.rows) {
    EXPECT_TRUE(keys.insert(row.key).second);
    if (!row.hasInput()) continue;
    rationales.insert(row.occurrence.rationale);
    std::string titles;
    for (const auto& effect : row.effects) titles += effect.title + "|";
    EXPECT_TRUE(row.isSuspect() || row.occurrence.rationale == titles);
  }
  EXPECT_EQ(rationales.size(), scored.rows.size());
}
