#include "app/desktop/cepra_model.h"

#include <QApplication>
#include <QBrush>
#include <QFont>
#include <algorithm>
#include <map>

#include "app/desktop/colours.h"
#include "core/text.h"
#include "specs/rules.h"

namespace desktop {

namespace {

constexpr int kLargestScore = 10;
constexpr int kLargestRelevance = 20;

QString titles(const std::vector<cepra::Cause>& causes) {
  QStringList list;
  for (const cepra::Cause& cause : causes) list << QString::fromStdString(cause.title);
  return list.join("; ");
}

/// The path without its phenomenon, last effect first: the end is what tells rows apart.
QString pathText(const cepra::Row& row) {
  QStringList list;
  for (std::size_t i = 1; i < row.effects.size(); ++i) list.prepend(QString::fromStdString(row.effects[i].title));
  if (list.isEmpty()) list << QObject::tr("(directly)");
  return list.join(QString::fromUtf8(" → "));
}

std::string* textField(cepra::Row& row, int column) {
  switch (column) {
    case CepraModel::OccurrenceWhy:
      return &row.occurrence.rationale;
    case CepraModel::OccurrenceExpert:
      return &row.occurrence.expert;
    case CepraModel::ImpactWhy:
      return &row.impact.rationale;
    case CepraModel::ImpactExpert:
      return &row.impact.expert;
    case CepraModel::Notes:
      return &row.notes;
    default:
      return nullptr;
  }
}

/// Returns what is wrong with the text, or "" if the row took it.
QString put(cepra::Row& row, int column, const std::string& text) {
  if (std::string* field = textField(row, column)) {
    *field = text;
    return {};
  }
  std::optional<int>& score = column == CepraModel::Occurrence ? row.occurrence.value : row.impact.value;
  const std::string digits = core::trimmed(text);
  double value = 0.0;
  if (digits.empty()) {
    score.reset();
    return {};
  }
  if (!core::parseNumber(digits, value) || value != int(value) || value < 1 || value > kLargestScore) {
    return QObject::tr("'%1' is no score: whole numbers from 1 to 10 are, or nothing.")
        .arg(QString::fromStdString(text));
  }
  score = int(value);
  return {};
}

std::optional<int> numberIn(const cepra::Row& row, int column) {
  if (column == CepraModel::Occurrence) return row.occurrence.value;
  if (column == CepraModel::Impact) return row.impact.value;
  if (column == CepraModel::Relevance) return row.relevance();
  return std::nullopt;
}

QString scoreText(const std::optional<int>& score) { return score ? QString::number(*score) : QString(); }

}  // namespace

CepraModel::CepraModel(ProjectDocument& document, QObject* parent) : QAbstractTableModel(parent), document_(document) {
  connect(&document_, &ProjectDocument::reset, this, [this] {
    beginResetModel();
    endResetModel();
  });
  connect(&document_, &ProjectDocument::rowsChanged, this, [this](const std::vector<std::size_t>& rows) {
    for (const std::size_t row : rows) emit dataChanged(index(int(row), 0), index(int(row), ColumnCount - 1));
  });
}

bool CepraModel::isEditable(int column) { return column >= Occurrence && column < ColumnCount && column != Relevance; }

const cepra::Row& CepraModel::row(int row) const { return document_.table().rows.at(std::size_t(row)); }

int CepraModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : int(document_.table().rows.size());
}

int CepraModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : ColumnCount; }

std::string CepraModel::textOf(const QModelIndex& index) const {
  const cepra::Row& row = this->row(index.row());
  switch (index.column()) {
    case Phenomenon:
      return row.phenomenon().title;
    case EffectPath:
      return pathText(row).toStdString();
    case DesignParameters:
      return titles(row.causesOfKind(percollect::NodeKind::DesignParameter)).toStdString();
    case SystemIndependent:
      return titles(row.causesOfKind(percollect::NodeKind::SystemIndependent)).toStdString();
    case Occurrence:
      return scoreText(row.occurrence.value).toStdString();
    case Impact:
      return scoreText(row.impact.value).toStdString();
    case Relevance:
      return scoreText(row.relevance()).toStdString();
    default:
      break;
  }
  cepra::Row copy = row;
  const std::string* field = textField(copy, index.column());
  return field ? *field : std::string();
}

