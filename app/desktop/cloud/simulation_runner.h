#pragma once

#include <QObject>
#include <QThread>
#include <atomic>
#include <filesystem>
#include <memory>

#include "app/desktop/cloud/point_cloud.h"
#include "core/error.h"

namespace desktop {

/// Simulates an experiment's samples in a thread of its own, the wanted one first; each is handed over in the window's
/// thread as soon as it is there.
class SimulationRunner final : public QObject {
  Q_OBJECT

 public:
  explicit SimulationRunner(QObject* parent = nullptr);
  ~SimulationRunner() override;  ///< cancels and waits

  /// Does nothing while a simulation is under way.
  void start(const std::filesystem::path& experiment, const std::filesystem::path& model, std::size_t first_sample);
  /// What is under way is finished in the background and dropped; no signal comes any more but cancelled().
  void cancel();
  [[nodiscard]] bool isRunning() const noexcept { return thread_ != nullptr; }
  [[nodiscard]] bool isStopping() const noexcept { return thread_ && *stop_; }

 signals:
  void progressed(double fraction, const QString& doing);
  void simulated(std::size_t sample, std::shared_ptr<const desktop::PointCloud> cloud);
  void finished();
  void failed(const core::InputError& error);
  void cancelled();

 private:
  std::unique_ptr<QThread> thread_;
  std::shared_ptr<std::atomic<bool>> stop_;
};

}  // namespace desktop
