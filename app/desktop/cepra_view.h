#pragma once

#include <QStyledItemDelegate>
#include <QTableView>

#include "app/desktop/cepra_model.h"

namespace desktop {

/// Editors of cells: a line for a score, several lines for a text. Enter commits, Alt+Enter breaks the line.
class CellDelegate final : public QStyledItemDelegate {
  Q_OBJECT

 public:
  using QStyledItemDelegate::QStyledItemDelegate;

  QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
  void setEditorData(QWidget* editor, const QModelIndex& index) const override;
  void setModelData(QWidget* editor, QAbstractItemModel* model, const QModelIndex& index) const override;
  void updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option,
                            const QModelIndex& index) const override;
  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;

 signals:
  void entered();  ///< committed by Enter: the cell below is next

 protected:
  bool eventFilter(QObject* object, QEvent* event) override;
};

/// The relevance table under spreadsheet keys:
///
///   1 … 9, 0 (= 10)   score the cell           F2, any letter   edit         Enter down, Tab right
///   Delete            clear                    Ctrl+D           fill down    Ctrl+Enter  next unscored row
///   Ctrl+C, X, V      blocks as TSV (and HTML); one cell may be pasted to many
class CepraView final : public QTableView {
  Q_OBJECT

 public:
  CepraView(CepraModel& model, CepraFilter& filter, QWidget* parent = nullptr);

  void copy() const;
  void paste();
  void clearCells(const QString& what);
  void fillDown();
  void goToNextUnscored();

 protected:
  void keyPressEvent(QKeyEvent* event) override;

 private:
  bool scoreByDigit(const QKeyEvent& event);
  void goDown();
  void setTexts(const QModelIndexList& cells, const std::string& text, const QString& what);
  /// Selected cells in the order of the screen; the current one if none is selected.
  [[nodiscard]] QModelIndexList chosen() const;
  [[nodiscard]] QModelIndex source(const QModelIndex& shown) const { return filter_.mapToSource(shown); }

  CepraModel& cepra_;
  CepraFilter& filter_;
};

}  // namespace desktop
