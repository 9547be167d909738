#include "app/desktop/spec_page.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QInputDialog>
#include <QLabel>
#include <QMenu>
#include <QSplitter>
#include <QUrl>

#include "app/desktop/colours.h"
#include "app/desktop/error_dialog.h"
#include "app/desktop/link_details.h"
#include "app/desktop/page_parts.h"

namespace desktop {

SpecPage::SpecPage(ProjectDocument& document, QWidget* parent)
    : QWidget(parent),
      document_(document),
      model_(document),
      tree_(new QTreeView),
      form_(new ItemForm(document)),
      links_(textPane(tr("Links of the selected item"))) {
  tree_->setModel(&model_);
  tree_->setAccessibleName(tr("Specification"));
  tree_->setUniformRowHeights(true);
  tree_->setIconSize({18, 18});
  tree_->setAlternatingRowColors(true);
  auto* side = new QSplitter(Qt::Vertical);
  side->setObjectName("specSide");
  side->addWidget(form_);
  side->addWidget(links_);
  side->setSizes({460, 320});
  auto* splitter = new QSplitter;
  splitter->setObjectName("specSplitter");
  splitter->addWidget(tree_);
  splitter->addWidget(side);
  splitter->setSizes({900, 540});
  auto* layout = seamlessColumn(this);
  layout->addWidget(makeBar());
  layout->addWidget(splitter, 1);

  connect(tree_->selectionModel(), &QItemSelectionModel::currentChanged, this, &SpecPage::showCurrent);
  connect(links_, &QTextBrowser::anchorClicked, this, &SpecPage::followLink);
  for (const auto change :
       {&ProjectDocument::reset, &ProjectDocument::specificationChanged, &ProjectDocument::verdictsChanged}) {
    connect(&document_, change, this, &SpecPage::rebuild);
  }
  connect(&document_, &ProjectDocument::itemEdited, this, [this](const QString& id) {
    model_.refresh(id.toStdString());
    if (id.toStdString() != form_->id()) return;
    form_->refresh();
    showLinks();
  });
  rebuild();
}

QWidget* SpecPage::makeBar() {
  auto* bar = new QWidget;
  auto* layout = new QHBoxLayout(bar);
  layout->setContentsMargins(8, 6, 8, 6);
  search_ = new QLineEdit;
  search_->setObjectName("specSearch");
  search_->setPlaceholderText(tr("Filter titles and ids"));
  search_->setAccessibleName(tr("Filter of the specification"));
  search_->setClearButtonEnabled(true);
  search_->setFixedWidth(280);
  connect(search_, &QLineEdit::textChanged, this, &SpecPage::filter);
  auto* menu = new QMenu(this);
  using specs::Kind;
  for (const Kind kind : {Kind::Requirement, Kind::AcceptanceTest, Kind::ExperimentData, Kind::ReferenceData}) {
    menu->addAction(wordFor(kind), this, [this, kind] { addItem(kind); });
  }
  auto* add = toolButton(tr("Add"), tr("Add an item that follows from the selected one"));
  add->setMenu(menu);
  add->setPopupMode(QToolButton::InstantPopup);
  auto* link = toolButton(tr("Link to…"), tr("Let another item follow from the selected one"));
  connect(link, &QToolButton::clicked, this, &SpecPage::linkTo);
  auto* remove = toolButton(tr("Remove"), tr("Remove the selected item and its links (Undo brings both back)"));
  connect(remove, &QToolButton::clicked, this, [this] { document_.removeItem(currentId()); });
  for (QWidget* widget : std::initializer_list<QWidget*>{search_, add, link, remove}) layout->addWidget(widget);
  layout->addStretch(1);
  return bar;
}

std::string SpecPage::currentId() const { return SpecTreeModel::idOf(tree_->currentIndex()); }

void SpecPage::rebuild() {
  const std::string before = form_->id();
  model_.rebuild();
  tree_->expandAll();
  tree_->header()->setStretchLastSection(true);
  constexpr int kWidths[] = {350, 100, 118, 100};
  for (int column = 0; column < 4; ++column) tree_->setColumnWidth(column, kWidths[column]);
  QModelIndex at = model_.indexOf(before);
  for (int group = 0; !at.isValid() && group < model_.rowCount(); ++group)
    at = model_.index(0, 0, model_.index(group, 0));
  tree_->setCurrentIndex(at);
  showCurrent();
  filter(search_->text());
}

void SpecPage::showCurrent() {
  form_->showItem(currentId());
  showLinks();
}

void SpecPage::showLinks() { links_->setHtml(linkDetails(document_, currentId(), palette())); }

void SpecPage::showItem(const std::string& id) {
  search_->clear();
  const QModelIndex place = model_.indexOf(id);
  if (!place.isValid()) return;
  tree_->setCurrentIndex(place);
  tree_->scrollTo(place);
}

void SpecPage::filter(const QString& text) { filterBranch({}, text.trimmed()); }

bool SpecPage::filterBranch(const QModelIndex& parent, const QString& words) {
  bool any = false;
  for (int row = 0; row < model_.rowCount(parent); ++row) {
    const QModelIndex index = model_.index(row, SpecTreeModel::Title, parent);
    const QString text = index.data().toString() + " " + index.data(SpecTreeModel::IdRole).toString();
    const bool below = filterBranch(index, words);
    const bool shown = below || text.contains(words, Qt::CaseInsensitive);
    tree_->setRowHidden(row, parent, !shown);
    any = any || shown;
  }
  return any;
}

void SpecPage::addItem(specs::Kind kind) {
  const std::string origin = currentId();
  const specs::Entry* entry = document_.links().find(origin);
  AnyItem item = emptyItem(kind);
  const std::string id = document_.proposeId(origin);
  std::visit([&](auto& it) { it.id = id; }, item);
  std::visit([&](auto& it) { it.title = "New " + std::string(specs::name(kind)); }, item);
  // Only where the specification allows it; else it begins on its own and says so in the tree.
  const bool follows = entry && specs::mayLink(entry->kind, kind);
  document_.addItem(std::move(item), follows ? std::vector{origin} : std::vector<std::string>{});
  showItem(id);
}

void SpecPage::linkTo() {
  const std::string from = currentId();
  const specs::Entry* entry = document_.links().find(from);
  if (!entry) return;
  QStringList choices;
  for (const AnyItem& item : itemsOf(document_.specification())) {
    if (base(item).id == from || !specs::mayLink(entry->kind, kindOf(item))) continue;
    choices << QString::fromStdString(base(item).id + "  " + base(item).title);
  }
  bool chosen = false;
  const QString choice = QInputDialog::getItem(
      this, tr("Link"), tr("What follows from %1?").arg(QString::fromStdString(from)), choices, 0, true, &chosen);
  if (chosen) guarded(this, [&] { document_.setLinked(from, choice.section(' ', 0, 0).toStdString(), true); });
}

void SpecPage::followLink(const QUrl& url) {
  const QString target = url.toString(QUrl::FullyDecoded).section(':', 1);
  const std::string from = target.section('|', 0, 0).toStdString();
  const std::string to = target.section('|', 1).toStdString();
  if (url.scheme() == "item") {
    showItem(target.toStdString());
  } else if (url.scheme() == "row") {
    emit rowRequested(target);
  } else if (url.scheme() == "result") {
    emit resultRequested(target);
  } else if (url.scheme() == "unlink") {
    document_.setLinked(from, to, false);
  } else if (url.scheme() == "reviewed") {
    document_.markReviewed(from, to);
  }
}

void SpecPage::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) showLinks();
}

}  // namespace desktop
