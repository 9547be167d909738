#pragma once

#include <QPalette>
#include <QString>
#include <string>

namespace desktop::html {

/// Small pieces of rich text for the detail panes; every text is escaped.
[[nodiscard]] QString text(const std::string& text);
[[nodiscard]] QString heading(const QString& text);                           ///< of the whole pane
[[nodiscard]] QString section(const QString& text, const QPalette& palette);  ///< a small heading above a part
[[nodiscard]] QString paragraph(const QString& markup);
[[nodiscard]] QString muted(const QString& markup, const QPalette& palette);
[[nodiscard]] QString link(const QString& address, const QString& text);

}  // namespace desktop::html
