#pragma once

#include <QGraphicsScene>
#include <QThread>
#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>

#include "app/desktop/graph_items.h"
#include "app/desktop/graph_layout.h"
#include "app/desktop/visible_graph.h"

namespace desktop {

/// The drawn part of a graph. Boxes are placed by a worker thread; until it has finished, the old drawing stays.
class GraphScene final : public QGraphicsScene {
  Q_OBJECT

 public:
  explicit GraphScene(QObject* parent = nullptr);
  ~GraphScene() override;

  /// The graph must stay alive until the next call. Asks for a new drawing; drawn() follows.
  void show(const percollect::Graph& graph, const GraphFilter& filter);
  /// Nothing is drawn any more; for a graph that is about to go.
  void forget();
  [[nodiscard]] bool isLayingOut() const noexcept { return worker_ != nullptr; }

  /// Shows the chains through a node and dims the rest; nothing: all as strong as before.
  void select(std::optional<std::size_t> node);
  void markHits(const std::set<std::size_t>& nodes);
  [[nodiscard]] std::optional<std::size_t> selected() const noexcept { return selected_; }
  [[nodiscard]] NodeItem* itemOf(std::size_t node) const;
  [[nodiscard]] std::size_t nodesShown() const noexcept { return items_.size(); }
  [[nodiscard]] Emphasis emphasisOf(std::size_t node) const;

 signals:
  void drawn();
  void nodeClicked(std::size_t node);
  void backgroundClicked();
  void foldToggled(std::size_t node);

 protected:
  void mousePressEvent(QGraphicsSceneMouseEvent* event) override;
  void mouseDoubleClickEvent(QGraphicsSceneMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void startLayout();
  void rebuild(const VisibleGraph& part, const Layout& layout);
  void applyEmphasis();
  [[nodiscard]] NodeItem* nodeAt(const QPointF& position) const;
  [[nodiscard]] NodeItem* neighbour(const NodeItem& from, int key) const;

  const percollect::Graph* graph_ = nullptr;
  std::optional<VisibleGraph> wanted_;  ///< waits for the worker
  std::unique_ptr<QThread> worker_;
  std::map<std::size_t, NodeItem*> items_;
  std::vector<EdgeItem*> edges_;
  std::map<std::size_t, Emphasis> emphasis_;
  std::optional<std::size_t> selected_;
  std::set<std::size_t> hits_;
};

}  // namespace desktop
