#include "app/desktop/visible_graph.h"

#include <algorithm>
#include <gtest/gtest.h>

#include "app/desktop/graph_layout.h"

namespace {

using desktop::GraphFilter;
using desktop::VisibleGraph;
using percollect::NodeKind;

/// Two phenomena A, B over a shared effect E; causes d (design, of E) and s (of A alone).
///   A -> E -> d      B -> E      A -> s
percollect::Graph graph() {
  percollect::GraphData data;
  data.tree = "t";
  for (const auto& [id, kind] :
       {std::pair("A", NodeKind::Effect), std::pair("B", NodeKind::Effect), std::pair("E", NodeKind::Effect),
        std::pair("d", NodeKind::DesignParameter), std::pair("s", NodeKind::SystemIndependent)}) {
    percollect::Node& node = data.nodes.emplace_back();
    node.id = node.title = id;
    node.kind = kind;
  }
  data.edges = {{0, 2}, {1, 2}, {2, 3}, {0, 4}};
  data.phenomena = {0, 1};
  return percollect::Graph(std::move(data));
}

std::string names(const VisibleGraph& part, const percollect::Graph& all) {
  std::string text;
  for (const std::size_t node : part.nodes) text += all.node(node).id;
  std::ranges::sort(text);
  return text;
}

std::string shown(const GraphFilter& filter) {
  const auto all = graph();
  return names(desktop::visiblePart(all, filter), all);
}

TEST(VisibleGraph, WithoutFilterEverythingIsShown) { EXPECT_EQ(shown({}), "ABEds"); }

TEST(VisibleGraph, OnePhenomenonShowsItsChainsOnly) { EXPECT_EQ(shown({.phenomena = {1}}), "BEd"); }

TEST(VisibleGraph, WithoutCausesOnlyEffectsRemain) { EXPECT_EQ(shown({.causes = false}), "ABE"); }

TEST(VisibleGraph, WhatAFoldedNodeAloneCausesToBeShownIsHidden) {
  EXPECT_EQ(shown({.folded = {2}}), "ABEs");
  EXPECT_EQ(shown({.folded = {0}}), "ABEd");  // E is still shown for B
}

TEST(VisibleGraph, ChainsThroughANodeAreItsEffectsAndItsCauses) { EXPECT_EQ(shown({.only_through = 4}), "As"); }

TEST(VisibleGraph, HiddenDirectCausesAreCounted) {
  const auto all = graph();
  const VisibleGraph part = desktop::visiblePart(all, {.causes = false});
  for (std::size_t i = 0; i < part.nodes.size(); ++i) {
    EXPECT_EQ(part.hidden[i], all.node(part.nodes[i]).id == "B" ? 0u : 1u) << all.node(part.nodes[i]).id;
  }
}

// Whatever hides a node, revealing shows it, and nothing that was visible goes without need.
TEST(VisibleGraph, RevealingShowsTheNodeUnderEveryFilter) {
  const auto all = graph();
  for (const GraphFilter& start :
       {GraphFilter{.causes = false}, GraphFilter{.phenomena = {1}}, GraphFilter{.folded = {0, 2}},
        GraphFilter{.phenomena = {1}, .causes = false, .folded = {2}, .only_through = 1}}) {
    for (std::size_t node = 0; node < all.size(); ++node) {
      GraphFilter filter = start;
      desktop::reveal(all, node, filter);
      EXPECT_NE(names(desktop::visiblePart(all, filter), all).find(all.node(node).id), std::string::npos)
          << all.node(node).id;
    }
  }
}

TEST(LayeredLayout, EffectsStandLeftOfTheirCausesAndBoxesDoNotOverlap) {
  const desktop::LayoutTask task = {.boxes = std::vector<QSizeF>(5, QSizeF(200, 40)),
                                    .lines = {{0, 1}, {0, 2}, {1, 3}, {2, 3}, {0, 4}}};
  const desktop::Layout layout = desktop::layeredLayout(task);
  ASSERT_EQ(layout.centres.size(), 5u);
  for (std::size_t i = 0; i < task.lines.size(); ++i) {
    const auto& [effect, cause] = task.lines[i];
    EXPECT_LT(layout.centres[effect].x() + 100, layout.centres[cause].x() - 100);
    // The line begins at the cause and ends, with its arrow, at the effect.
    EXPECT_NEAR(layout.lines[i].pointAtPercent(1).x(), layout.centres[effect].x() + 100, 12);
    EXPECT_NEAR(layout.lines[i].pointAtPercent(0).x(), layout.centres[cause].x() - 100, 12);
  }
  for (std::size_t a = 0; a < 5; ++a) {
    for (std::size_t b = a + 1; b < 5; ++b) {
      const QPointF apart = layout.centres[a] - layout.centres[b];
      EXPECT_TRUE(std::abs(apart.x()) >= 200 || std::abs(apart.y()) >= 40) << a << " and " << b;
    }
  }
}

TEST(LayeredLayout, NothingToDrawIsAnEmptyDrawing) { EXPECT_TRUE(desktop::layeredLayout({}).centres.empty()); }

}  // namespace
