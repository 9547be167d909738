#pragma once

#include <QComboBox>
#include <functional>
#include <optional>

#include "app/desktop/diagnosis/diagnosis_runner.h"
#include "app/desktop/diagnosis/proposals_panel.h"
#include "app/desktop/page_parts.h"

namespace desktop {

/// The diagnosis tab: a gap report, opened or made here in the background, and what it proposes for the project.
class DiagnosisPage final : public QWidget {
  Q_OBJECT

 public:
  /// `save` makes the file hold what the window shows (the threads read it); false: the person does not want to.
  DiagnosisPage(ProjectDocument& document, std::function<bool()> save, QWidget* parent = nullptr);

  /// Shows an error and returns false if it is no gap report.
  bool openReport(const std::filesystem::path& file);
  void diagnose();  ///< of the chosen experiment and model
  void propose();   ///< from the open report
  void cancel() { runner_.cancel(); }
  [[nodiscard]] DiagnosisRunner& runner() { return runner_; }
  [[nodiscard]] ProposalsPanel& proposals() { return *panel_; }
  [[nodiscard]] QTextBrowser& text() { return *text_; }
  [[nodiscard]] QComboBox& experiments() { return *experiments_; }
  [[nodiscard]] QComboBox& models() { return *models_; }
  [[nodiscard]] QComboBox& proxies() { return *proxies_; }

 signals:
  void rowRequested(const QString& key);
  void itemRequested(const QString& id);
  void testRequested(const QString& id);

 protected:
  void changeEvent(QEvent* event) override;  ///< rich text holds colours of the palette

 private:
  QWidget* makeBar();
  void connectRunner();
  void offerFilesOfProject();
  void chooseFrom(QComboBox* list, const QString& title, const QString& filter);
  /// Only a model that is a command or a recording needs a proxy.
  void showProxies();
  void askAndOpen();
  void showReport();
  void showText();
  void enableButtons();
  void store(const proposals::Proposed& proposed);

  ProjectDocument& document_;
  std::function<bool()> save_;
  DiagnosisRunner runner_;
  std::filesystem::path running_on_;  ///< what comes out belongs to this project, whatever is open when it ends
  std::optional<proposals::GapReport> report_;
  QComboBox* experiments_;
  QComboBox* models_;
  QLabel* proxy_label_;
  QComboBox* proxies_;
  QToolButton* open_;
  QToolButton* diagnose_;
  QToolButton* propose_;
  WorkStatus* status_;
  QTextBrowser* text_;
  ProposalsPanel* panel_;
};

}  // namespace desktop
