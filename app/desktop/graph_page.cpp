#include "app/desktop/graph_page.h"

#include <QAction>
#include <QCompleter>
#include <QDesktopServices>
#include <QEvent>
#include <QHBoxLayout>
#include <QPainter>
#include <QPixmap>
#include <QSplitter>
#include <QToolButton>
#include <QUrl>

#include "app/desktop/colours.h"
#include "app/desktop/node_details.h"
#include "app/desktop/page_parts.h"

namespace desktop {

namespace {

/// Above this many nodes the drawing begins with the effects only.
constexpr std::size_t kManyNodes = 60;
/// A new drawing is never shown smaller than this; what does not fit is scrolled to.
constexpr double kLegible = 0.6;
constexpr int kNodeRole = Qt::UserRole + 1;

QCheckBox* toggle(const QString& text, const QString& tip) {
  auto* button = new QCheckBox(text);
  button->setToolTip(tip);
  button->setAccessibleDescription(tip);
  return button;
}

bool matches(const percollect::Node& node, const QString& words) {
  if (words.isEmpty()) return false;
  if (QString::fromStdString(node.title).contains(words, Qt::CaseInsensitive)) return true;
  if (QString::fromStdString(node.id) == words) return true;
  for (const std::string& tag : node.tags) {
    if (QString::fromStdString(tag).contains(words, Qt::CaseInsensitive)) return true;
  }
  return false;
}

}  // namespace

GraphPage::GraphPage(ProjectDocument& document, QWidget* parent)
    : QWidget(parent),
      document_(document),
      scene_(new GraphScene(this)),
      view_(new GraphView),
      splitter_(new QSplitter),
      details_(textPane(tr("Details of the selected node"))),
      completions_(new QStandardItemModel(this)) {
  view_->setScene(scene_);
  view_->setAccessibleName(tr("Cause-effect graph"));
  view_->setAccessibleDescription(tr("Arrow keys go from node to node, Space folds, Escape clears the selection"));
  details_->setMinimumWidth(220);
  splitter_->setObjectName("graphSplitter");
  splitter_->addWidget(view_);
  splitter_->addWidget(details_);
  splitter_->setStretchFactor(0, 1);
  splitter_->setSizes({900, 320});
  auto* layout = seamlessColumn(this);
  layout->addWidget(makeBar());
  layout->addWidget(splitter_, 1);
  layout->addWidget(makeLegend());

  connect(&document_, &ProjectDocument::reset, this, &GraphPage::resetGraph);
  connect(&document_, &ProjectDocument::specificationChanged, this, &GraphPage::showDetails);
  connect(scene_, &GraphScene::nodeClicked, this, &GraphPage::pick);
  connect(scene_, &GraphScene::backgroundClicked, this, &GraphPage::clearSelection);
  connect(scene_, &GraphScene::foldToggled, this, &GraphPage::toggleFold);
  connect(scene_, &GraphScene::drawn, this, [this] {
    if (fit_when_drawn_) view_->fit(kLegible);
    fit_when_drawn_ = false;
    if (wanted_ && scene_->itemOf(*wanted_)) {
      scene_->select(wanted_);
      view_->reveal(scene_->itemOf(*wanted_));
    }
    wanted_.reset();
    showDetails();
    tellCount();
  });
  connect(details_, &QTextBrowser::anchorClicked, this, &GraphPage::followLink);
  resetGraph();
}

QWidget* GraphPage::makeBar() {
  auto* bar = new QWidget;
  auto* layout = new QHBoxLayout(bar);
  layout->setContentsMargins(8, 6, 8, 6);
  search_ = new QLineEdit;
  search_->setObjectName("graphSearch");
  search_->setPlaceholderText(tr("Search titles and tags"));
  search_->setAccessibleName(tr("Search in the graph"));
  search_->setClearButtonEnabled(true);
  search_->setFixedWidth(280);
  auto* completer = new QCompleter(completions_, this);
  completer->setFilterMode(Qt::MatchContains);
  completer->setCaseSensitivity(Qt::CaseInsensitive);
  completer->setMaxVisibleItems(12);
  search_->setCompleter(completer);
  hits_ = new QLabel;
  hits_->setObjectName("graphHits");
  hits_->setMinimumWidth(60);
  phenomenon_ = new QComboBox;
  phenomenon_->setObjectName("graphPhenomenon");
  phenomenon_->setAccessibleName(tr("Phenomenon whose chains are shown"));
  phenomenon_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  causes_ = toggle(tr("Causes"), tr("Show design parameters and system-independent causes, not only effects"));
  isolate_ = toggle(tr("Only its chains"), tr("Show only the chains through the selected node"));
  auto* fit_button = toolButton(tr("Fit"), tr("The whole drawing in the window"));
  auto* smaller = new QToolButton;
  smaller->setText(QString::fromUtf8("−"));
  smaller->setAccessibleName(tr("Smaller"));
  auto* larger = new QToolButton;
  larger->setText("+");
  larger->setAccessibleName(tr("Larger"));
  for (QWidget* widget : std::initializer_list<QWidget*>{search_, hits_, phenomenon_, causes_, isolate_}) {
    layout->addWidget(widget);
  }
  layout->addStretch(1);
  for (QWidget* widget : std::initializer_list<QWidget*>{smaller, larger, fit_button}) layout->addWidget(widget);

  connect(search_, &QLineEdit::textChanged, this, &GraphPage::search);
  connect(search_, &QLineEdit::returnPressed, this, [this] {
    for (std::size_t node = 0; node < document_.graph().size(); ++node) {
      if (matches(document_.graph().node(node), search_->text().trimmed())) return pick(node);
    }
  });
  connect(completer, qOverload<const QModelIndex&>(&QCompleter::activated), this,
          [this](const QModelIndex& index) { pick(index.data(kNodeRole).toULongLong()); });
  connect(phenomenon_, &QComboBox::activated, this, [this](int row) {
    filter_.phenomena.clear();
    if (row > 0) filter_.phenomena.insert(document_.graph().phenomena()[std::size_t(row - 1)]);
    fit_when_drawn_ = true;
    applyFilter();
  });
  connect(causes_, &QCheckBox::clicked, this, [this](bool on) {
    filter_.causes = on;
    filter_.revealed.clear();
    fit_when_drawn_ = true;
    applyFilter();
  });
  connect(isolate_, &QCheckBox::clicked, this, [this](bool on) {
    filter_.only_through = on ? scene_->selected() : std::nullopt;
    fit_when_drawn_ = true;
    applyFilter();
  });
  connect(fit_button, &QToolButton::clicked, this, &GraphPage::fit);
  connect(smaller, &QToolButton::clicked, this, [this] { view_->zoomBy(1 / 1.25); });
  connect(larger, &QToolButton::clicked, this, [this] { view_->zoomBy(1.25); });
  return bar;
}

QWidget* GraphPage::makeLegend() {
  auto* legend = new QWidget;
  auto* layout = new QHBoxLayout(legend);
  layout->setContentsMargins(10, 3, 10, 3);
  using percollect::NodeKind;
  for (const NodeKind kind : {NodeKind::Effect, NodeKind::DesignParameter, NodeKind::SystemIndependent}) {
    QPixmap swatch(14, 14);
    swatch.fill(colourOf(kind));
    auto* picture = new QLabel;
    picture->setPixmap(swatch);
    layout->addWidget(picture);
    layout->addWidget(new QLabel(wordFor(kind)));
    layout->addSpacing(14);
  }
  layout->addWidget(new QLabel(tr("Arrows: cause → effect")));
  layout->addStretch(1);
  count_ = new QLabel;
  layout->addWidget(count_);
  return legend;
}

void GraphPage::resetGraph() {
  const percollect::Graph& graph = document_.graph();
  scene_->forget();
  filter_ = {.causes = graph.size() <= kManyNodes};
  causes_->setChecked(filter_.causes);
  isolate_->setChecked(false);
  search_->clear();
  phenomenon_->clear();
  phenomenon_->addItem(tr("All phenomena"));
  for (const std::size_t node : graph.phenomena()) phenomenon_->addItem(QString::fromStdString(graph.node(node).title));
  fillSearch();
  fit_when_drawn_ = true;
  applyFilter();
}

void GraphPage::fillSearch() {
  completions_->clear();
  const percollect::Graph& graph = document_.graph();
  for (std::size_t node = 0; node < graph.size(); ++node) {
    QStringList words{QString::fromStdString(graph.node(node).title)};
    for (const std::string& tag : graph.node(node).tags) words << QString::fromStdString(tag);
    auto* item = new QStandardItem(words.join(" · "));
    item->setData(qulonglong(node), kNodeRole);
    completions_->appendRow(item);
  }
}

void GraphPage::applyFilter() {
  isolate_->setEnabled(filter_.only_through || scene_->selected());
  scene_->show(document_.graph(), filter_);
}

void GraphPage::search(const QString& text) {
  std::set<std::size_t> found;
  const QString words = text.trimmed();
  for (std::size_t node = 0; node < document_.graph().size(); ++node) {
    if (matches(document_.graph().node(node), words)) found.insert(node);
  }
  hits_->setText(words.isEmpty() ? QString() : found.size() == 1 ? tr("1 hit") : tr("%1 hits").arg(found.size()));
  if (!words.isEmpty()) scene_->select(std::nullopt);
  scene_->markHits(found);
  showDetails();
}

void GraphPage::pick(std::size_t node) {
  const GraphFilter before = filter_;
  scene_->markHits({});
  reveal(document_.graph(), node, filter_);
  causes_->setChecked(filter_.causes);
  if (!filter_.only_through) isolate_->setChecked(false);
  if (filter_.phenomena.empty()) phenomenon_->setCurrentIndex(0);
  if (scene_->itemOf(node)) {
    scene_->select(node);
    view_->reveal(scene_->itemOf(node));
    showDetails();
    isolate_->setEnabled(true);
    return;
  }
  wanted_ = node;
  applyFilter();
  isolate_->setEnabled(true);
}

void GraphPage::clearSelection() {
  scene_->markHits({});
  scene_->select(std::nullopt);
  isolate_->setEnabled(filter_.only_through.has_value());
  showDetails();
}

void GraphPage::toggleFold(std::size_t node) {
  const NodeItem* item = scene_->itemOf(node);
  if (!item || document_.graph().children(node).empty()) return;
  const VisibleGraph part = visiblePart(document_.graph(), filter_);
  const auto at = std::ranges::find(part.nodes, node) - part.nodes.begin();
  const bool some_hidden = part.hidden[std::size_t(at)] > 0;
  if (some_hidden) {
    filter_.folded.erase(node);
    for (const std::size_t child : document_.graph().children(node)) filter_.revealed.insert(child);
  } else {
    filter_.folded.insert(node);
  }
  wanted_ = scene_->selected();
  applyFilter();
}

void GraphPage::showNode(const std::string& id) {
  if (const auto node = document_.graph().find(id)) pick(*node);
}

void GraphPage::showDetails() {
  const auto node = scene_->selected();
  const QString page = node ? nodeDetails(document_, *node, palette()) : graphDetails(document_, palette());
  details_->setHtml(page);
}

void GraphPage::followLink(const QUrl& url) {
  const QString target = url.toString().section(':', 1);
  if (url.scheme() == "node") {
    showNode(target.toStdString());
  } else if (url.scheme() == "rows") {
    emit rowsRequested(target);
  } else if (url.scheme() == "item") {
    emit itemRequested(target);
  } else {
    QDesktopServices::openUrl(url);
  }
}

void GraphPage::tellCount() {
  count_->setText(tr("%1 of %2 nodes shown").arg(scene_->nodesShown()).arg(document_.graph().size()));
}

void GraphPage::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) showDetails();
}

}  // namespace desktop
