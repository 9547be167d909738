#pragma once

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QTextBrowser>
#include <QWidget>
#include <optional>

#include "app/desktop/cepra_view.h"
#include "cepra/scales.h"

namespace desktop {

/// The relevance tab: filter, table, the row in full, and the scale of the score under the cursor.
class CepraPage final : public QWidget {
  Q_OBJECT

 public:
  explicit CepraPage(ProjectDocument& document, QWidget* parent = nullptr);

  /// Only the rows with this node.
  void showRowsOf(const QString& node_id);
  void showRow(const std::string& key);
  [[nodiscard]] CepraView& view() { return *view_; }
  [[nodiscard]] CepraModel& model() { return model_; }
  [[nodiscard]] QHeaderView& header() { return *view_->horizontalHeader(); }

 signals:
  void nodeRequested(const QString& id);
  void itemRequested(const QString& id);

 protected:
  void changeEvent(QEvent* event) override;  ///< rich text holds colours of the palette

 private:
  QWidget* makeBar();
  QWidget* makeSide();
  void showDetails();
  void showScale();
  void followLink(const QUrl& url);
  void tellCount();
  [[nodiscard]] const cepra::Scale* currentScale() const;

  ProjectDocument& document_;
  CepraModel model_;
  CepraFilter filter_;
  std::optional<cepra::Scales> scales_;  ///< none if the resources are not there
  CepraView* view_;
  QLineEdit* search_;
  QLabel* count_;
  QComboBox* gap_;
  QLabel* message_;
  QTextBrowser* details_;
  QLabel* scale_title_;
  QListWidget* scale_;
};

}  // namespace desktop
