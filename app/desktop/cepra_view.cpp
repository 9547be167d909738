#include "app/desktop/cepra_view.h"

#include <QApplication>
#include <QClipboard>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMimeData>
#include <QPainter>
#include <QPlainTextEdit>
#include <algorithm>

namespace desktop {

namespace {

QString htmlTable(const CellBlock& block) {
  QString html = "<table>";
  for (const auto& row : block) {
    html += "<tr>";
    for (const std::string& cell : row) html += "<td>" + QString::fromStdString(cell).toHtmlEscaped() + "</td>";
    html += "</tr>";
  }
  return html + "</table>";
}

}  // namespace

QWidget* CellDelegate::createEditor(QWidget* parent, const QStyleOptionViewItem&, const QModelIndex& index) const {
  if (CepraModel::isScore(index.column())) {
    auto* line = new QLineEdit(parent);
    line->setAlignment(Qt::AlignCenter);
    line->setFrame(false);
    return line;
  }
  auto* text = new QPlainTextEdit(parent);
  text->setTabChangesFocus(true);
  text->setVerticalScrollBarPolicy(Qt::ScrollBarAsNeeded);
  return text;
}

void CellDelegate::setEditorData(QWidget* editor, const QModelIndex& index) const {
  const QString text = index.data(Qt::EditRole).toString();
  if (auto* lines = qobject_cast<QPlainTextEdit*>(editor)) {
    lines->setPlainText(text);
    lines->selectAll();
  } else if (auto* line = qobject_cast<QLineEdit*>(editor)) {
    line->setText(text);
  }
}

void CellDelegate::setModelData(QWidget* editor, QAbstractItemModel* model, const QModelIndex& index) const {
  if (auto* lines = qobject_cast<QPlainTextEdit*>(editor)) {
    model->setData(index, lines->toPlainText());
  } else if (auto* line = qobject_cast<QLineEdit*>(editor)) {
    model->setData(index, line->text());
  }
}

void CellDelegate::updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option,
                                        const QModelIndex& index) const {
  QRect place = option.rect;
  if (!CepraModel::isScore(index.column())) place.setHeight(std::max(place.height(), 96));  // room to write
  editor->setGeometry(place);
}

void CellDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const {
  QStyleOptionViewItem cell = option;
  // A selected score keeps its colour: it is a value, and the frame below says that it is selected.
  const bool coloured = index.data(Qt::BackgroundRole).isValid();
  if (coloured) cell.state &= ~QStyle::State_Selected;
  QStyledItemDelegate::paint(painter, cell, index);
  if (coloured && (option.state & QStyle::State_Selected)) {
    painter->save();
    painter->setPen(QPen(option.palette.color(QPalette::Highlight), 3));
    painter->drawRect(option.rect.adjusted(1, 1, -2, -2));
    painter->restore();
  }
}

bool CellDelegate::eventFilter(QObject* object, QEvent* event) {
  auto* editor = qobject_cast<QWidget*>(object);
  if (event->type() == QEvent::KeyPress && editor) {
    const auto* key = static_cast<QKeyEvent*>(event);
    if ((key->key() == Qt::Key_Return || key->key() == Qt::Key_Enter)) {
      if (auto* lines = qobject_cast<QPlainTextEdit*>(editor); lines && (key->modifiers() & Qt::AltModifier)) {
        lines->insertPlainText("\n");
        return true;
      }
      emit commitData(editor);
      emit closeEditor(editor, NoHint);
      emit entered();
      return true;
    }
  }
  return QStyledItemDelegate::eventFilter(object, event);
}

CepraView::CepraView(CepraModel& model, CepraFilter& filter, QWidget* parent)
    : QTableView(parent), cepra_(model), filter_(filter) {
  setModel(&filter_);
  auto* delegate = new CellDelegate(this);
  setItemDelegate(delegate);
  connect(delegate, &CellDelegate::entered, this, &CepraView::goDown);
  setAccessibleName(tr("Relevance table"));
  setSelectionMode(ExtendedSelection);
  setEditTriggers(DoubleClicked | EditKeyPressed | AnyKeyPressed);
  setSortingEnabled(true);
  sortByColumn(-1, Qt::AscendingOrder);
  setAlternatingRowColors(true);
  setWordWrap(true);
  setTextElideMode(Qt::ElideRight);
  setHorizontalScrollMode(ScrollPerPixel);
  verticalHeader()->setDefaultSectionSize(fontMetrics().lineSpacing() * 2 + 8);
  verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
  horizontalHeader()->setObjectName("cepraHeader");
  horizontalHeader()->setSectionsMovable(true);
  constexpr int kWidths[CepraModel::ColumnCount] = {140, 240, 140, 184, 36, 36, 44, 170, 90, 170, 90, 140};
  for (int column = 0; column < CepraModel::ColumnCount; ++column) setColumnWidth(column, kWidths[column]);
  horizontalHeader()->setMinimumSectionSize(30);
}

