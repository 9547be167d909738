#pragma once

#include <QLineEdit>
#include <QTextBrowser>
#include <QTreeView>
#include <QWidget>

#include "app/desktop/item_form.h"
#include "app/desktop/spec_tree_model.h"

class QToolButton;

namespace desktop {

/// The specification tab: tree, form of the selected item, its links both ways.
class SpecPage final : public QWidget {
  Q_OBJECT

 public:
  explicit SpecPage(ProjectDocument& document, QWidget* parent = nullptr);

  void showItem(const std::string& id);
  [[nodiscard]] std::string currentId() const;
  [[nodiscard]] ItemForm& form() { return *form_; }
  [[nodiscard]] QTreeView& tree() { return *tree_; }

 signals:
  void rowRequested(const QString& key);
  void resultRequested(const QString& test_id);

 protected:
  void changeEvent(QEvent* event) override;  ///< rich text holds colours of the palette

 private:
  QWidget* makeBar();
  void rebuild();
  void showCurrent();
  void showLinks();
  void filter(const QString& text);
  bool filterBranch(const QModelIndex& parent, const QString& words);
  void addItem(specs::Kind kind);
  void linkTo();
  void followLink(const QUrl& url);

  ProjectDocument& document_;
  SpecTreeModel model_;
  QTreeView* tree_;
  ItemForm* form_;
  QTextBrowser* links_;
  QLineEdit* search_;
};

}  // namespace desktop
