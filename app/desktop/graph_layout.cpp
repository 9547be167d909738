#include "app/desktop/graph_layout.h"

#include <graphviz/gvc.h>
#include <memory>
#include <mutex>
#include <string>

namespace desktop {

namespace {

constexpr double kPointsPerInch = 72.0;  // one pixel is taken for one point

/// Graphviz takes `char*` and does not write to it.
char* text(const std::string& value) { return const_cast<char*>(value.c_str()); }

void set(void* object, const char* name, const std::string& value) {
  agsafeset(object, text(name), text(value), text(""));
}

/// Graph and layout that free themselves, in the right order.
class Drawing {
 public:
  Drawing() : context_(gvContext()), graph_(agopen(text("chains"), Agdirected, nullptr)) {}
  ~Drawing() {
    gvFreeLayout(context_, graph_);
    agclose(graph_);
    gvFreeContext(context_);
  }
  Drawing(const Drawing&) = delete;
  Drawing& operator=(const Drawing&) = delete;

  Agraph_t* graph() { return graph_; }
  void place() { gvLayout(context_, graph_, "dot"); }

 private:
  GVC_t* context_;
  Agraph_t* graph_;
};

QPainterPath pathOf(Agedge_t* edge, double height) {
  QPainterPath path;
  const splines* curves = ED_spl(edge);
  if (!curves) return path;
  const auto point = [&](const pointf& p) { return QPointF(p.x, height - p.y); };
  for (std::size_t i = 0; i < std::size_t(curves->size); ++i) {
    const bezier& curve = curves->list[i];
    // The arrow head sits at the effect, where dot begins the curve; so the path is walked backwards.
    const auto size = std::size_t(curve.size);
    path.moveTo(point(curve.list[size - 1]));
    for (std::size_t k = size - 1; k >= 3; k -= 3) {
      path.cubicTo(point(curve.list[k - 1]), point(curve.list[k - 2]), point(curve.list[k - 3]));
    }
  }
  return path;
}

}  // namespace

Layout layeredLayout(const LayoutTask& task) {
  if (task.boxes.empty()) return {};
  static std::mutex graphviz;
  const std::lock_guard lock(graphviz);
  Drawing drawing;
  Agraph_t* graph = drawing.graph();
  set(graph, "rankdir", "LR");
  set(graph, "nodesep", "0.16");
  set(graph, "ranksep", "0.75");
  set(graph, "splines", "true");
  std::vector<Agnode_t*> nodes;
  for (std::size_t i = 0; i < task.boxes.size(); ++i) {
    Agnode_t* node = agnode(graph, text("n" + std::to_string(i)), 1);
    set(node, "shape", "box");
    set(node, "fixedsize", "true");
    set(node, "label", "");
    set(node, "width", std::to_string(task.boxes[i].width() / kPointsPerInch));
    set(node, "height", std::to_string(task.boxes[i].height() / kPointsPerInch));
    nodes.push_back(node);
  }
  Agraph_t* first = agsubg(graph, text("first"), 1);
  set(first, "rank", "min");
  for (const std::size_t box : task.first) agsubnode(first, nodes[box], 1);
  std::vector<Agedge_t*> edges;
  for (const auto& [effect, cause] : task.lines) {
    Agedge_t* edge = agedge(graph, nodes[effect], nodes[cause], nullptr, 1);
    set(edge, "arrowhead", "none");
    edges.push_back(edge);
  }
  drawing.place();
  Layout layout;
  const boxf bounds = GD_bb(graph);
  const double height = bounds.UR.y;
  layout.area = QRectF(0, 0, bounds.UR.x, height);
  for (Agnode_t* node : nodes) layout.centres.emplace_back(ND_coord(node).x, height - ND_coord(node).y);
  for (Agedge_t* edge : edges) layout.lines.push_back(pathOf(edge, height));
  return layout;
}

}  // namespace desktop