QModelIndexList CepraView::chosen() const {
  QModelIndexList cells = selectionModel()->selectedIndexes();
  if (cells.isEmpty() && currentIndex().isValid()) cells << currentIndex();
  std::sort(cells.begin(), cells.end(), [](const QModelIndex& a, const QModelIndex& b) {
    return std::pair(a.row(), a.column()) < std::pair(b.row(), b.column());
  });
  return cells;
}

void CepraView::setTexts(const QModelIndexList& cells, const std::string& text, const QString& what) {
  std::vector<CepraModel::CellText> texts;
  for (const QModelIndex& cell : cells) texts.push_back({source(cell), text});
  cepra_.setTexts(texts, what);
}

bool CepraView::scoreByDigit(const QKeyEvent& event) {
  const bool digit = event.key() >= Qt::Key_0 && event.key() <= Qt::Key_9;
  if (!digit || (event.modifiers() & ~Qt::KeypadModifier)) return false;
  const QModelIndexList cells = chosen();
  if (cells.isEmpty() ||
      !std::ranges::all_of(cells, [](const QModelIndex& c) { return CepraModel::isScore(c.column()); })) {
    return false;
  }
  const int score = event.key() == Qt::Key_0 ? 10 : event.key() - Qt::Key_0;
  setTexts(cells, std::to_string(score), tr("score %1").arg(score));
  return true;
}

void CepraView::keyPressEvent(QKeyEvent* event) {
  const bool enter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
  if (event->matches(QKeySequence::Copy)) {
    copy();
  } else if (event->matches(QKeySequence::Cut)) {
    copy();
    clearCells(tr("cut"));
  } else if (event->matches(QKeySequence::Paste)) {
    paste();
  } else if (event->key() == Qt::Key_Delete || event->key() == Qt::Key_Backspace) {
    clearCells(tr("clear"));
  } else if (event->key() == Qt::Key_D && event->modifiers() == Qt::ControlModifier) {
    fillDown();
  } else if (enter && event->modifiers() == Qt::ControlModifier) {
    goToNextUnscored();
  } else if (enter) {
    goDown();
  } else if (!scoreByDigit(*event)) {
    QTableView::keyPressEvent(event);
  }
}

void CepraView::goDown() {
  const QModelIndex below = currentIndex().siblingAtRow(currentIndex().row() + 1);
  if (below.isValid()) setCurrentIndex(below);
  setFocus();
}

void CepraView::copy() const {
  CellBlock block;
  int last_row = -1;
  for (const QModelIndex& cell : chosen()) {
    if (cell.row() != last_row) block.emplace_back();
    last_row = cell.row();
    block.back().push_back(cepra_.textOf(source(cell)));
  }
  auto* clip = new QMimeData;
  clip->setText(QString::fromStdString(toTsv(block)));
  clip->setHtml(htmlTable(block));
  QApplication::clipboard()->setMimeData(clip);
}

void CepraView::paste() {
  const CellBlock block = fromTsv(QApplication::clipboard()->text().toStdString());
  const QModelIndexList cells = chosen();
  if (block.empty() || cells.isEmpty()) return;
  if (block.size() == 1 && block[0].size() == 1) return setTexts(cells, block[0][0], tr("paste"));
  std::vector<CepraModel::CellText> texts;
  for (std::size_t i = 0; i < block.size(); ++i) {
    for (std::size_t k = 0; k < block[i].size(); ++k) {
      const QModelIndex cell = filter_.index(cells[0].row() + int(i), cells[0].column() + int(k));
      if (cell.isValid()) texts.push_back({source(cell), block[i][k]});
    }
  }
  cepra_.setTexts(texts, tr("paste"));
}

void CepraView::clearCells(const QString& what) { setTexts(chosen(), "", what); }

void CepraView::fillDown() {
  std::map<int, std::string> first;  // of each column
  std::vector<CepraModel::CellText> texts;
  for (const QModelIndex& cell : chosen()) {
    const auto [found, is_first] = first.try_emplace(cell.column(), cepra_.textOf(source(cell)));
    if (!is_first) texts.push_back({source(cell), found->second});
  }
  cepra_.setTexts(texts, tr("fill down"));
}

void CepraView::goToNextUnscored() {
  const int rows = filter_.rowCount();
  for (int step = 1; step <= rows; ++step) {
    const int row = (currentIndex().row() + step) % rows;
    const cepra::Row& content = cepra_.row(source(filter_.index(row, 0)).row());
    if (content.isScored()) continue;
    setCurrentIndex(filter_.index(row, content.occurrence.value ? CepraModel::Impact : CepraModel::Occurrence));
    return;
  }
}

}  // namespace desktop
