#pragma once

#include <QLabel>
#include <QProgressBar>
#include <QTextBrowser>
#include <QToolButton>
#include <QVBoxLayout>
#include <QWidget>

#include "app/desktop/background_work.h"

namespace desktop {

/// What the pages of the window are put together from.
[[nodiscard]] QToolButton* toolButton(const QString& text, const QString& tip);
/// Rich text whose links the page follows itself. `name` is what a screen reader says.
[[nodiscard]] QTextBrowser* textPane(const QString& name, int margin = 10);
/// A column of parts that touch each other and the edges of `parent`.
QVBoxLayout* seamlessColumn(QWidget* parent);

/// Of one background work: a button that cancels it and its progress, both only while it runs, and what it is doing.
class WorkStatus final : public QWidget {
  Q_OBJECT

 public:
  /// `progress`: its name for a screen reader.
  WorkStatus(BackgroundWork& work, const QString& progress, const QString& cancel_tip, QWidget* parent = nullptr);

  /// Instead of what was done last. `tip`: the same in full, if it is shortened.
  void tell(const QString& text, const QString& tip = {});

 private:
  void showRunning(bool running);

  QToolButton* cancel_;
  QProgressBar* progress_;
  QLabel* doing_;
};

}  // namespace desktop
