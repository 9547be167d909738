#include "app/desktop/page_parts.h"

#include <QHBoxLayout>

namespace desktop {

QToolButton* toolButton(const QString& text, const QString& tip) {
  auto* button = new QToolButton;
  button->setText(text);
  button->setToolTip(tip);
  return button;
}

QTextBrowser* textPane(const QString& name, int margin) {
  auto* pane = new QTextBrowser;
  pane->setAccessibleName(name);
  pane->setOpenLinks(false);
  pane->document()->setDocumentMargin(margin);
  return pane;
}

QVBoxLayout* seamlessColumn(QWidget* parent) {
  auto* column = new QVBoxLayout(parent);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  return column;
}

WorkStatus::WorkStatus(BackgroundWork& work, const QString& progress, const QString& cancel_tip, QWidget* parent)
    : QWidget(parent), cancel_(toolButton(tr("Cancel"), cancel_tip)), progress_(new QProgressBar), doing_(new QLabel) {
  progress_->setAccessibleName(progress);
  progress_->setFixedWidth(200);
  doing_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);  // a long text does not widen the window
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(cancel_);
  layout->addWidget(progress_);
  layout->addWidget(doing_, 1);
  connect(cancel_, &QToolButton::clicked, &work, &BackgroundWork::cancel);
  connect(&work, &BackgroundWork::runningChanged, this, &WorkStatus::showRunning);
  connect(&work, &BackgroundWork::cancelled, this, [this] { tell(tr("Cancelled; nothing was stored.")); });
  connect(&work, &BackgroundWork::progressed, this, [this](double fraction, const QString& doing) {
    progress_->setValue(int(fraction * 100));
    tell(doing);
  });
  showRunning(work.isRunning());
}

void WorkStatus::tell(const QString& text, const QString& tip) {
  doing_->setText(text);
  doing_->setToolTip(tip.isEmpty() ? text : tip);
}

void WorkStatus::showRunning(bool running) {
  cancel_->setVisible(running);
  progress_->setVisible(running);
  progress_->setValue(0);
  tell(running ? tr("Starting…") : QString());
}

}  // namespace desktop
