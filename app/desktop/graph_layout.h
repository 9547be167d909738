#pragma once

#include <QPainterPath>
#include <QPointF>
#include <QRectF>
#include <QSizeF>
#include <cstddef>
#include <utility>
#include <vector>

namespace desktop {

/// What is to be placed: boxes of known size, and lines between them as indices into the boxes.
struct LayoutTask {
  std::vector<QSizeF> boxes;                               ///< pixels
  std::vector<std::size_t> first;                          ///< boxes that stand at the left end
  std::vector<std::pair<std::size_t, std::size_t>> lines;  ///< effect, cause
};

/// Pixels, y downwards, upper left corner at (0, 0).
struct Layout {
  std::vector<QPointF> centres;     ///< of each box
  std::vector<QPainterPath> lines;  ///< of each line, from the cause to the effect
  QRectF area;
};

/// Layered drawing, effects left of their causes, few crossings (Graphviz `dot`). Deterministic. May be called from any
/// thread; calls wait for one another because Graphviz has global state.
[[nodiscard]] Layout layeredLayout(const LayoutTask& task);

}  // namespace desktop
