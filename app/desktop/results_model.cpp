#include "app/desktop/results_model.h"

#include "app/desktop/colours.h"

namespace desktop {

ResultsModel::ResultsModel(ProjectDocument& document, QObject* parent)
    : QAbstractTableModel(parent), document_(document) {
  const auto again = [this] {
    beginResetModel();
    endResetModel();
  };
  connect(&document_, &ProjectDocument::reset, this, again);
  connect(&document_, &ProjectDocument::specificationChanged, this, again);
  const auto update = [this] {
    if (rowCount() > 0) emit dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1));
  };
  connect(&document_, &ProjectDocument::verdictsChanged, this, update);
  connect(&document_, &ProjectDocument::itemEdited, this, update);
}

std::string ResultsModel::idOf(int row) const { return document_.specification().tests.at(std::size_t(row)).id; }

QModelIndex ResultsModel::indexOf(const std::string& id) const {
  for (int row = 0; row < rowCount(); ++row) {
    if (idOf(row) == id) return index(row, 0);
  }
  return {};
}

int ResultsModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : int(document_.specification().tests.size());
}

int ResultsModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : ColumnCount; }

QVariant ResultsModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const specs::AcceptanceTest& test = document_.specification().tests.at(std::size_t(index.row()));
  const auto found = document_.specification().verdicts.find(test.id);
  const bool ran = found != document_.specification().verdicts.end();
  if (role == Qt::DecorationRole) {
    return index.column() == Verdict && ran ? QVariant(iconOf(found->second.verdict)) : QVariant();
  }
  if (role != Qt::DisplayRole && role != Qt::ToolTipRole) return {};
  switch (index.column()) {
    case Title:
      return QString::fromStdString(test.title);
    case Verdict:
      return ran ? wordFor(found->second.verdict) : tr("not run");
    case Why:
      return ran ? QString::fromStdString(found->second.text) : QString();
    case Id:
      return QString::fromStdString(test.id);
    default:
      return {};
  }
}

QVariant ResultsModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (role != Qt::DisplayRole || orientation == Qt::Vertical) return {};
  return QStringList{tr("Acceptance test"), tr("Verdict"), tr("Why"), tr("Id")}.value(section);
}

}  // namespace desktop
