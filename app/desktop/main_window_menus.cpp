// The menus of the main window and the questions that they ask.

#include <QApplication>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenuBar>
#include <QMessageBox>

#include "app/cli/signature.h"
#include "app/desktop/error_dialog.h"
#include "app/desktop/graph_page.h"
#include "app/desktop/main_window.h"
#include "app/desktop/recent_files.h"
#include "app/desktop/results_page.h"
#include "core/version.h"
#include "percollect/read_graph.h"
#include "specs/documents.h"
#include "specs/import_graph.h"

namespace desktop {

namespace {

constexpr auto kProjectFilter = QT_TRANSLATE_NOOP("MainWindow", "Fidelis projects (*.fidelis);;All files (*)");

}  // namespace

void MainWindow::makeMenus() {
  makeFileMenu();
  makeEditMenu();
  makeViewMenu();
  makeTestMenu();
  makeHelpMenu();
}

void MainWindow::makeFileMenu() {
  QMenu* menu = menuBar()->addMenu(tr("&File"));
  menu->addAction(tr("&New from a graph…"), QKeySequence::New, this, &MainWindow::askAndCreate);
  menu->addAction(tr("&Open…"), QKeySequence::Open, this, &MainWindow::askAndOpen);
  recent_menu_ = menu->addMenu(tr("Open &recent"));
  menu->addSeparator();
  needs_project_ << menu->addAction(tr("&Save"), QKeySequence::Save, this, &MainWindow::save);
  needs_project_ << menu->addAction(tr("Re&load"), QKeySequence(Qt::CTRL | Qt::Key_R), this, [this] {
    if (maySwitchProject()) guarded(this, [&] { document_.reload(); });
  });
  QMenu* exports = menu->addMenu(tr("&Export specification"));
  for (std::size_t i = 0; i < specs::documentFormats().size(); ++i) {
    const std::string_view title = specs::documentFormats()[i].title;
    needs_project_ << exports->addAction(QString::fromUtf8(title.data(), qsizetype(title.size())), this,
                                         [this, i] { askAndExport(i); });
  }
  needs_project_ << menu->addAction(tr("&Close project"), QKeySequence::Close, this, [this] {
    if (maySwitchProject()) document_.close();
  });
  menu->addSeparator();
  menu->addAction(tr("&Quit"), QKeySequence::Quit, this, &MainWindow::close);
  fillRecentMenu();
}

void MainWindow::makeEditMenu() {
  QMenu* menu = menuBar()->addMenu(tr("&Edit"));
  QAction* undo = document_.undoStack().createUndoAction(this, tr("Undo"));
  undo->setShortcut(QKeySequence::Undo);
  QAction* redo = document_.undoStack().createRedoAction(this, tr("Redo"));
  redo->setShortcuts({QKeySequence::Redo, QKeySequence(Qt::CTRL | Qt::Key_Y)});
  menu->addActions({undo, redo});
  menu->addSeparator();
  needs_project_ << menu->addAction(tr("&Find"), QKeySequence::Find, this, [this] {
    for (QLineEdit* box : tabs_->currentWidget()->findChildren<QLineEdit*>()) {
      if (!box->objectName().endsWith("Search")) continue;
      box->setFocus();
      box->selectAll();
    }
  });
}

void MainWindow::makeViewMenu() {
  QMenu* menu = menuBar()->addMenu(tr("&View"));
  for (int i = 0; i < tabs_->count(); ++i) {
    needs_project_ << menu->addAction(tabs_->tabText(i), QKeySequence(Qt::CTRL | Qt::Key(Qt::Key_1 + i)), this,
                                      [this, i] { tabs_->setCurrentIndex(i); });
  }
  menu->addSeparator();
  needs_project_ << menu->addAction(tr("&Fit graph"), QKeySequence(Qt::CTRL | Qt::Key_0), this,
                                    [this] { graph_->fit(); });
  QAction* dark = menu->addAction(tr("&Dark colours"));
  dark->setCheckable(true);
  dark->setChecked(settings_.value("dark").toBool());
  connect(dark, &QAction::toggled, this, &MainWindow::setDark);
}

void MainWindow::makeTestMenu() {
  QMenu* menu = menuBar()->addMenu(tr("&Test"));
  needs_project_ << menu->addAction(tr("Run &selected"), QKeySequence(Qt::Key_F5), this, [this] {
    showTab(Results);
    results_->runSelected();
  });
  needs_project_ << menu->addAction(tr("Run &all"), QKeySequence(Qt::CTRL | Qt::Key_F5), this, [this] {
    showTab(Results);
    results_->runAll();
  });
  needs_project_ << menu->addAction(tr("&Cancel run"), this, [this] { results_->cancel(); });
}

void MainWindow::makeHelpMenu() {
  QMenu* menu = menuBar()->addMenu(tr("&Help"));
  menu->addAction(tr("&About Fidelis"), this, &MainWindow::about);
  menu->addAction(tr("About &Qt"), qApp, &QApplication::aboutQt);
}

void MainWindow::fillRecentMenu() {
  recent_menu_->clear();
  for (const QString& file : recentFiles(settings_)) {
    QAction* action = recent_menu_->addAction(QFileInfo(file).fileName());
    action->setToolTip(file);
    connect(action, &QAction::triggered, this, [this, file] { openProject(file.toStdString()); });
  }
  recent_menu_->setEnabled(!recent_menu_->isEmpty());
}

void MainWindow::askAndOpen() {
  const QString file = QFileDialog::getOpenFileName(this, tr("Open a project"), {}, tr(kProjectFilter));
  if (!file.isEmpty()) openProject(file.toStdString());
}

void MainWindow::askAndCreate() {
  const QString source = QFileDialog::getOpenFileName(this, tr("Choose a cause-effect graph (PerCollECT)"), {},
                                                      tr("Graphs (*.json root_node.xml);;All files (*)"));
  if (source.isEmpty()) return;
  const QString target = QFileDialog::getSaveFileName(this, tr("New project file"), {}, tr(kProjectFilter));
  if (target.isEmpty()) return;
  const std::filesystem::path file = target.toStdString();
  const bool made = guarded(this, [&] {
    const percollect::ReadGraph read = percollect::readGraph(source.toStdString(), {});
    auto store = specs::ProjectStore::create(file);
    specs::importGraph(store, read.graph, app::signatureOf(""));
  });
  if (made) openProject(file);
}

void MainWindow::askAndExport(std::size_t index) {
  const specs::DocumentFormat& format = specs::documentFormats()[index];
  const QString target =
      format.is_folder
          ? QFileDialog::getExistingDirectory(this, tr("Folder to write to"))
          : QFileDialog::getSaveFileName(this, tr("File to write"),
                                         QString::fromStdString(document_.specification().project) + "." +
                                             QString::fromUtf8(format.name.data(), qsizetype(format.name.size())));
  if (target.isEmpty()) return;
  guarded(this, [&] { format.write(document_.specification(), target.toStdString()); });
}

void MainWindow::about() {
  QMessageBox::about(this, tr("About Fidelis"),
                     tr("<h3>Fidelis %1</h3><p>Tells whether a lidar simulation is good enough, and if not, where it "
                        "departs from the measurement and which effect it lacks.</p><p>Cause-effect graphs: PerCollECT "
                        "(Linnhoff et al. 2021). Relevance analysis and metrics: Rosenberger 2022. Made with Qt and "
                        "Graphviz.</p>")
                         .arg(QString::fromStdString(core::kVersion)));
}

}  // namespace desktop
