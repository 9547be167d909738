#pragma once

#include <QSettings>
#include <QStringList>

namespace desktop {

/// The projects that were open last, newest first; at most eight, without those that are gone.
[[nodiscard]] QStringList recentFiles(const QSettings& settings);
void rememberFile(QSettings& settings, const QString& file);

}  // namespace desktop
