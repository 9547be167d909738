#include "app/desktop/cloud/simulation_runner.h"

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

void SimulationRunner::start(const std::filesystem::path& experiment, const std::filesystem::path& model,
                             std::size_t first_sample) {
  const Hand hand = [this](std::size_t sample, std::shared_ptr<const PointCloud> cloud) {
    handOver([this, sample, cloud] { emit simulated(sample, cloud); });
  };
  BackgroundWork::start(
      [=](core::Progress& progress) { simulateSamples(experiment, model, first_sample, progress, hand); },
      [this] { emit finished(); }, experiment, "Please report it, with the experiment if you may.");
}

}  // namespace desktop
