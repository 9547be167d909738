#include "app/desktop/recent_files.h"

#include <QFileInfo>

namespace desktop {

namespace {

constexpr auto kKey = "recentFiles";
constexpr int kMost = 8;

}  // namespace

QStringList recentFiles(const QSettings& settings) {
  QStringList files = settings.value(kKey).toStringList();
  files.removeIf([](const QString& file) { return !QFileInfo::exists(file); });
  return files;
}

void rememberFile(QSettings& settings, const QString& file) {
  const QString path = QFileInfo(file).absoluteFilePath();
  QStringList files = recentFiles(settings);
  files.removeAll(path);
  files.prepend(path);
  settings.setValue(kKey, QStringList(files.mid(0, kMost)));
}

}  // namespace desktop