QVariant CepraModel::decoration(const cepra::Row& row, int column) const {
  return column == Phenomenon && (row.isSuspect() || row.gone) ? QVariant(warningIcon()) : QVariant();
}

QString CepraModel::toolTip(const cepra::Row& row, const QModelIndex& index) const {
  if (index.column() == Phenomenon && row.isSuspect())
    return tr("Suspect: %1").arg(QString::fromStdString(row.suspect));
  return QString::fromStdString(textOf(index));
}

QString CepraModel::searchText(const cepra::Row& row) const {
  QStringList all;
  for (const cepra::Effect& effect : row.effects) all << QString::fromStdString(effect.title);
  all << titles(row.causes);
  for (const std::string* text : {&row.occurrence.rationale, &row.occurrence.expert, &row.impact.rationale,
                                  &row.impact.expert, &row.notes, &row.suspect, &row.key}) {
    all << QString::fromStdString(*text);
  }
  return all.join('\n');
}

QVariant CepraModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const cepra::Row& row = this->row(index.row());
  const int column = index.column();
  const bool number = isScore(column) || column == Relevance;
  const std::optional<int> value = numberIn(row, column);
  switch (role) {
    case Qt::DisplayRole:
    case Qt::EditRole:
      return QString::fromStdString(textOf(index));
    case Qt::ToolTipRole:
      return toolTip(row, index);
    case Qt::DecorationRole:
      return decoration(row, column);
    case Qt::TextAlignmentRole:
      return int(number ? Qt::AlignCenter : Qt::AlignLeft | Qt::AlignVCenter);
    case Qt::BackgroundRole:
      return value ? QVariant(weightColour(QApplication::palette(), *value,
                                           column == Relevance ? kLargestRelevance : kLargestScore))
                   : QVariant();
    case Qt::FontRole: {
      QFont font;
      font.setBold(number);
      return font;
    }
    case Qt::AccessibleTextRole:
      return number ? headerData(column, Qt::Horizontal, Qt::ToolTipRole).toString() + " " +
                          (value ? QString::number(*value) : tr("not given"))
                    : QVariant(QString::fromStdString(textOf(index)));
    case SortRole:
      return number ? QVariant(value.value_or(-1)) : QVariant(QString::fromStdString(textOf(index)));
    case SearchRole:
      return searchText(row);
    case RowRole:
      return index.row();
    default:
      return {};
  }
}

QVariant CepraModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation == Qt::Vertical) return role == Qt::DisplayRole ? QVariant(section + 1) : QVariant();
  static const QStringList kTitles = {tr("Phenomenon"),
                                      tr("Effect path"),
                                      tr("Design parameters"),
                                      tr("System-independent causes"),
                                      tr("O"),
                                      tr("I"),
                                      tr("O+I"),
                                      tr("Why (occurrence)"),
                                      tr("Expert (O)"),
                                      tr("Why (impact)"),
                                      tr("Expert (I)"),
                                      tr("Notes")};
  static const std::map<int, QString> kTips = {{Occurrence, tr("Occurrence, 1 to 10")},
                                               {OccurrenceExpert, tr("Who scored the occurrence")},
                                               {Impact, tr("Impact, 1 to 10")},
                                               {ImpactExpert, tr("Who scored the impact")},
                                               {Relevance, tr("Relevance: occurrence plus impact, 2 to 20")}};
  if (role == Qt::DisplayRole) return kTitles.value(section);
  if (role == Qt::ToolTipRole) return kTips.contains(section) ? kTips.at(section) : kTitles.value(section);
  return {};
}

