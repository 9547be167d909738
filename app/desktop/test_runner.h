#pragma once

#include <QObject>
#include <QThread>
#include <atomic>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "acceptance/result.h"
#include "core/error.h"

namespace desktop {

/// Runs acceptance tests in a thread of its own, on a connection of its own that only reads. What came out is handed
/// back in the thread of the window, which stores it.
class TestRunner final : public QObject {
  Q_OBJECT

 public:
  explicit TestRunner(QObject* parent = nullptr);
  ~TestRunner() override;  ///< cancels and waits

  /// `tests`: shown ids; empty: all that are not rejected. Does nothing while a run is under way.
  void start(const std::filesystem::path& project, const std::vector<std::string>& tests);
  void cancel();
  [[nodiscard]] bool isRunning() const noexcept { return thread_ != nullptr; }

 signals:
  void progressed(double fraction, const QString& doing);
  void finished(const acceptance::RunResult& result);
  void failed(const core::InputError& error);
  void cancelled();

 private:
  std::unique_ptr<QThread> thread_;
  std::shared_ptr<std::atomic<bool>> stop_;
};

}  // namespace desktop
