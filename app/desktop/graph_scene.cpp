#include "app/desktop/graph_scene.h"

#include <QGraphicsSceneMouseEvent>
#include <QKeyEvent>
#include <algorithm>
#include <cmath>

#include "percollect/chains.h"

namespace desktop {

namespace {

LayoutTask taskFor(const percollect::Graph& graph, const VisibleGraph& part) {
  LayoutTask task;
  std::map<std::size_t, std::size_t> place;
  for (std::size_t i = 0; i < part.nodes.size(); ++i) {
    place[part.nodes[i]] = i;
    task.boxes.push_back(NodeItem::sizeFor(graph.node(part.nodes[i])));
    if (graph.parents(part.nodes[i]).empty()) task.first.push_back(i);
  }
  for (const percollect::Edge& edge : part.edges) task.lines.emplace_back(place[edge.parent], place[edge.child]);
  return task;
}

}  // namespace

GraphScene::GraphScene(QObject* parent) : QGraphicsScene(parent) {
  // Some hundred items: an index costs more than it saves when everything is rebuilt.
  setItemIndexMethod(NoIndex);
}

GraphScene::~GraphScene() {
  if (worker_) worker_->wait();
}

void GraphScene::show(const percollect::Graph& graph, const GraphFilter& filter) {
  graph_ = &graph;
  wanted_ = visiblePart(graph, filter);
  if (!worker_) startLayout();
}

void GraphScene::forget() {
  clear();
  items_.clear();
  edges_.clear();
  emphasis_.clear();
  selected_.reset();
  hits_.clear();
}

void GraphScene::startLayout() {
  struct Job {
    VisibleGraph part;
    LayoutTask task;
    Layout layout;
  };
  auto job = std::make_shared<Job>();
  job->part = std::move(*wanted_);
  wanted_.reset();
  job->task = taskFor(*graph_, job->part);  // fonts are measured here: the worker must not touch the screen
  worker_.reset(QThread::create([job] { job->layout = layeredLayout(job->task); }));
  connect(worker_.get(), &QThread::finished, this, [this, job] {
    worker_.release()->deleteLater();
    if (wanted_) {
      startLayout();  // the person went on meanwhile: only the latest wish counts
    } else {
      rebuild(job->part, job->layout);
    }
  });
  worker_->start();
}

void GraphScene::rebuild(const VisibleGraph& part, const Layout& layout) {
  clear();
  items_.clear();
  edges_.clear();
  for (std::size_t i = 0; i < part.nodes.size(); ++i) {
    const std::size_t node = part.nodes[i];
    auto* item = new NodeItem(node, graph_->node(node));
    item->setPos(layout.centres[i]);
    item->setFolding(!graph_->children(node).empty(), part.hidden[i]);
    addItem(item);
    items_[node] = item;
  }
  for (std::size_t i = 0; i < part.edges.size(); ++i) {
    edges_.push_back(new EdgeItem(part.edges[i], layout.lines[i]));
    addItem(edges_.back());
  }
  setSceneRect(layout.area.adjusted(-40, -40, 40, 40));
  if (selected_ && !items_.count(*selected_)) selected_.reset();
  applyEmphasis();
  emit drawn();
}

void GraphScene::select(std::optional<std::size_t> node) {
  selected_ = node;
  applyEmphasis();
}

void GraphScene::markHits(const std::set<std::size_t>& nodes) {
  hits_ = nodes;
  applyEmphasis();
}

NodeItem* GraphScene::itemOf(std::size_t node) const {
  const auto found = items_.find(node);
  return found == items_.end() ? nullptr : found->second;
}

Emphasis GraphScene::emphasisOf(std::size_t node) const {
  const auto found = emphasis_.find(node);
  return found == emphasis_.end() ? Emphasis::Normal : found->second;
}

void GraphScene::applyEmphasis() {
  const Emphasis rest = selected_ || !hits_.empty() ? Emphasis::Dimmed : Emphasis::Normal;
  emphasis_.clear();
  for (const auto& [node, item] : items_) emphasis_[node] = rest;
  for (EdgeItem* edge : edges_) edge->setEmphasis(rest);
  if (selected_) {
    const percollect::Neighbourhood chains = percollect::chainsThrough(*graph_, *selected_);
    for (const auto* side : {&chains.causes, &chains.effects}) {
      for (const std::size_t node : *side) emphasis_[node] = Emphasis::Chain;
    }
    for (EdgeItem* edge : edges_) {
      if (std::ranges::find(chains.edges, edge->edge()) != chains.edges.end()) edge->setEmphasis(Emphasis::Chain);
    }
  }
  for (const std::size_t node : hits_) emphasis_[node] = Emphasis::Hit;
  if (selected_) emphasis_[*selected_] = Emphasis::Selected;
  for (const auto& [node, item] : items_) item->setEmphasis(emphasis_[node]);
}

NodeItem* GraphScene::nodeAt(const QPointF& position) const {
  for (QGraphicsItem* item : items(position)) {
    if (auto* node = qgraphicsitem_cast<NodeItem*>(item)) return node;
  }
  return nullptr;
}

void GraphScene::mousePressEvent(QGraphicsSceneMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  NodeItem* item = nodeAt(event->scenePos());
  if (!item) {
    emit backgroundClicked();
    event->ignore();  // the view pans
    return;
  }
  event->accept();
  if (item->onFoldButton(event->scenePos())) {
    emit foldToggled(item->node());
  } else {
    emit nodeClicked(item->node());
  }
}

void GraphScene::mouseDoubleClickEvent(QGraphicsSceneMouseEvent* event) {
  if (NodeItem* item = nodeAt(event->scenePos())) emit foldToggled(item->node());
}

NodeItem* GraphScene::neighbour(const NodeItem& from, int key) const {
  const std::size_t node = from.node();
  const auto first = [&](std::span<const std::size_t> candidates) -> NodeItem* {
    NodeItem* best = nullptr;
    for (const std::size_t candidate : candidates) {
      NodeItem* item = itemOf(candidate);
      const auto distance = [&](const NodeItem* it) { return std::abs(it->y() - from.y()); };
      if (item && (!best || distance(item) < distance(best))) best = item;
    }
    return best;
  };
  if (key == Qt::Key_Right) return first(graph_->children(node));
  if (key == Qt::Key_Left) return first(graph_->parents(node));
  NodeItem* best = nullptr;  // the next box above or below in the same layer
  for (const auto& [other, item] : items_) {
    const double dy = (item->y() - from.y()) * (key == Qt::Key_Down ? 1 : -1);
    if (std::abs(item->x() - from.x()) > 60 || dy <= 0) continue;
    if (!best || dy < std::abs(best->y() - from.y())) best = item;
  }
  return best;
}

void GraphScene::keyPressEvent(QKeyEvent* event) {
  const int key = event->key();
  if (items_.empty()) return;
  NodeItem* current = selected_ ? itemOf(*selected_) : nullptr;
  if (key == Qt::Key_Left || key == Qt::Key_Right || key == Qt::Key_Up || key == Qt::Key_Down) {
    NodeItem* next = current ? neighbour(*current, key) : items_.begin()->second;
    if (next) emit nodeClicked(next->node());
  } else if (current && (key == Qt::Key_Space || key == Qt::Key_Return || key == Qt::Key_Enter)) {
    emit foldToggled(current->node());
  } else if (key == Qt::Key_Escape) {
    emit backgroundClicked();
  } else {
    QGraphicsScene::keyPressEvent(event);
  }
}

}  // namespace desktop
