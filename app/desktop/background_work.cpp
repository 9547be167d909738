#include "app/desktop/background_work.h"

#include <optional>

#include "app/desktop/guarded_work.h"
#include "app/desktop/window_progress.h"

namespace desktop {

BackgroundWork::~BackgroundWork() {
  cancel();
  if (thread_) thread_->wait();
}

void BackgroundWork::cancel() {
  if (stop_) *stop_ = true;
}

void BackgroundWork::handOver(std::function<void()> something) {
  QMetaObject::invokeMethod(
      this,
      [stop = stop_, something = std::move(something)] {
        if (!*stop) something();
      },
      Qt::QueuedConnection);
}

void BackgroundWork::start(Work work, std::function<void()> done, const std::filesystem::path& file,
                           const std::string& remedy) {
  if (isRunning()) return;
  stop_ = std::make_shared<std::atomic<bool>>(false);
  auto error = std::make_shared<std::optional<core::InputError>>();
  const auto tell = [this](double fraction, const QString& doing) {
    handOver([this, fraction, doing] { emit progressed(fraction, doing); });
  };
  thread_.reset(QThread::create([work = std::move(work), file, remedy, error, tell, stop = stop_] {
    WindowProgress progress(stop, tell);
    *error = errorOf([&] { work(progress); }, file, remedy);
  }));
  connect(thread_.get(), &QThread::finished, this, [this, error, done = std::move(done), stop = stop_] {
    thread_.release()->deleteLater();
    emit runningChanged(false);
    if (*stop) {
      emit cancelled();
    } else if (*error) {
      emit failed(**error);
    } else {
      done();
    }
  });
  thread_->start();
  emit runningChanged(true);
}

}  // namespace desktop
