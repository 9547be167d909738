#pragma once

#include "app/desktop/background_work.h"
#include "app/desktop/cloud/point_cloud.h"

namespace desktop {

/// Simulates an experiment's samples in a thread of its own, the wanted one first; each is handed over in the window's
/// thread as soon as it is there.
class SimulationRunner final : public BackgroundWork {
  Q_OBJECT

 public:
  explicit SimulationRunner(QObject* parent = nullptr) : BackgroundWork(parent) {}

  /// Does nothing while a simulation is under way.
  void start(const std::filesystem::path& experiment, const std::filesystem::path& model, std::size_t first_sample);

 signals:
  void simulated(std::size_t sample, std::shared_ptr<const desktop::PointCloud> cloud);
  void finished();
};

}  // namespace desktop
