#pragma once

#include <QWidget>

class QVBoxLayout;

namespace desktop {

/// What stands in the window while no project is open: how to begin, and the projects of last time.
class StartPage final : public QWidget {
  Q_OBJECT

 public:
  explicit StartPage(QWidget* parent = nullptr);
  void setRecentFiles(const QStringList& files);

 signals:
  void openRequested();
  void newRequested();
  void fileRequested(const QString& file);

 private:
  QVBoxLayout* recent_;
};

}  // namespace desktop
