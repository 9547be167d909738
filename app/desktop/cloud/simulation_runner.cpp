#include "app/desktop/cloud/simulation_runner.h"

#include <optional>

#include "app/desktop/guarded_work.h"
#include "app/desktop/window_progress.h"
#include "model/simulate.h"

namespace desktop {

namespace {

using Hand = std::function<void(std::size_t, std::shared_ptr<const PointCloud>)>;

void simulateSamples(const std::filesystem::path& experiment_file, const std::filesystem::path& model_file,
                     std::size_t first, core::Progress& progress, const Hand& hand) {
  const model::Experiment experiment = model::readExperiment(experiment_file);
  const model::LidarModel lidar = model::readModel(model_file);
  const std::size_t count = experiment.samples.size();
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t sample = (first + k) % count;
    core::stopIfCancelled(progress);
    progress.report(double(k) / double(count), "simulating " + experiment.samples[sample].id);
    auto cloud = std::make_shared<const PointCloud>(pointCloudOf(model::simulate(experiment, lidar, sample)));
    core::stopIfCancelled(progress);
    hand(sample, std::move(cloud));
  }
}

}  // namespace

SimulationRunner::SimulationRunner(QObject* parent) : QObject(parent) {}

SimulationRunner::~SimulationRunner() {
  cancel();
  if (thread_) thread_->wait();
}

void SimulationRunner::cancel() {
  if (stop_) *stop_ = true;
}

void SimulationRunner::start(const std::filesystem::path& experiment, const std::filesystem::path& model,
                             std::size_t first_sample) {
  if (isRunning()) return;
  stop_ = std::make_shared<std::atomic<bool>>(false);
  auto error = std::make_shared<std::optional<core::InputError>>();
  const auto queued = [this, stop = stop_](auto work) {
    QMetaObject::invokeMethod(
        this,
        [stop, work] {
          if (!*stop) work();
        },
        Qt::QueuedConnection);
  };
  const auto tell = [this, queued](double fraction, const QString& doing) {
    queued([this, fraction, doing] { emit progressed(fraction, doing); });
  };
  const Hand hand = [this, queued](std::size_t sample, std::shared_ptr<const PointCloud> cloud) {
    queued([this, sample, cloud] { emit simulated(sample, cloud); });
  };
  thread_.reset(QThread::create([=, stop = stop_] {
    WindowProgress progress(stop, tell);
    *error = errorOf([&] { simulateSamples(experiment, model, first_sample, progress, hand); }, experiment,
                     "Please report it, with the experiment if you may.");
  }));
  connect(thread_.get(), &QThread::finished, this, [this, error, stop = stop_] {
    thread_.release()->deleteLater();
    if (*stop) {
      emit cancelled();
    } else if (*error) {
      emit failed(**error);
    } else {
      emit finished();
    }
  });
  thread_->start();
}

}  // namespace desktop
