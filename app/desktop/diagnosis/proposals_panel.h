#pragma once

#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QTextBrowser>
#include <QWidget>

#include "app/desktop/project_document.h"

namespace desktop {

/// What diagnoses propose for the project, one a row, with its evidence; a person accepts or dismisses. Every decision
/// is one undo step.
class ProposalsPanel final : public QWidget {
  Q_OBJECT

 public:
  explicit ProposalsPanel(ProjectDocument& document, QWidget* parent = nullptr);

  /// Only those of one report; "": all of the project.
  void showEvidence(const std::string& evidence);
  /// Asks first if the row has changed since.
  void acceptCurrent();
  /// Asks for the reason.
  void askAndDismissCurrent();
  void dismissCurrent(const QString& reason);  ///< shows what is wrong, if anything
  [[nodiscard]] QTableWidget& table() { return *table_; }
  [[nodiscard]] QTextBrowser& details() { return *details_; }

 signals:
  void rowRequested(const QString& key);
  void itemRequested(const QString& id);

 protected:
  void changeEvent(QEvent* event) override;  ///< rich text holds colours of the palette

 private:
  void fill();
  void showDetails();
  void showRow();
  void followLink(const QUrl& url);
  [[nodiscard]] const specs::Proposal* current() const;

  ProjectDocument& document_;
  std::string evidence_;
  QLabel* count_;
  QTableWidget* table_;
  QTextBrowser* details_;
  QPushButton* accept_;
  QPushButton* dismiss_;
  QPushButton* show_row_;
};

}  // namespace desktop
