#include "app/desktop/cloud/cloud_loader.h"

#include <utility>

#include "app/desktop/guarded_work.h"

namespace desktop {

CloudLoader::CloudLoader(QObject* parent) : QObject(parent) {}

CloudLoader::~CloudLoader() {
  if (thread_) thread_->wait();
}

void CloudLoader::drop() {
  next_.reset();
  wanted_ = false;
}

void CloudLoader::load(const model::Experiment& experiment, std::size_t sample) {
  wanted_ = true;
  next_ = Wish{experiment, sample};
  if (!thread_) begin(*std::exchange(next_, std::nullopt));
}

void CloudLoader::begin(Wish wish) {
  struct Outcome {
    std::shared_ptr<const PointCloud> cloud;
    std::optional<core::InputError> error;
  };
  auto outcome = std::make_shared<Outcome>();

  thread_.reset(QThread::create([wish = std::move(wish), outcome] {
    const model::Sample& sample = wish.experiment.samples[wish.sample];
    const auto load = [&] {
      outcome->cloud =
          std::make_shared<const PointCloud>(pointCloudOf(model::readMeasurements(wish.experiment, sample)));
    };
    outcome->error = errorOf(load, sample.measurements, "Please report it, with the file if you may.");
  }));
  connect(thread_.get(), &QThread::finished, this, [this, outcome] {
    thread_.release()->deleteLater();
    if (next_) {
      begin(*std::exchange(next_, std::nullopt));
    } else if (std::exchange(wanted_, false)) {
      if (outcome->cloud) {
        emit loaded(outcome->cloud);
      } else {
        emit failed(*outcome->error);
      }
    }
  });
  thread_->start();
}

}  // namespace desktop
