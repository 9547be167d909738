// fidelis-desktop [PROJECT]: a window on a project file.

#include <QApplication>
#include <QCommandLineParser>
#include <QSettings>
#include <algorithm>
#include <array>
#include <cstring>
#include <iostream>
#include <memory>
#include <string_view>

#include "app/desktop/colours.h"
#include "app/desktop/error_dialog.h"
#include "app/desktop/main_window.h"
#include "app/desktop/screenshots.h"
#include "core/error.h"
#include "core/version.h"

namespace {

/// Pictures and answers to a terminal need no screen: a build server has none.
void goWithoutScreenIfNoWindowIsAskedFor(int argc, char** argv) {
  constexpr std::array<std::string_view, 5> kAnswers = {"-h", "--help", "--help-all", "-v", "--version"};
  const bool no_window = std::any_of(argv, argv + argc, [&](const char* word) {
    const bool picture = std::strncmp(word, "--screenshot", std::strlen("--screenshot")) == 0;
    return picture || std::find(kAnswers.begin(), kAnswers.end(), word) != kAnswers.end();
  });
  if (no_window && !qEnvironmentVariableIsSet("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "offscreen");
}

std::unique_ptr<QSettings> settingsFor(const QString& file) {
  if (file.isEmpty())
    return std::make_unique<QSettings>(QSettings::IniFormat, QSettings::UserScope, "Fidelis", "fidelis-desktop");
  return std::make_unique<QSettings>(file, QSettings::IniFormat);
}

/// No exception may pass through Qt's event loop: what a user can repair is shown, and the window stays.
class Application final : public QApplication {
 public:
  using QApplication::QApplication;

  bool notify(QObject* receiver, QEvent* event) override {
    bool handled = true;
    desktop::guarded(activeWindow(), [&] { handled = QApplication::notify(receiver, event); });
    return handled;
  }
};

}  // namespace

int main(int argc, char** argv) {
  goWithoutScreenIfNoWindowIsAskedFor(argc, argv);
  Application application(argc, argv);
  QApplication::setApplicationName("Fidelis");
  QApplication::setApplicationVersion(QString::fromStdString(std::string(core::kVersion)));
  QApplication::setStyle("Fusion");

  QCommandLineParser parser;
  parser.setApplicationDescription(
      "Shows and edits a Fidelis project: graph, relevance table, specification, results.");
  parser.addHelpOption();
  parser.addVersionOption();
  parser.addPositionalArgument("project", "Project file to open", "[PROJECT]");
  const QCommandLineOption settings_option("settings", "Keep window layout and recent files in FILE.", "FILE");
  const QCommandLineOption screenshot_option("screenshot", "Write a picture of each view into DIR, then quit.", "DIR");
  const QCommandLineOption dark_option("dark", "Dark colours.");
  parser.addOptions({settings_option, screenshot_option, dark_option});
  parser.process(application);

  const auto settings = settingsFor(parser.value(settings_option));
  const bool dark = parser.isSet(dark_option) || settings->value("dark").toBool();
  QApplication::setPalette(dark ? desktop::darkPalette() : desktop::lightPalette());
  const bool pictures = parser.isSet(screenshot_option);
  const QStringList files = parser.positionalArguments();
  try {
    desktop::MainWindow window(*settings);
    if (pictures) {
      if (files.isEmpty())
        throw core::InputError({.item = "--screenshot"}, "no project is named.", "Name a project file.");
      window.document().open(files.first().toStdString());
      desktop::renderTabs(window, parser.value(screenshot_option).toStdString());
      return 0;
    }
    window.show();
    if (!files.isEmpty()) window.openProject(files.first().toStdString());
    return QApplication::exec();
  } catch (const core::InputError& error) {
    std::cerr << "fidelis-desktop: " << error.what() << "\n";
    return 2;
  }
}
