#pragma once

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QStandardItemModel>
#include <QTextBrowser>
#include <QWidget>

#include "app/desktop/graph_scene.h"
#include "app/desktop/graph_view.h"
#include "app/desktop/project_document.h"

class QCompleter;
class QSplitter;

namespace desktop {

/// The graph tab: drawing, search, filter by phenomenon, details of the selected node.
class GraphPage final : public QWidget {
  Q_OBJECT

 public:
  explicit GraphPage(ProjectDocument& document, QWidget* parent = nullptr);

  /// Selects a node, unfolding what hides it.
  void showNode(const std::string& id);
  void fit() { view_->fit(); }
  [[nodiscard]] GraphScene& scene() { return *scene_; }
  [[nodiscard]] GraphView& view() { return *view_; }
  [[nodiscard]] QSplitter& splitter() { return *splitter_; }

 signals:
  void rowsRequested(const QString& node_id);
  void itemRequested(const QString& id);

 protected:
  void changeEvent(QEvent* event) override;  ///< rich text holds colours of the palette

 private:
  QWidget* makeBar();
  QWidget* makeLegend();
  void resetGraph();
  void applyFilter();
  void fillSearch();
  void search(const QString& text);
  void pick(std::size_t node);
  void clearSelection();
  void toggleFold(std::size_t node);
  void showDetails();
  void followLink(const QUrl& url);
  void tellCount();

  ProjectDocument& document_;
  GraphScene* scene_;
  GraphView* view_;
  QSplitter* splitter_;
  QTextBrowser* details_;
  QLineEdit* search_;
  QLabel* hits_;
  QLabel* count_;
  QComboBox* phenomenon_;
  QCheckBox* causes_;
  QCheckBox* isolate_;
  QStandardItemModel* completions_;
  GraphFilter filter_;
  std::optional<std::size_t> wanted_;  ///< to be selected once it is drawn
  bool fit_when_drawn_ = false;
};

}  // namespace desktop