Qt::ItemFlags CepraModel::flags(const QModelIndex& index) const {
  Qt::ItemFlags flags = QAbstractTableModel::flags(index);
  if (isEditable(index.column()) && !document_.readOnly()) flags |= Qt::ItemIsEditable;
  return flags;
}

bool CepraModel::setData(const QModelIndex& index, const QVariant& value, int role) {
  if (role != Qt::EditRole || !isEditable(index.column())) return false;
  const QString what = tr("set %1").arg(
      headerData(index.column(), Qt::Horizontal, Qt::ToolTipRole).toString().section(',', 0, 0).toLower());
  return setTexts({{index, value.toString().toStdString()}}, what) == 1;
}

int CepraModel::setTexts(const std::vector<CellText>& cells, const QString& what) {
  std::map<std::size_t, cepra::Row> changed;
  QStringList problems;
  int taken = 0;
  for (const CellText& cell : cells) {
    const auto number = std::size_t(cell.cell.row());
    if (!isEditable(cell.cell.column())) continue;
    cepra::Row& row = changed.try_emplace(number, document_.table().rows.at(number)).first->second;
    const QString problem = put(row, cell.cell.column(), cell.text);
    if (problem.isEmpty()) {
      ++taken;
    } else {
      problems << tr("Row %1, %2: %3")
                      .arg(number + 1)
                      .arg(headerData(cell.cell.column(), Qt::Horizontal, Qt::DisplayRole).toString(), problem);
    }
  }
  std::vector<RowChange> changes;
  for (auto& [number, row] : changed) changes.push_back({number, document_.table().rows.at(number), std::move(row)});
  document_.editRows(std::move(changes), what);
  if (!problems.isEmpty()) emit rejected(problems.join('\n'));
  return taken;
}

CepraFilter::CepraFilter(ProjectDocument& document, QObject* parent)
    : QSortFilterProxyModel(parent), document_(document) {
  setSortRole(CepraModel::SortRole);
  setSortCaseSensitivity(Qt::CaseInsensitive);
  setDynamicSortFilter(false);  // a row must not jump away from under the hands while it is scored
}

void CepraFilter::setWords(const QString& text) {
  words_ = text.split(' ', Qt::SkipEmptyParts);
  node_.clear();
  for (const QString& word : words_) {
    if (word.startsWith("node:")) node_ = word.mid(5);
  }
  words_.removeIf([](const QString& word) { return word.startsWith("node:"); });
  invalidateFilter();
}

void CepraFilter::setGap(Gap gap) {
  gap_ = gap;
  invalidateFilter();
}

bool CepraFilter::inGap(const cepra::Row& row) const {
  switch (gap_) {
    case Gap::Unscored:
      return !row.isScored();
    case Gap::Suspect:
      return row.isSuspect();
    case Gap::RelevantWithoutRequirement:
      return row.relevance().value_or(0) >= specs::RuleOptions{}.relevant_from &&
             document_.requirementsOf(row.key).empty();
    case Gap::None:
      return true;
  }
  return true;
}

bool CepraFilter::filterAcceptsRow(int number, const QModelIndex& parent) const {
  const cepra::Row& row = document_.table().rows.at(std::size_t(number));
  if (!inGap(row)) return false;
  if (!node_.isEmpty()) {
    const auto is_node = [&](const auto& node) { return QString::fromStdString(node.id) == node_; };
    if (!std::ranges::any_of(row.effects, is_node) && !std::ranges::any_of(row.causes, is_node)) return false;
  }
  if (words_.isEmpty()) return true;
  const QString text = sourceModel()->index(number, 0, parent).data(CepraModel::SearchRole).toString();
  return std::ranges::all_of(words_, [&](const QString& word) { return text.contains(word, Qt::CaseInsensitive); });
}

}  // namespace desktop
