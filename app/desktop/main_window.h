#pragma once

#include <QLabel>
#include <QMainWindow>
#include <QSettings>
#include <QStackedWidget>
#include <QTabWidget>
#include <filesystem>

#include "app/desktop/project_document.h"

class QMenu;

namespace desktop {

class CepraPage;
class CloudPage;
class DiagnosisPage;
class GraphPage;
class ResultsPage;
class SpecPage;
class StartPage;

/// The window: one project, a tab for each view. Knows files and menus; what a tab shows is the tab's business.
class MainWindow final : public QMainWindow {
  Q_OBJECT

 public:
  explicit MainWindow(QSettings& settings, QWidget* parent = nullptr);
  ~MainWindow() override;

  enum Tab { Graph, Relevance, Specification, Results, Diagnosis, Cloud, TabCount };

  /// Shows an error and returns false if the file cannot be opened.
  bool openProject(const std::filesystem::path& file);
  bool save();
  void showTab(Tab tab);

  [[nodiscard]] ProjectDocument& document() noexcept { return document_; }
  [[nodiscard]] GraphPage& graphPage() noexcept { return *graph_; }
  [[nodiscard]] CepraPage& cepraPage() noexcept { return *cepra_; }
  [[nodiscard]] SpecPage& specPage() noexcept { return *spec_; }
  [[nodiscard]] ResultsPage& resultsPage() noexcept { return *results_; }
  [[nodiscard]] DiagnosisPage& diagnosisPage() noexcept { return *diagnosis_; }
  [[nodiscard]] CloudPage& cloudPage() noexcept { return *cloud_; }

 protected:
  void closeEvent(QCloseEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  void makeTabs();
  void makeMenus();
  void makeFileMenu();
  void makeEditMenu();
  void makeViewMenu();
  void makeTestMenu();
  void makeHelpMenu();
  void connectPages();
  void askAndOpen();
  void askAndCreate();
  void askAndExport(std::size_t format);
  bool maySwitchProject();
  void fillRecentMenu();
  void projectChanged();
  void setDark(bool dark);
  void saveLayout();
  void restoreLayout();
  void about();

  QSettings& settings_;
  ProjectDocument document_;
  QStackedWidget* stack_;
  StartPage* start_;
  QTabWidget* tabs_;
  GraphPage* graph_;
  CepraPage* cepra_;
  SpecPage* spec_;
  ResultsPage* results_;
  DiagnosisPage* diagnosis_;
  CloudPage* cloud_;
  QLabel* place_;
  QMenu* recent_menu_ = nullptr;
  QList<QAction*> needs_project_;
};

}  // namespace desktop
