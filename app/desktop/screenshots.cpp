#include "app/desktop/screenshots.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QPixmap>
#include <QTabWidget>
#include <QThread>

#include "app/desktop/graph_page.h"
#include "app/desktop/main_window.h"
#include "core/error.h"

namespace desktop {

void settle(MainWindow& window) {
  constexpr qint64 kPatience_ms = 10'000;
  QElapsedTimer clock;
  clock.start();
  do {
    QApplication::processEvents(QEventLoop::AllEvents, 50);
    QThread::msleep(5);
  } while (window.graphPage().scene().isLayingOut() && clock.elapsed() < kPatience_ms);
  QApplication::processEvents();
}

void renderTabs(MainWindow& window, const std::filesystem::path& folder) {
  std::error_code ignored;
  std::filesystem::create_directories(folder, ignored);  // a failure shows when the first picture is written
  constexpr const char* kNames[MainWindow::TabCount] = {"graph",   "relevance", "specification",
                                                        "results", "diagnosis", "point-cloud"};
  window.show();
  for (int tab = 0; tab < MainWindow::TabCount; ++tab) {
    window.showTab(MainWindow::Tab(tab));
    settle(window);
    const std::filesystem::path file = folder / (std::string(kNames[tab]) + ".png");
    if (!window.grab().save(QString::fromStdString(file.string()), "PNG")) {
      throw core::InputError({.file = file}, "the picture cannot be written.",
                             "Choose another folder, or ask for the right to write there.");
    }
  }
}

}  // namespace desktop
