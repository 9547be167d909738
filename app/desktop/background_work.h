#pragma once

#include <QObject>
#include <QThread>
#include <atomic>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "core/error.h"
#include "core/progress.h"

namespace desktop {

/// One piece of work at a time in a thread of its own. What comes out of it is handed over in the thread of the window;
/// of work that was cancelled nothing comes any more but cancelled().
class BackgroundWork : public QObject {
  Q_OBJECT

 public:
  ~BackgroundWork() override;  ///< cancels and waits

  void cancel();
  [[nodiscard]] bool isRunning() const noexcept { return thread_ != nullptr; }
  [[nodiscard]] bool isStopping() const noexcept { return thread_ && *stop_; }

 signals:
  void runningChanged(bool running);  ///< before what came out of it is told
  void progressed(double fraction, const QString& doing);
  void failed(const core::InputError& error);
  void cancelled();

 protected:
  explicit BackgroundWork(QObject* parent) : QObject(parent) {}

  using Work = std::function<void(core::Progress&)>;
  /// `work` runs in the thread; `done` in that of the window, if nothing went wrong. An internal error is said at
  /// `file`, with `remedy`. Does nothing while something is under way.
  void start(Work work, std::function<void()> done, const std::filesystem::path& file, const std::string& remedy);
  /// For `work`: hands something over in the thread of the window, unless it is cancelled before.
  void handOver(std::function<void()> something);

 private:
  std::unique_ptr<QThread> thread_;
  std::shared_ptr<std::atomic<bool>> stop_;
};

}  // namespace desktop
