#include "app/desktop/start_page.h"

#include <QFileInfo>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace desktop {

StartPage::StartPage(QWidget* parent) : QWidget(parent), recent_(new QVBoxLayout) {
  auto* title = new QLabel(tr("Fidelis"));
  QFont large = title->font();
  large.setPointSizeF(large.pointSizeF() * 2.2);
  large.setBold(true);
  title->setFont(large);
  auto* what =
      new QLabel(tr("From a cause-effect graph to an accepted or rejected lidar simulation.\n"
                    "Open a project file, or drop one here."));
  auto* open = new QPushButton(tr("&Open project…"));
  open->setDefault(true);
  auto* fresh = new QPushButton(tr("&New project from a graph…"));
  connect(open, &QPushButton::clicked, this, &StartPage::openRequested);
  connect(fresh, &QPushButton::clicked, this, &StartPage::newRequested);
  auto* column = new QVBoxLayout;
  column->setSpacing(12);
  column->addWidget(title);
  column->addWidget(what);
  column->addSpacing(8);
  column->addWidget(open);
  column->addWidget(fresh);
  column->addSpacing(12);
  column->addLayout(recent_);
  auto* grid = new QGridLayout(this);
  grid->addLayout(column, 1, 1);
  grid->setRowStretch(0, 1);
  grid->setRowStretch(2, 2);
  grid->setColumnStretch(0, 1);
  grid->setColumnStretch(2, 1);
}

void StartPage::setRecentFiles(const QStringList& files) {
  while (QLayoutItem* item = recent_->takeAt(0)) {
    delete item->widget();
    delete item;
  }
  if (!files.isEmpty()) recent_->addWidget(new QLabel(tr("Recent projects")));
  for (const QString& file : files) {
    auto* button = new QPushButton(QFileInfo(file).fileName());
    button->setFlat(true);
    button->setToolTip(file);
    connect(button, &QPushButton::clicked, this, [this, file] { emit fileRequested(file); });
    recent_->addWidget(button);
  }
}

}  // namespace desktop
