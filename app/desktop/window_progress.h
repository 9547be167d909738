#pragma once

#include <QElapsedTimer>
#include <QString>
#include <atomic>
#include <functional>
#include <memory>
#include <mutex>

#include "core/progress.h"

namespace desktop {

/// Hands reports of a thread at work over to the window's thread, at most twenty a second.
class WindowProgress final : public core::Progress {
 public:
  /// `tell` is called in the working thread. `stop` becomes true when the person cancels.
  WindowProgress(std::shared_ptr<std::atomic<bool>> stop, std::function<void(double, QString)> tell);

  void report(double fraction, std::string_view doing) override;
  [[nodiscard]] bool cancelled() const override { return *stop_; }

 private:
  std::shared_ptr<std::atomic<bool>> stop_;
  std::function<void(double, QString)> tell_;
  std::mutex mutex_;
  QElapsedTimer clock_;
  bool told_ = false;
};

}  // namespace desktop
