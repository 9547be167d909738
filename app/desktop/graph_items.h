#pragma once

#include <QGraphicsItem>
#include <QPainterPath>
#include <QString>
#include <cstddef>

#include "percollect/graph.h"

namespace desktop {

/// How strongly an item shows while chains are highlighted.
enum class Emphasis { Normal, Chain, Selected, Hit, Dimmed };

/// A node of the graph: a rounded box in the colour of its kind with its block above its title.
///
///   +--------------------------+
///   | SIGNAL PROPAGATION       |
///   | Attenuation by aerosols  |(+3)   <- unfolds what is hidden, folds what is shown
///   +--------------------------+
class NodeItem final : public QGraphicsItem {
 public:
  enum { Type = UserType + 1 };

  NodeItem(std::size_t node, const percollect::Node& content);

  /// What a box for this node needs, without the fold button.
  static QSizeF sizeFor(const percollect::Node& content);

  [[nodiscard]] std::size_t node() const noexcept { return node_; }
  void setEmphasis(Emphasis emphasis);
  /// `hidden`: causes that are not shown; `foldable`: it has any.
  void setFolding(bool foldable, std::size_t hidden);
  [[nodiscard]] bool onFoldButton(const QPointF& scene_position) const;

  [[nodiscard]] int type() const override { return Type; }
  [[nodiscard]] QRectF boundingRect() const override;
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

 private:
  [[nodiscard]] QRectF box() const;
  [[nodiscard]] QRectF button() const;

  std::size_t node_;
  percollect::NodeKind kind_;
  QString block_;
  QString title_;
  QSizeF size_;
  Emphasis emphasis_ = Emphasis::Normal;
  bool foldable_ = false;
  std::size_t hidden_ = 0;
};

/// From a cause to its effect, with an arrow head at the effect.
class EdgeItem final : public QGraphicsItem {
 public:
  EdgeItem(percollect::Edge edge, QPainterPath path);

  [[nodiscard]] const percollect::Edge& edge() const noexcept { return edge_; }
  void setEmphasis(Emphasis emphasis);
  [[nodiscard]] QRectF boundingRect() const override;
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

 private:
  percollect::Edge edge_;
  QPainterPath path_;
  Emphasis emphasis_ = Emphasis::Normal;
};

}  // namespace desktop
