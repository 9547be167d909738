#include "app/desktop/error_dialog.h"

#include <QCoreApplication>
#include <QMessageBox>

namespace desktop {

namespace {

QString tr(const char* text) { return QCoreApplication::translate("ErrorDialog", text); }

QString part(const QString& heading, const std::string& text) {
  return text.empty()
             ? QString()
             : QStringLiteral("<p><b>%1</b><br/>%2</p>").arg(heading, QString::fromStdString(text).toHtmlEscaped());
}

}  // namespace

void showError(QWidget* parent, const core::InputError& error) {
  QMessageBox box(QMessageBox::Warning, QCoreApplication::applicationName(), "", QMessageBox::Ok, parent);
  box.setTextFormat(Qt::RichText);
  QString problem = QString::fromStdString(error.problem());
  if (!problem.isEmpty()) problem[0] = problem[0].toUpper();
  box.setText("<b>" + problem.toHtmlEscaped() + "</b>");
  box.setInformativeText(part(tr("Where"), core::toString(error.place())) + part(tr("What to do"), error.remedy()));
  box.setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  box.exec();
}

bool guarded(QWidget* parent, const std::function<void()>& work) {
  try {
    work();
    return true;
  } catch (const core::InputError& error) {
    showError(parent, error);
  }
  return false;
}

}  // namespace desktop
