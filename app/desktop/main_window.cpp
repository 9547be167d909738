#include "app/desktop/main_window.h"

#include <QApplication>
#include <QCloseEvent>
#include <QHeaderView>
#include <QMessageBox>
#include <QMimeData>
#include <QSplitter>
#include <QStatusBar>

#include "app/desktop/cepra_page.h"
#include "app/desktop/cloud/cloud_page.h"
#include "app/desktop/colours.h"
#include "app/desktop/diagnosis/diagnosis_page.h"
#include "app/desktop/error_dialog.h"
#include "app/desktop/graph_page.h"
#include "app/desktop/recent_files.h"
#include "app/desktop/results_page.h"
#include "app/desktop/spec_page.h"
#include "app/desktop/start_page.h"

namespace desktop {

MainWindow::MainWindow(QSettings& settings, QWidget* parent)
    : QMainWindow(parent),
      settings_(settings),
      stack_(new QStackedWidget),
      start_(new StartPage),
      tabs_(new QTabWidget),
      place_(new QLabel) {
  setAcceptDrops(true);
  setCentralWidget(stack_);
  makeTabs();
  stack_->addWidget(start_);
  stack_->addWidget(tabs_);
  statusBar()->addPermanentWidget(place_);
  makeMenus();
  connectPages();
  connect(start_, &StartPage::openRequested, this, &MainWindow::askAndOpen);
  connect(start_, &StartPage::newRequested, this, &MainWindow::askAndCreate);
  connect(start_, &StartPage::fileRequested, this, [this](const QString& file) { openProject(file.toStdString()); });
  connect(&document_, &ProjectDocument::reset, this, &MainWindow::projectChanged);
  connect(&document_, &ProjectDocument::modifiedChanged, this, &MainWindow::setWindowModified);
  restoreLayout();
  projectChanged();
}

MainWindow::~MainWindow() {
  delete stack_;  // the pages refer to document_, a member; as children they would outlive it
}

void MainWindow::makeTabs() {
  tabs_->setObjectName("tabs");
  tabs_->setDocumentMode(true);
  graph_ = new GraphPage(document_);
  cepra_ = new CepraPage(document_);
  tabs_->addTab(graph_, tr("Graph"));
  tabs_->addTab(cepra_, tr("Relevance (CEPRA)"));
  spec_ = new SpecPage(document_);
  tabs_->addTab(spec_, tr("Specification"));
  results_ = new ResultsPage(document_, [this] { return save(); });
  tabs_->addTab(results_, tr("Results"));
  diagnosis_ = new DiagnosisPage(document_, [this] { return save(); });
  tabs_->addTab(diagnosis_, tr("Diagnosis"));
  cloud_ = new CloudPage(document_);
  tabs_->addTab(cloud_, tr("Point cloud"));
}

void MainWindow::connectPages() {
  connect(graph_, &GraphPage::rowsRequested, this, [this](const QString& node) {
    showTab(Relevance);
    cepra_->showRowsOf(node);
  });
  connect(cepra_, &CepraPage::nodeRequested, this, [this](const QString& node) {
    showTab(Graph);
    graph_->showNode(node.toStdString());
  });
  const auto show_item = [this](const QString& id) {
    showTab(Specification);
    spec_->showItem(id.toStdString());
  };
  connect(graph_, &GraphPage::itemRequested, this, show_item);
  connect(cepra_, &CepraPage::itemRequested, this, show_item);
  const auto show_row = [this](const QString& key) {
    showTab(Relevance);
    cepra_->showRow(key.toStdString());
  };
  connect(spec_, &SpecPage::rowRequested, this, show_row);
  connect(diagnosis_, &DiagnosisPage::rowRequested, this, show_row);
  connect(diagnosis_, &DiagnosisPage::itemRequested, this, show_item);
  const auto show_result = [this](const QString& test) {
    showTab(Results);
    results_->showTest(test.toStdString());
  };
  connect(spec_, &SpecPage::resultRequested, this, show_result);
  connect(diagnosis_, &DiagnosisPage::testRequested, this, show_result);
}

void MainWindow::showTab(Tab tab) { tabs_->setCurrentIndex(tab); }

bool MainWindow::openProject(const std::filesystem::path& file) {
  if (!maySwitchProject()) return false;
  if (!guarded(this, [&] { document_.open(file); })) return false;
  rememberFile(settings_, QString::fromStdString(file.string()));
  fillRecentMenu();
  return true;
}

bool MainWindow::save() {
  if (!document_.modified()) return true;
  if (document_.changedElsewhere()) {
    const auto answer = QMessageBox::question(
        this, tr("Save"),
        tr("Another program has changed the project since it was opened here.\n\nSaving writes what you see here over "
           "it. To see the other changes, cancel and choose File > Reload; that drops yours."),
        QMessageBox::Save | QMessageBox::Cancel, QMessageBox::Cancel);
    if (answer != QMessageBox::Save) return false;
  }
  if (!guarded(this, [&] { document_.save(); })) return false;
  statusBar()->showMessage(tr("Saved"), 4000);
  return true;
}

bool MainWindow::maySwitchProject() {
  if (!document_.modified()) return true;
  const auto answer = QMessageBox::question(this, tr("Unsaved changes"), tr("Save the changes to this project?"),
                                            QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel);
  if (answer == QMessageBox::Save) return save();
  return answer == QMessageBox::Discard;
}

void MainWindow::projectChanged() {
  const bool open = document_.isOpen();
  for (QAction* action : needs_project_) action->setEnabled(open);
  stack_->setCurrentWidget(open ? static_cast<QWidget*>(tabs_) : start_);
  start_->setRecentFiles(recentFiles(settings_));
  const QString name = QString::fromStdString(document_.file().filename().string());
  setWindowTitle(open ? tr("%1[*] – Fidelis").arg(name) : tr("Fidelis[*]"));
  setWindowModified(false);
  const auto& specification = document_.specification();
  place_->setText(open ? tr("%1 nodes · %2 rows · %3 requirements · %4 tests")
                             .arg(document_.graph().size())
                             .arg(specification.cepra.rows.size())
                             .arg(specification.requirements.size())
                             .arg(specification.tests.size())
                       : QString());
}

void MainWindow::setDark(bool dark) {
  QApplication::setPalette(dark ? darkPalette() : lightPalette());
  settings_.setValue("dark", dark);
}

void MainWindow::saveLayout() {
  settings_.setValue("geometry", saveGeometry());
  for (QSplitter* splitter : findChildren<QSplitter*>()) {
    if (!splitter->objectName().isEmpty()) settings_.setValue(splitter->objectName(), splitter->saveState());
  }
  settings_.setValue(cepra_->header().objectName(), cepra_->header().saveState());
}

void MainWindow::restoreLayout() {
  resize(1440, 900);
  restoreGeometry(settings_.value("geometry").toByteArray());
  for (QSplitter* splitter : findChildren<QSplitter*>()) {
    splitter->restoreState(settings_.value(splitter->objectName()).toByteArray());
  }
  cepra_->header().restoreState(settings_.value(cepra_->header().objectName()).toByteArray());
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (!maySwitchProject()) {
    event->ignore();
    return;
  }
  saveLayout();
  event->accept();
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (event->mimeData()->hasUrls() && event->mimeData()->urls().size() == 1) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
  const QString file = event->mimeData()->urls().first().toLocalFile();
  if (!file.isEmpty()) openProject(file.toStdString());
}

}  // namespace desktop
