#include "app/desktop/spec_tree_model.h"

#include <QApplication>
#include <QFont>
#include <QFontMetrics>
#include <algorithm>

#include "app/desktop/colours.h"

namespace desktop {

namespace {

/// How much a verdict asks for attention: what a requirement shows of its tests.
int gravity(specs::Verdict verdict) {
  switch (verdict) {
    case specs::Verdict::Failed:
      return 3;
    case specs::Verdict::Error:
      return 2;
    case specs::Verdict::Skipped:
      return 1;
    case specs::Verdict::Passed:
      return 0;
  }
  return 0;
}

/// Room above and below the line.
QSize rowSize() { return {0, QFontMetrics(QApplication::font()).lineSpacing() + 7}; }

QString shortWord(specs::Kind kind) {
  switch (kind) {
    case specs::Kind::AcceptanceTest:
      return QObject::tr("test");
    case specs::Kind::ExperimentData:
      return QObject::tr("experiment");
    case specs::Kind::ReferenceData:
      return QObject::tr("reference");
    default:
      return QObject::tr("requirement");
  }
}

QString word(specs::Kind kind) {
  QString text = wordFor(kind);
  text[0] = text[0].toUpper();
  return text;
}

}  // namespace

SpecTreeModel::SpecTreeModel(ProjectDocument& document, QObject* parent)
    : QStandardItemModel(parent), document_(document) {
  rebuild();
}

QModelIndex SpecTreeModel::indexOf(const std::string& id) const {
  const auto found = match(index(0, 0), IdRole, QString::fromStdString(id), 1, Qt::MatchExactly | Qt::MatchRecursive);
  return found.isEmpty() ? QModelIndex() : found.first();
}

std::string SpecTreeModel::idOf(const QModelIndex& index) {
  return index.siblingAtColumn(Title).data(IdRole).toString().toStdString();
}

void SpecTreeModel::rebuild() {
  clear();
  setHorizontalHeaderLabels({tr("Title"), tr("Kind"), tr("Status"), tr("Last verdict"), tr("Id")});
  const specs::Specification& all = document_.specification();
  for (const auto& [level, title] : {std::pair(specs::Level::General, tr("General requirements")),
                                     std::pair(specs::Level::ObjectModel, tr("Object-model requirements")),
                                     std::pair(specs::Level::DetectionModel, tr("Detection-model requirements"))}) {
    QStandardItem* group = addGroup(title);
    for (const specs::Requirement& requirement : all.requirements) {
      if (requirement.level == level) addBranch(*group, requirement.id, 0);
    }
  }
  QStandardItem* loose = nullptr;
  for (const AnyItem& item : itemsOf(all)) {
    const std::string& id = base(item).id;
    if (kindOf(item) == specs::Kind::Requirement || !document_.links().originsOf(id).empty()) continue;
    if (!loose) loose = addGroup(tr("Not linked to any requirement"));
    addBranch(*loose, id, 0);
  }
}

QStandardItem* SpecTreeModel::addGroup(const QString& title) {
  auto* group = new QStandardItem(title);
  QFont bold = group->font();
  bold.setBold(true);
  group->setFont(bold);
  group->setEditable(false);
  group->setSizeHint(rowSize());
  appendRow(group);
  return group;
}

void SpecTreeModel::addBranch(QStandardItem& parent, const std::string& id, int depth) {
  const QList<QStandardItem*> cells = cellsFor(id);
  parent.appendRow(cells);
  if (depth > 8) return;  // links close no circle; this only bounds a damaged file
  for (const specs::Link& link : document_.links().followersOf(id)) {
    const specs::Entry* follower = document_.links().find(link.to);
    // A refining requirement stands under its own level; the pane of links leads there.
    if (follower && follower->kind != specs::Kind::Requirement) addBranch(*cells[0], link.to, depth + 1);
  }
}

QList<QStandardItem*> SpecTreeModel::cellsFor(const std::string& id) const {
  QList<QStandardItem*> cells;
  for (int column = 0; column < ColumnCount; ++column) {
    cells << new QStandardItem;
    cells.back()->setEditable(false);
    cells.back()->setSizeHint(rowSize());
  }
  cells[Title]->setData(QString::fromStdString(id), IdRole);
  fill(cells, id);
  return cells;
}

void SpecTreeModel::fill(const QList<QStandardItem*>& cells, const std::string& id) const {
  const auto item = document_.item(id);
  if (!item) return;
  const specs::Item& content = base(*item);
  const QString title = content.title.empty() ? tr("(no title)") : QString::fromStdString(content.title);
  cells[Title]->setText(title);
  cells[Title]->setToolTip(word(kindOf(*item)) + ": " + title);
  cells[Title]->setData(word(kindOf(*item)) + ", " + title, Qt::AccessibleTextRole);
  cells[What]->setText(shortWord(kindOf(*item)));
  cells[Status]->setText(wordFor(content.status));
  cells[Status]->setIcon(iconOf(content.status));
  const auto verdict = verdictOf(id);
  cells[LastVerdict]->setText(verdict ? wordFor(*verdict) : QString());
  cells[LastVerdict]->setIcon(verdict ? iconOf(*verdict) : QIcon());
  cells[Id]->setText(QString::fromStdString(content.id));
}

std::optional<specs::Verdict> SpecTreeModel::verdictOf(const std::string& id) const {
  const auto& verdicts = document_.specification().verdicts;
  if (const auto own = verdicts.find(id); own != verdicts.end()) return own->second.verdict;
  const auto item = document_.item(id);
  if (!item || kindOf(*item) != specs::Kind::Requirement) return std::nullopt;
  std::optional<specs::Verdict> worst;
  for (const specs::Link& link : document_.links().followersOf(id)) {
    const auto found = verdicts.find(link.to);
    if (found == verdicts.end()) continue;
    if (!worst || gravity(found->second.verdict) > gravity(*worst)) worst = found->second.verdict;
  }
  return worst;
}

void SpecTreeModel::refresh(const std::string& id) {
  const auto places = match(index(0, 0), IdRole, QString::fromStdString(id), -1, Qt::MatchExactly | Qt::MatchRecursive);
  for (const QModelIndex& place : places) {
    QList<QStandardItem*> cells;
    for (int column = 0; column < ColumnCount; ++column) cells << itemFromIndex(place.siblingAtColumn(column));
    fill(cells, id);
  }
}

}  // namespace desktop
