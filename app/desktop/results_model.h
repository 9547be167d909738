#pragma once

#include <QAbstractTableModel>

#include "app/desktop/project_document.h"

namespace desktop {

/// Acceptance tests with their newest verdicts, one a row.
class ResultsModel final : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { Title, Verdict, Why, Id, ColumnCount };

  explicit ResultsModel(ProjectDocument& document, QObject* parent = nullptr);

  [[nodiscard]] std::string idOf(int row) const;
  [[nodiscard]] QModelIndex indexOf(const std::string& id) const;
  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  ProjectDocument& document_;
};

}  // namespace desktop
