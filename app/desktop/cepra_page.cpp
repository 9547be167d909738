#include "app/desktop/cepra_page.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QSplitter>
#include <QUrl>
#include <QVBoxLayout>

#include "app/desktop/colours.h"
#include "app/desktop/page_parts.h"
#include "app/desktop/row_details.h"
#include "core/error.h"

namespace desktop {

CepraPage::CepraPage(ProjectDocument& document, QWidget* parent)
    : QWidget(parent), document_(document), model_(document), filter_(document) {
  try {
    scales_ = cepra::readScales();
  } catch (const core::InputError&) {
    // Scores can be given without the wording; the list stays empty and says so.
  }
  filter_.setSourceModel(&model_);
  view_ = new CepraView(model_, filter_);
  auto* splitter = new QSplitter;
  splitter->setObjectName("cepraSplitter");
  splitter->addWidget(view_);
  splitter->addWidget(makeSide());
  splitter->setStretchFactor(0, 1);
  splitter->setSizes({1060, 360});
  auto* layout = seamlessColumn(this);
  layout->addWidget(makeBar());
  layout->addWidget(splitter, 1);

  connect(search_, &QLineEdit::textChanged, this, [this](const QString& text) {
    filter_.setWords(text);
    tellCount();
  });
  connect(gap_, &QComboBox::activated, this, [this](int choice) {
    filter_.setGap(CepraFilter::Gap(choice));
    tellCount();
  });
  connect(view_->selectionModel(), &QItemSelectionModel::currentChanged, this, [this] {
    message_->hide();
    showDetails();
    showScale();
  });
  connect(&model_, &CepraModel::rejected, this, [this](const QString& text) {
    message_->setText(text);
    message_->show();
  });
  connect(&model_, &QAbstractItemModel::dataChanged, this, [this] {
    showDetails();
    showScale();
  });
  connect(&document_, &ProjectDocument::specificationChanged, this, &CepraPage::showDetails);
  connect(&document_, &ProjectDocument::reset, this, [this] {
    search_->clear();
    view_->setCurrentIndex(filter_.index(0, CepraModel::Occurrence));
    showDetails();
    tellCount();
  });
  connect(details_, &QTextBrowser::anchorClicked, this, &CepraPage::followLink);
  connect(scale_, &QListWidget::itemActivated, this, [this](QListWidgetItem* item) {
    const QModelIndex cell = filter_.mapToSource(view_->currentIndex());
    if (CepraModel::isScore(cell.column())) model_.setData(cell, item->data(Qt::UserRole));
    view_->setFocus();
  });
}

QWidget* CepraPage::makeBar() {
  auto* bar = new QWidget;
  auto* rows = new QVBoxLayout(bar);
  rows->setContentsMargins(8, 6, 8, 6);
  auto* layout = new QHBoxLayout;
  search_ = new QLineEdit;
  search_->setObjectName("cepraSearch");
  search_->setPlaceholderText(tr("Filter rows by words"));
  search_->setAccessibleName(tr("Filter of the relevance table"));
  search_->setClearButtonEnabled(true);
  search_->setFixedWidth(280);
  gap_ = new QComboBox;
  gap_->setAccessibleName(tr("Which rows"));
  gap_->addItems({tr("All rows"), tr("Not scored"), tr("Suspect"), tr("Relevant without requirement")});
  count_ = new QLabel;
  count_->setObjectName("cepraCount");
  layout->addWidget(search_);
  layout->addWidget(gap_);
  layout->addWidget(count_);
  layout->addStretch(1);
  auto* keys = new QLabel(tr("Digits score (0 = 10) · F2 edits · Ctrl+D fills down · Ctrl+Enter next unscored"));
  keys->setForegroundRole(QPalette::PlaceholderText);
  layout->addWidget(keys);
  message_ = new QLabel;
  message_->setObjectName("cepraMessage");
  message_->setWordWrap(true);
  message_->setAutoFillBackground(true);
  message_->setBackgroundRole(QPalette::ToolTipBase);
  message_->setForegroundRole(QPalette::ToolTipText);
  message_->setMargin(6);
  message_->hide();
  rows->addLayout(layout);
  rows->addWidget(message_);
  return bar;
}

QWidget* CepraPage::makeSide() {
  auto* side = new QSplitter(Qt::Vertical);
  side->setObjectName("cepraSide");
  details_ = textPane(tr("The row in full"));
  auto* lower = new QWidget;
  auto* layout = new QVBoxLayout(lower);
  layout->setContentsMargins(0, 4, 0, 0);
  scale_title_ = new QLabel;
  scale_title_->setWordWrap(true);
  scale_title_->setMargin(4);
  scale_ = new QListWidget;
  scale_->setAccessibleName(tr("Rating scale; Enter or double click scores"));
  scale_->setWordWrap(true);
  scale_->setSpacing(2);
  scale_->setAlternatingRowColors(true);
  layout->addWidget(scale_title_);
  layout->addWidget(scale_, 1);
  side->addWidget(details_);
  side->addWidget(lower);
  side->setSizes({460, 380});
  side->setMinimumWidth(240);
  return side;
}

const cepra::Scale* CepraPage::currentScale() const {
  if (!scales_) return nullptr;
  const int column = view_->currentIndex().column();
  const bool impact =
      column == CepraModel::Impact || column == CepraModel::ImpactWhy || column == CepraModel::ImpactExpert;
  return impact ? &scales_->impact : &scales_->occurrence;
}

void CepraPage::showScale() {
  scale_->clear();
  const cepra::Scale* scale = currentScale();
  const QModelIndex cell = filter_.mapToSource(view_->currentIndex());
  if (!scale || !cell.isValid()) {
    scale_title_->setText(scale ? QString() : tr("The rating scales are not installed."));
    return;
  }
  scale_title_->setText("<b>" + QString::fromStdString(scale->title) + "</b><br/>" +
                        QString::fromStdString(scale->question));
  const cepra::Row& row = model_.row(cell.row());
  const auto& value = scale == &scales_->impact ? row.impact.value : row.occurrence.value;
  for (const cepra::ScaleLevel& level : scale->levels) {
    auto* item =
        new QListWidgetItem(QString("%1  %2\n%3")
                                .arg(level.value)
                                .arg(QString::fromStdString(level.label), QString::fromStdString(level.description)));
    item->setData(Qt::UserRole, level.value);
    scale_->addItem(item);
    if (value == level.value) scale_->setCurrentItem(item);
  }
}

void CepraPage::showDetails() {
  const QModelIndex cell = filter_.mapToSource(view_->currentIndex());
  details_->setHtml(cell.isValid() ? rowDetails(document_, model_.row(cell.row()), palette()) : QString());
}

void CepraPage::showRowsOf(const QString& node_id) {
  gap_->setCurrentIndex(0);
  filter_.setGap(CepraFilter::Gap::None);
  search_->setText("node:" + node_id);
  view_->setCurrentIndex(filter_.index(0, CepraModel::Occurrence));
}

void CepraPage::showRow(const std::string& key) {
  gap_->setCurrentIndex(0);
  filter_.setGap(CepraFilter::Gap::None);
  search_->clear();
  const auto& rows = document_.table().rows;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (rows[i].key != key) continue;
    view_->setCurrentIndex(filter_.mapFromSource(model_.index(int(i), CepraModel::Occurrence)));
    view_->scrollTo(view_->currentIndex(), QAbstractItemView::PositionAtCenter);
  }
}

void CepraPage::followLink(const QUrl& url) {
  const QString target = url.toString().section(':', 1);
  if (url.scheme() == "node") {
    emit nodeRequested(target);
  } else if (url.scheme() == "item") {
    emit itemRequested(target);
  } else if (url.scheme() == "add") {
    const cepra::Row* row = document_.table().find(target.toStdString());
    if (!row) return;
    specs::Requirement requirement;
    requirement.id = document_.proposeId(row->key);
    requirement.title = specs::rowTitle(*row);
    document_.addItem(requirement, {row->key});
    emit itemRequested(QString::fromStdString(requirement.id));
  }
}

void CepraPage::tellCount() { count_->setText(tr("%1 of %2 rows").arg(filter_.rowCount()).arg(model_.rowCount())); }

void CepraPage::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) showDetails();
}

}  // namespace desktop
