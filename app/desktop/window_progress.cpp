#include "app/desktop/window_progress.h"

namespace desktop {

WindowProgress::WindowProgress(std::shared_ptr<std::atomic<bool>> stop, std::function<void(double, QString)> tell)
    : stop_(std::move(stop)), tell_(std::move(tell)) {
  clock_.start();
}

void WindowProgress::report(double fraction, std::string_view doing) {
  constexpr qint64 kPause_ms = 50;
  const std::lock_guard lock(mutex_);
  if (told_ && clock_.elapsed() < kPause_ms) return;
  told_ = true;
  clock_.restart();
  tell_(fraction, QString::fromUtf8(doing.data(), qsizetype(doing.size())));
}

}  // namespace desktop
