#pragma once

#include <QAbstractTableModel>
#include <QSortFilterProxyModel>
#include <QStringList>
#include <optional>
#include <string>

#include "app/desktop/project_document.h"
#include "app/desktop/tsv.h"

namespace desktop {

/// The relevance table for a view: one row a row. Every change goes through the document's undo stack.
class CepraModel final : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column {
    Phenomenon,
    EffectPath,
    DesignParameters,
    SystemIndependent,
    Occurrence,
    Impact,
    Relevance,
    OccurrenceWhy,
    OccurrenceExpert,
    ImpactWhy,
    ImpactExpert,
    Notes,
    ColumnCount
  };
  enum Role { SortRole = Qt::UserRole + 1, SearchRole, RowRole };

  explicit CepraModel(ProjectDocument& document, QObject* parent = nullptr);

  [[nodiscard]] static bool isScore(int column) { return column == Occurrence || column == Impact; }
  [[nodiscard]] static bool isEditable(int column);
  [[nodiscard]] const cepra::Row& row(int row) const;

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;
  /// A score that is none is refused: false, and rejected() says why.
  bool setData(const QModelIndex& index, const QVariant& value, int role = Qt::EditRole) override;

  /// A new text for a cell, or for many at once: one undo step. Cells that do not take their text keep what they have
  /// and are named by rejected(). Returns how many cells took theirs.
  struct CellText {
    QModelIndex cell;
    std::string text;
  };
  int setTexts(const std::vector<CellText>& cells, const QString& what);
  [[nodiscard]] std::string textOf(const QModelIndex& index) const;

 signals:
  void rejected(const QString& text);

 private:
  [[nodiscard]] QVariant decoration(const cepra::Row& row, int column) const;
  [[nodiscard]] QString toolTip(const cepra::Row& row, const QModelIndex& index) const;
  [[nodiscard]] QString searchText(const cepra::Row& row) const;

  ProjectDocument& document_;
};

/// Rows that hold all words of the filter, sorted by numbers as numbers.
///
///   fog range     rows with both words anywhere in their texts
///   node:87       rows with this node on their path or among their causes
///   unscored, suspect, unlinked   words of the box beside it (setGap)
class CepraFilter final : public QSortFilterProxyModel {
  Q_OBJECT

 public:
  enum class Gap { None, Unscored, Suspect, RelevantWithoutRequirement };

  explicit CepraFilter(ProjectDocument& document, QObject* parent = nullptr);
  void setWords(const QString& text);
  void setGap(Gap gap);

 protected:
  [[nodiscard]] bool filterAcceptsRow(int row, const QModelIndex& parent) const override;

 private:
  [[nodiscard]] bool inGap(const cepra::Row& row) const;

  ProjectDocument& document_;
  QStringList words_;
  QString node_;
  Gap gap_ = Gap::None;
};

}  // namespace desktop
