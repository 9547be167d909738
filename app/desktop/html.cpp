#include "app/desktop/html.h"

#include "app/desktop/colours.h"

namespace desktop::html {

QString text(const std::string& text) {
  return QString::fromStdString(text).toHtmlEscaped().replace('\n', QStringLiteral("<br/>"));
}

QString heading(const QString& text) {
  return QStringLiteral("<h3 style='margin:0 0 2px 0'>%1</h3>").arg(text.toHtmlEscaped());
}

QString section(const QString& text, const QPalette& palette) {
  return QStringLiteral("<p style='margin:12px 0 2px 0; color:%1; font-weight:600'>%2</p>")
      .arg(desktop::muted(palette).name(), text.toHtmlEscaped());
}

QString paragraph(const QString& markup) { return QStringLiteral("<p style='margin:2px 0 4px 0'>%1</p>").arg(markup); }

QString muted(const QString& markup, const QPalette& palette) {
  return QStringLiteral("<span style='color:%1'>%2</span>").arg(desktop::muted(palette).name(), markup);
}

QString link(const QString& address, const QString& text) {
  return QStringLiteral("<a href=\"%1\">%2</a>").arg(address.toHtmlEscaped(), text.toHtmlEscaped());
}

}  // namespace desktop::html
