#pragma once

#include <QModelIndex>
#include <QStandardItemModel>
#include <string>

#include "app/desktop/project_document.h"

namespace desktop {

/// The specification as a tree, in the order in which it is read:
///
///   Level > requirement > acceptance test > experiment and reference data requirement
///
/// An item that follows from two others stands under both. Last come items that follow from nothing.
class SpecTreeModel final : public QStandardItemModel {
  Q_OBJECT

 public:
  enum Column { Title, What, Status, LastVerdict, Id, ColumnCount };
  enum Role { IdRole = Qt::UserRole + 1 };

  explicit SpecTreeModel(ProjectDocument& document, QObject* parent = nullptr);

  /// The first place of an item.
  [[nodiscard]] QModelIndex indexOf(const std::string& id) const;
  [[nodiscard]] static std::string idOf(const QModelIndex& index);

  void rebuild();
  /// Title and status of an item, wherever it stands.
  void refresh(const std::string& id);

 private:
  QStandardItem* addGroup(const QString& title);
  void addBranch(QStandardItem& parent, const std::string& id, int depth);
  [[nodiscard]] QList<QStandardItem*> cellsFor(const std::string& id) const;
  void fill(const QList<QStandardItem*>& cells, const std::string& id) const;
  [[nodiscard]] std::optional<specs::Verdict> verdictOf(const std::string& id) const;

  ProjectDocument& document_;
};

}  // namespace desktop
