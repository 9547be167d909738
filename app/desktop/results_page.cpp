#include "app/desktop/results_page.h"

#include <QDesktopServices>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QSplitter>
#include <QUrl>
#include <QVBoxLayout>

#include "acceptance/html_report.h"
#include "acceptance/run.h"
#include "app/cli/signature.h"
#include "app/desktop/colours.h"
#include "app/desktop/error_dialog.h"
#include "core/file.h"

namespace desktop {

ResultsPage::ResultsPage(ProjectDocument& document, std::function<bool()> save, QWidget* parent)
    : QWidget(parent), document_(document), save_(std::move(save)), model_(document), tests_(new QTableView) {
  tests_->setModel(&model_);
  tests_->setAccessibleName(tr("Acceptance tests"));
  tests_->setSelectionBehavior(QAbstractItemView::SelectRows);
  tests_->setAlternatingRowColors(true);
  tests_->setWordWrap(true);
  tests_->verticalHeader()->hide();
  tests_->verticalHeader()->setDefaultSectionSize(tests_->fontMetrics().lineSpacing() * 2 + 8);
  constexpr int kWidths[] = {200, 90, 240};
  for (int column = 0; column < 3; ++column) tests_->setColumnWidth(column, kWidths[column]);
  tests_->horizontalHeader()->setStretchLastSection(true);
  auto* splitter = new QSplitter;
  splitter->setObjectName("resultsSplitter");
  splitter->addWidget(tests_);
  splitter->addWidget(makeSide());
  splitter->setSizes({700, 740});
  auto* layout = seamlessColumn(this);
  layout->addWidget(makeBar());
  layout->addWidget(splitter, 1);

  connect(tests_->selectionModel(), &QItemSelectionModel::currentRowChanged, this, &ResultsPage::showResult);
  connect(&document_, &ProjectDocument::reset, this, [this] {
    if (document_.file() != running_on_) runner_.cancel();
    tests_->setCurrentIndex(model_.index(0, 0));
    showResult();
  });
  connect(&document_, &ProjectDocument::verdictsChanged, this, &ResultsPage::showResult);
  connect(numbers_, &QTableWidget::currentCellChanged, this, &ResultsPage::showPlot);
  connect(&runner_, &TestRunner::finished, this, [this](const acceptance::RunResult& result) {
    if (document_.file() == running_on_) guarded(this, [&] { store(result); });
  });
  connect(&runner_, &TestRunner::failed, this, [this](const core::InputError& error) { showError(this, error); });
  connect(&runner_, &TestRunner::runningChanged, this, [this](bool running) {
    run_selected_->setEnabled(!running);
    run_all_->setEnabled(!running);
  });
  showResult();
}

QWidget* ResultsPage::makeBar() {
  auto* bar = new QWidget;
  auto* layout = new QHBoxLayout(bar);
  layout->setContentsMargins(8, 6, 8, 6);
  run_selected_ = toolButton(tr("Run selected"), tr("Run the selected acceptance tests (F5)"));
  run_all_ = toolButton(tr("Run all"), tr("Run all acceptance tests that are not rejected (Ctrl+F5)"));
  open_report_ = toolButton(tr("Open report"), tr("The HTML report of this verdict in the browser"));
  status_ = new WorkStatus(runner_, tr("Progress of the run"), tr("Stop the run; nothing of it is stored"));
  layout->addWidget(run_selected_);
  layout->addWidget(run_all_);
  layout->addWidget(status_, 1);
  layout->addWidget(open_report_);
  connect(run_selected_, &QToolButton::clicked, this, &ResultsPage::runSelected);
  connect(run_all_, &QToolButton::clicked, this, &ResultsPage::runAll);
  connect(open_report_, &QToolButton::clicked, this, &ResultsPage::openReport);
  return bar;
}

QWidget* ResultsPage::makeSide() {
  auto* side = new QSplitter(Qt::Vertical);
  side->setObjectName("resultsSide");
  auto* upper = new QWidget;
  auto* layout = new QVBoxLayout(upper);
  layout->setContentsMargins(0, 0, 0, 0);
  headline_ = new QLabel;
  headline_->setWordWrap(true);
  headline_->setMargin(6);
  numbers_ = new QTableWidget(0, 5);
  numbers_->setAccessibleName(tr("Values against limits"));
  numbers_->setHorizontalHeaderLabels({tr("Sample"), tr("Must hold"), tr("Value"), tr("Limit"), tr("Margin")});
  numbers_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  numbers_->setSelectionBehavior(QAbstractItemView::SelectRows);
  numbers_->setAlternatingRowColors(true);
  numbers_->verticalHeader()->hide();
  numbers_->horizontalHeader()->setSectionResizeMode(1, QHeaderView::Stretch);
  layout->addWidget(headline_);
  layout->addWidget(numbers_, 1);
  plot_ = new SvgView;
  plot_->setAccessibleName(tr("Distributions of measurement and simulation"));
  side->addWidget(upper);
  side->addWidget(plot_);
  side->setSizes({220, 560});
  return side;
}

std::string ResultsPage::currentTest() const {
  const QModelIndex current = tests_->currentIndex();
  return current.isValid() ? model_.idOf(current.row()) : std::string();
}

void ResultsPage::showTest(const std::string& id) { tests_->setCurrentIndex(model_.indexOf(id)); }

void ResultsPage::runSelected() {
  std::vector<std::string> ids;
  for (const QModelIndex& row : tests_->selectionModel()->selectedRows()) ids.push_back(model_.idOf(row.row()));
  if (!ids.empty()) run(ids);
}

void ResultsPage::run(const std::vector<std::string>& tests) {
  if (runner_.isRunning() || !save_()) return;
  started_at_ = app::signatureOf("").when;
  running_on_ = document_.file();
  runner_.start(running_on_, tests);
}

std::filesystem::path ResultsPage::writeReport(const acceptance::RunResult& result) {
  const std::filesystem::path report = document_.reportFile(started_at_ + ".html");
  std::error_code ignored;
  std::filesystem::create_directories(report.parent_path(), ignored);  // writing says what is wrong
  const bool written = guarded(this, [&] { core::writeFile(report, acceptance::htmlReport(result)); });
  return written ? report : std::filesystem::path();
}

void ResultsPage::store(const acceptance::RunResult& result) {
  acceptance::storeRun(document_.store(), result, {.started_at = started_at_, .report = writeReport(result)});
  status_->tell(tr("%1 passed, %2 failed, %3 undecided, %4 skipped")
                    .arg(result.count(specs::Verdict::Passed))
                    .arg(result.count(specs::Verdict::Failed))
                    .arg(result.count(specs::Verdict::Error))
                    .arg(result.count(specs::Verdict::Skipped)));
  document_.refreshVerdicts();
}

void ResultsPage::showResult() {
  const std::string id = currentTest();
  const auto verdict = document_.lastEvaluation(id);
  shown_ = verdict ? shownResult(*verdict) : ShownResult();
  report_ = verdict && !verdict->report.empty() ? document_.folder() / verdict->report : std::filesystem::path();
  open_report_->setEnabled(!report_.empty() && std::filesystem::exists(report_));
  const auto item = document_.item(id);
  QString text = item ? "<b>" + QString::fromStdString(base(*item).title).toHtmlEscaped() + "</b>" : QString();
  if (verdict) {
    text += "<br/>" + wordFor(verdict->verdict) + ": " + QString::fromStdString(verdict->text).toHtmlEscaped();
    if (shown_.synthetic) text += "<br/><b>" + tr("Synthetic data: made by a program, not measured.") + "</b>";
  } else if (item) {
    text += "<br/>" + tr("This test has not run yet.");
  }
  headline_->setText(text);
  fillNumbers();
  showPlot();
}

void ResultsPage::fillNumbers() {
  const QSignalBlocker quiet(numbers_);
  numbers_->setRowCount(int(shown_.relations.size()));
  for (int row = 0; row < numbers_->rowCount(); ++row) {
    const ShownRelation& relation = shown_.relations[std::size_t(row)];
    const ShownSample& sample = shown_.samples[relation.sample];
    const std::string* texts[] = {&sample.id, &relation.text, &relation.value, &relation.limit, &relation.margin};
    for (int column = 0; column < 5; ++column) {
      auto* cell = new QTableWidgetItem(QString::fromStdString(*texts[column]));
      if (column >= 2) cell->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
      if (column == 0) cell->setToolTip(QString::fromStdString(sample.text));
      numbers_->setItem(row, column, cell);
    }
    const auto verdict = relation.holds ? specs::Verdict::Passed : specs::Verdict::Failed;
    numbers_->item(row, 1)->setIcon(iconOf(verdict));
    numbers_->item(row, 1)->setData(Qt::AccessibleTextRole, numbers_->item(row, 1)->text() + ", " + wordFor(verdict));
  }
  for (const int column : {0, 2, 3, 4}) numbers_->resizeColumnToContents(column);
  if (numbers_->rowCount() > 0) numbers_->setCurrentCell(int(shown_.decisive()), 0);  // the plot begins there
}

void ResultsPage::showPlot() {
  const int row = numbers_->currentRow();
  const bool any = row >= 0 && std::size_t(row) < shown_.relations.size();
  plot_->setSvg(any ? shown_.samples[shown_.relations[std::size_t(row)].sample].figure : std::string(),
                currentTest().empty() ? tr("Choose a test.") : tr("No plot: this test has no evaluated sample."));
}

void ResultsPage::openReport() {
  QDesktopServices::openUrl(QUrl::fromLocalFile(QString::fromStdString(report_.string())));
}

}  // namespace desktop
