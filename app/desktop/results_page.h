#pragma once

#include <QLabel>
#include <QTableView>
#include <QTableWidget>
#include <QWidget>
#include <functional>

#include "app/desktop/page_parts.h"
#include "app/desktop/results_model.h"
#include "app/desktop/shown_result.h"
#include "app/desktop/svg_view.h"
#include "app/desktop/test_runner.h"

namespace desktop {

/// The results tab: acceptance tests with their last verdicts, runs in the background, numbers and plots of a result.
class ResultsPage final : public QWidget {
  Q_OBJECT

 public:
  /// `save` makes the file hold what the window shows (a run reads the file); false: the person does not want to.
  ResultsPage(ProjectDocument& document, std::function<bool()> save, QWidget* parent = nullptr);

  void showTest(const std::string& id);
  void runAll() { run({}); }
  void runSelected();
  void cancel() { runner_.cancel(); }
  [[nodiscard]] TestRunner& runner() { return runner_; }
  [[nodiscard]] QTableWidget& numbers() { return *numbers_; }
  [[nodiscard]] SvgView& plot() { return *plot_; }
  [[nodiscard]] QTableView& tests() { return *tests_; }

 private:
  QWidget* makeBar();
  QWidget* makeSide();
  void run(const std::vector<std::string>& tests);
  void store(const acceptance::RunResult& result);
  /// The report's file, or nothing after an error was shown: a verdict counts without its report too.
  [[nodiscard]] std::filesystem::path writeReport(const acceptance::RunResult& result);
  void showResult();
  void fillNumbers();
  void showPlot();
  void openReport();
  [[nodiscard]] std::string currentTest() const;

  ProjectDocument& document_;
  std::function<bool()> save_;
  ResultsModel model_;
  TestRunner runner_;
  std::filesystem::path running_on_;  ///< a run's verdicts belong to this project, whatever is open when it ends
  std::string started_at_;
  ShownResult shown_;
  std::filesystem::path report_;
  QTableView* tests_;
  QTableWidget* numbers_;
  SvgView* plot_;
  QLabel* headline_;
  WorkStatus* status_;
  QToolButton* run_selected_;
  QToolButton* run_all_;
  QToolButton* open_report_;
};

}  // namespace desktop
